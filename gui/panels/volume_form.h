#pragma once

#include "gui/session/session.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <cstdint>
#include <memory>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace luxdeck::gui {

/// How an irradiance volume is built: where its vertices lie, how finely they look around, how exact; what that will take;
/// and the button. Begins with what the project's [[volume]] asks for.
class VolumeForm : public QWidget {
    Q_OBJECT

public:
    explicit VolumeForm(Session& session, QWidget* parent = nullptr);

    /// As the widgets say.
    [[nodiscard]] VolumeRequest request() const;

public slots:
    void start();

private:
    void layOut();
    void takeDefaults();
    void refresh();
    void estimate();

    Session& session_;
    std::shared_ptr<const LitProject> defaultsOf_;
    VolumeSettings base_;                  // what the widgets do not say: bounds, samplings
    QLineEdit* name_;
    std::array<QSpinBox*, 3> first_{};
    QSpinBox *second_, *side_, *samples_;
    QDoubleSpinBox *refine_, *target_, *time_;
    QComboBox* algorithm_;
    QLabel *estimate_, *state_;
    QPushButton *build_, *stop_;
    QProgressBar* bar_;
    QTimer soon_;
    std::uint64_t asked_ = 0;              // the last estimate that was asked for
};

}  // namespace luxdeck::gui

#pragma once

#include "gui/session/session.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QProgressBar;

namespace luxdeck::gui {

/// How the illuminance is computed: algorithm, how exact, how long; and the button.
class SolvePanel : public QWidget {
    Q_OBJECT

public:
    explicit SolvePanel(Session& session, QWidget* parent = nullptr);

    /// As the widgets say.
    [[nodiscard]] SolveSettings settings() const;

public slots:
    void start();

private:
    void refresh();
    void explain();

    Session& session_;
    QComboBox* algorithm_;
    QLabel *summary_, *state_;
    QDoubleSpinBox *target_, *time_;
    QCheckBox* layers_;
    QPushButton *solve_, *stop_;
    QProgressBar* bar_;
};

}  // namespace luxdeck::gui

#pragma once

#include "gui/session/session.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace luxdeck::gui {

/// What is compared: algorithms, on what, how long; and how far it has come.
class CompareControls : public QWidget {
    Q_OBJECT

public:
    explicit CompareControls(Session& session, QWidget* parent = nullptr);

    /// As the widgets say.
    [[nodiscard]] CompareSettings settings() const;

public slots:
    void start();

private:
    struct Named {
        std::string name;
        QCheckBox* box;
    };
    void addAlgorithms(QVBoxLayout* layout);
    void fillViews();
    void estimate();
    void refresh();

    Session& session_;
    std::vector<Named> algorithms_, views_;
    QVBoxLayout* subjects_;
    QCheckBox* grids_;
    QDoubleSpinBox *budget_, *known_, *picturesKnown_;
    QSpinBox *rungs_, *repetitions_;
    QLabel *estimate_, *state_;
    QPushButton *compare_, *stop_, *volumes_;
    QProgressBar* bar_;
};

}  // namespace luxdeck::gui

#pragma once

#include "gui/session/session.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTableWidget;
class QTabWidget;
class QVBoxLayout;

namespace luxdeck::gui {

class CompareControls;
class ErrorPlot;

/// Algorithms compared on the project: the curves of error against run time while they grow, who is first, and what each run
/// looks like and where it errs.
///
/// In the window: `new ComparePanel(session)` as a page of its own (it wants 900 x 560 or more).
class ComparePanel : public QWidget {
    Q_OBJECT

public:
    explicit ComparePanel(Session& session, QWidget* parent = nullptr);

public slots:
    /// Asks for a folder and writes figures, tables, plots and error pictures there.
    void saveAs();

signals:
    void failed(const QString& why);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeResults();
    void refresh();
    void fillSubjects();
    void fillOrder();
    void fillVolumes();
    void showRun();
    [[nodiscard]] std::string subject() const;

    Session& session_;
    CompareControls* controls_;
    QStackedWidget* stage_;
    QComboBox* subject_;
    QLabel *about_, *runTitle_;
    QPushButton* save_;
    ErrorPlot* plot_;
    QTabWidget* tables_;
    QTableWidget *order_, *volumes_;
    QWidget* run_;
    QVBoxLayout* pictures_;
    const RunPicture* seen_ = nullptr;   // the first of the pictures that are shown
};

}  // namespace luxdeck::gui

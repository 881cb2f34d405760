#pragma once

#include "gui/session/session.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTimer;
class QVBoxLayout;

namespace luxdeck::gui {

class PageView;

/// The report: what goes in on the left, its pages in the middle, export. What it writes is what `luxdeck report` writes.
///
/// In the window: `new ReportPanel(session)` as a page of its own (it wants 800 x 560 or more); exportTo() is what a menu calls.
class ReportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReportPanel(Session& session, QWidget* parent = nullptr);

    /// As the widgets say.
    [[nodiscard]] ReportChoice choice() const;

public slots:
    void make();
    /// Asks for a name and exports there.
    void exportTo();

signals:
    void failed(const QString& why);

private:
    struct Named {
        std::string name;
        QCheckBox* box;
    };
    QWidget* makeChoices();
    QWidget* makePreview();
    void fillViews();
    void changed();
    void refresh();
    void refreshPages();
    void askForPage();

    Session& session_;
    std::vector<Named> views_;
    QVBoxLayout* viewList_;
    QCheckBox *falseColour_, *grids_, *schedule_, *accuracy_, *method_, *comparison_;
    QDoubleSpinBox* viewTime_;
    QPushButton *make_, *stop_, *export_;
    QProgressBar* bar_;
    QLabel *state_, *about_;
    QStackedWidget* stage_;
    QListWidget* thumbnails_;
    PageView* page_;
    QTimer* sharpen_;
    const PageImages* shown_ = nullptr;  // whose thumbnails are listed
};

}  // namespace luxdeck::gui

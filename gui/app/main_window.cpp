#include "gui/app/main_window.h"

#include "gui/app/job_bar.h"
#include "gui/app/start_page.h"
#include "gui/panels/compare_panel.h"
#include "gui/panels/picture_panel.h"
#include "gui/panels/report_panel.h"
#include "gui/panels/show_panel.h"
#include "gui/panels/text.h"
#include "gui/panels/volume_panel.h"
#include "gui/session/edits.h"
#include "gui/view3d/view_area.h"

#include <QApplication>
#include <QCloseEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QTimer>

namespace luxdeck::gui {

namespace {
constexpr int kAutosaveMs = 20'000;
constexpr int kDeliverMs = 40;  // between what jobs say: every panel looks at it
}

MainWindow::MainWindow(Memory& memory, QWidget* parent)
    : QMainWindow(parent), memory_(memory),
      // From a job's thread: the event loop takes it from there.
      session_([this] {
          if (!woken_.exchange(true)) QMetaObject::invokeMethod(this, [this] { deliver(); }, Qt::QueuedConnection);
      }),
      pages_(new QStackedWidget(this)), start_(new StartPage(memory, this)), workspaces_(new QTabWidget(this)), room_(new QMainWindow(this, Qt::Widget)), probe_(new QLabel(this)) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    room_->setDockNestingEnabled(true);
    session_.setDisplay(memory_.display());
    makeWorkspaces();
    pages_->addWidget(start_);
    pages_->addWidget(workspaces_);
    setCentralWidget(pages_);
    makeDocks();
    makeMenus();
    statusBar()->addWidget(probe_, 1);
    statusBar()->addPermanentWidget(new JobBar(session_, this));

    connect(start_, &StartPage::chosen, this, &MainWindow::open);
    connect(start_, &StartPage::openWanted, this, &MainWindow::askToOpen);
    connect(start_, &StartPage::newWanted, this, &MainWindow::askForNew);
    session_.observe([this](Change change) { heard(change); });
    auto* autosave = new QTimer(this);
    connect(autosave, &QTimer::timeout, this, [this] { session_.autosave(); });
    autosave->start(kAutosaveMs);

    resize(1440, 900);
    restoreGeometry(memory_.geometry());
    room_->restoreState(memory_.docks());
    heard(Change::Project);
}

MainWindow::~MainWindow() = default;

/// The first at once; what comes hard upon it together.
void MainWindow::deliver() {
    const auto since = delivered_.isValid() ? delivered_.elapsed() : kDeliverMs;
    if (since < kDeliverMs) return QTimer::singleShot(static_cast<int>(kDeliverMs - since), this, &MainWindow::deliver);
    woken_ = false;
    session_.deliver();
    delivered_.start();
}

void MainWindow::makeWorkspaces() {
    workspaces_->setObjectName(QStringLiteral("workspaces"));
    workspaces_->setDocumentMode(true);
    views_ = new ViewArea(session_);
    picture_ = new PicturePanel(session_);
    picture_->setCamera([this] { return views_->cameraAsView("camera"); });
    room_->setCentralWidget(views_);
    workspaces_->addTab(room_, tr("Room"));
    compare_ = new ComparePanel(session_);
    report_ = new ReportPanel(session_);
    workspaces_->addTab(picture_, tr("Pictures"));
    workspaces_->addTab(compare_, tr("Compare"));
    workspaces_->addTab(report_, tr("Report"));
    connect(views_, &ViewArea::probed, probe_, &QLabel::setText);
    connect(views_, &ViewArea::activeChanged, this, [this](int index) {
        show_->setView(static_cast<std::size_t>(index));
        volume_->setView(static_cast<std::size_t>(index));
    });
    connect(views_, &ViewArea::objectDragged, this, [this](const QString& name, const Vec3d& moveM, double turnDeg, bool done) { drag(name.toStdString(), {moveM, turnDeg}, done); });
    connect(views_, &ViewArea::luminaireDragged, this, [this](int index, const Vec3d& moveM, bool done) {
        if (done && moveM != Vec3d(0, 0, 0)) change("Move luminaire", edits::changeLuminaires(session_.project(), {static_cast<std::size_t>(index)}, {.moveBy = moveM}));
    });
    const auto complain = [this](const QString& why) { session_.place.complain({ErrorCode::InvalidArgument, why.toStdString(), {}}); };
    connect(picture_, &PicturePanel::failed, this, complain);
    connect(compare_, &ComparePanel::failed, this, complain);
    connect(report_, &ReportPanel::failed, this, complain);
}

void MainWindow::heard(Change change) {
    switch (change) {
        case Change::Project:
            pages_->setCurrentWidget(session_.project() ? static_cast<QWidget*>(workspaces_) : start_);
            leaveOutWhatIsNotThere();
            [[fallthrough]];
        case Change::Document:
            refreshTitle();
            refreshCommands();
            break;
        case Change::Volumes: leaveOutWhatIsNotThere(); break;
        case Change::Display: memory_.keepDisplay(session_.display()); break;
        case Change::Log:
            // Not at once: what complained may still be in the middle of its work.
            QTimer::singleShot(0, this, &MainWindow::showErrors);
            break;
        default: break;
    }
}

void MainWindow::refreshTitle() {
    const auto& document = session_.document();
    if (document.file().empty()) {
        setWindowTitle(tr("Luxdeck"));
        setWindowModified(false);
        return;
    }
    const auto loaded = session_.project();
    const auto name = loaded ? qt(loaded->project.info.name) : QFileInfo(qt(document.file().string())).fileName();
    setWindowTitle(tr("%1[*] - Luxdeck").arg(name));
    setWindowFilePath(qt(document.file().string()));
    setWindowModified(session_.editable() && document.modified());
}

void MainWindow::showErrors() {
    const auto& log = session_.place.log();
    QStringList errors;
    for (; errorsSeen_ < log.size(); ++errorsSeen_)
        if (log[errorsSeen_].severity == Severity::Error) errors << qt(log[errorsSeen_].text);
    if (errors.isEmpty()) return;
    // A move that was refused: what was dragged stands where the project has it.
    if (session_.furnishing.object().empty()) views_->showSelectedAt();
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Luxdeck"), errors.join(QStringLiteral("\n\n")), QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("errorMessage"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box->open();
}

void MainWindow::showWorkspace(Workspace workspace) {
    if (static_cast<int>(workspace) < workspaces_->count()) workspaces_->setCurrentIndex(static_cast<int>(workspace));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!letGo()) return event->ignore();
    memory_.keepWindow(saveGeometry(), room_->saveState());
    session_.close();  // stops what runs
    event->accept();
}

}  // namespace luxdeck::gui

#include "gui/app/main_window.h"

#include "engine/core/file.h"
#include "gui/app/start_page.h"
#include "gui/panels/text.h"
#include "gui/session/new_project.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

/// What the window does with files: open, begin, save, recover, drop.
namespace luxdeck::gui {

namespace {
const char* const kProjects = QT_TR_NOOP("Projects and scenes (*.toml *.glb *.gltf *.obj *.rad)");
const char* const kModels = QT_TR_NOOP("Geometry (*.glb *.gltf *.obj)");
}  // namespace

void MainWindow::askToOpen() {
    const auto before = memory_.recent();
    const auto folder = before.isEmpty() ? QDir::homePath() : QFileInfo(before.front()).path();
    const auto file = QFileDialog::getOpenFileName(this, tr("Open a project"), folder, tr(kProjects));
    if (!file.isEmpty()) open(file);
}

void MainWindow::open(const QString& file) {
    const QFileInfo info(file);
    if (!info.exists()) {  // before changes are let go of: the project that is open stays
        memory_.forget(file);
        start_->refresh();
        session_.place.complain({ErrorCode::FileNotFound, "no such file", file.toStdString()});
        return;
    }
    if (!letGo()) return;
    const auto path = info.absoluteFilePath();
    memory_.opened(path);
    start_->refresh();
    recover(path);
}

void MainWindow::recover(const QString& file) {
    const auto kept = QFileInfo(file).suffix().toLower() == QLatin1String("toml") ? Document::open(file.toStdString()) : Result<Document>(Document());
    const auto text = kept ? kept->recoverable() : std::string();
    if (text.empty()) return session_.open(file.toStdString());
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes were kept"),
                    tr("Luxdeck ended before changes to \"%1\" were saved. They were kept.").arg(QFileInfo(file).fileName()), QMessageBox::NoButton, this);
    box.setObjectName(QStringLiteral("recoverQuestion"));
    box.setInformativeText(tr("Recovered changes can be undone after opening; the saved file stays as it is until you save."));
    auto* take = box.addButton(tr("Recover them"), QMessageBox::AcceptRole);
    auto* leave = box.addButton(tr("Open as saved"), QMessageBox::RejectRole);
    box.setDefaultButton(take);
    box.setEscapeButton(leave);
    box.exec();
    session_.open(file.toStdString(), box.clickedButton() == take ? text : std::string());
}

void MainWindow::askForNew() {
    const auto model = QFileDialog::getOpenFileName(this, tr("Geometry of the new project"), QDir::homePath(), tr(kModels));
    if (model.isEmpty()) return;
    const QFileInfo info(model);
    const auto file = QFileDialog::getSaveFileName(this, tr("Where the project goes"), info.dir().filePath(info.completeBaseName() + QStringLiteral(".toml")), tr("Projects (*.toml)"));
    if (file.isEmpty()) return;
    const std::filesystem::path path = file.toStdString();
    const auto text = firstProjectText(model.toStdString(), path.parent_path(), info.completeBaseName().toStdString());
    if (!text) return session_.place.complain(text.error());
    if (const auto written = writeFileAtomically(path, *text); !written) return session_.place.complain(written.error());
    open(file);
}

bool MainWindow::save() {
    if (!session_.editable()) return saveAs();
    const auto saved = session_.save();
    if (!saved) session_.place.complain(saved.error());
    return static_cast<bool>(saved);
}

bool MainWindow::saveAs() {
    const auto suggestion = qt(session_.document().file().string());
    const auto file = QFileDialog::getSaveFileName(this, tr("Save the project as"), suggestion, tr("Projects (*.toml)"));
    if (file.isEmpty()) return false;
    const auto saved = session_.saveAs(file.toStdString());
    if (!saved) session_.place.complain(saved.error());
    else memory_.opened(file);
    return static_cast<bool>(saved);
}

bool MainWindow::letGo() {
    if (!session_.editable() || !session_.document().modified()) return true;
    QMessageBox box(QMessageBox::Question, tr("Save changes?"), tr("\"%1\" has changes that are not saved.").arg(windowTitle().section(QStringLiteral("[*]"), 0, 0)),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("saveQuestion"));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) return save();
    if (answer == QMessageBox::Discard) session_.forget();
    return answer == QMessageBox::Discard;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const auto& url : event->mimeData()->urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    const bool project = QFileInfo(files.front()).suffix().toLower() == QLatin1String("toml");
    if (project || !session_.project()) open(files.front());
    else import(files);
}

}  // namespace luxdeck::gui

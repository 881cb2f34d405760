#include "gui/app/main_window.h"

#include "gui/panels/furniture_panel.h"
#include "gui/panels/import_dialog.h"
#include "gui/panels/text.h"
#include "gui/session/edits.h"
#include "gui/view3d/view_area.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>

/// Commands that change the project: what is selected, and what is added.
namespace luxdeck::gui {

namespace {

constexpr double kCopyShiftM = 0.5;    // of a duplicate beside its original
constexpr double kWorkplaneM = 0.75;

const char* const kImports = QT_TR_NOOP("Photometric files, geometry, volumes (*.ies *.ldt *.glb *.gltf *.obj *.vtu)");

}  // namespace

void MainWindow::change(const std::string& what, const Session::Edit& edit) {
    if (const auto done = session_.edit(what, edit); !done) session_.place.complain(done.error());
}

void MainWindow::drag(const std::string& object, const Pose& pose, bool done) {
    auto& hand = session_.furnishing;
    // In hand it stays in hand until it is left somewhere; otherwise letting go is the edit.
    if (hand.state() == Furnishing::State::Ready && hand.object() == object) return hand.moveTo(pose);
    if (done && !(pose == Pose{})) change("Move " + object, edits::moveObject(session_.project(), object, pose));
}

void MainWindow::selectionCommands(QMenu* menu) {
    command(menu, Needs::Editable, {"duplicate", "&Duplicate luminaire", "Ctrl+D", "A copy beside the selected luminaire"}, [this] {
        const auto& selection = session_.selection();
        if (selection.thing == Thing::Luminaire) change("Duplicate luminaire", edits::duplicateLuminaire(session_.project(), selection.index, Vec3d(kCopyShiftM, 0, 0)));
        else session_.place.note("Select a luminaire first: that is what can be duplicated.");
    });
    command(menu, Needs::Editable, {"remove", "Re&move", "Del", "Takes the selected luminaire, calculation surface or view out of the project"}, [this] { removeSelected(); });
    command(menu, Needs::Editable, {"switchSelected", "S&witch on or off", "Ctrl+K", "The selected luminaire, or all of the selected type"}, [this] { switchSelected(); });
    command(menu, Needs::Project, {"moveWithLight", "Move furniture with &light", "Ctrl+M", "Takes the selected furniture in hand: its illuminance follows"}, [this] {
        showDock(furnitureDock_);
        furniture_->begin();
    });
}

void MainWindow::removeSelected() {
    const auto selection = session_.selection();
    const auto project = session_.project();
    if (!project) return;
    switch (selection.thing) {
        case Thing::Luminaire:
            change("Remove " + project->project.scene.luminaires[selection.index].name, edits::removeLuminaires(project, {selection.index}));
            break;
        case Thing::Grid: change("Remove " + project->project.grids[selection.index].name, edits::removeGrid(selection.index)); break;
        case Thing::View: change("Remove view " + project->project.views[selection.index].name, edits::removeView(selection.index)); break;
        case Thing::Volume: session_.volumes.remove(selection.index); break;
        default: session_.place.note("Luminaires, calculation surfaces, views and volumes can be removed: select one first."); return;
    }
    session_.select({});
}

void MainWindow::switchSelected() {
    const auto selection = session_.selection();
    const auto project = session_.project();
    if (!project) return;
    std::vector<std::size_t> luminaires;
    if (selection.thing == Thing::Luminaire) luminaires = {selection.index};
    if (selection.thing == Thing::LuminaireType) luminaires = edits::luminairesOfType(project->project, selection.index);
    if (luminaires.empty()) return session_.place.note("Select a luminaire or a luminaire type first.");
    const auto& all = project->project.scene.luminaires;
    const bool on = std::none_of(luminaires.begin(), luminaires.end(), [&](std::size_t i) { return all[i].dimming > 0; });
    change(on ? "Switch on" : "Switch off", edits::switchLuminaires(project, luminaires, on));
}

void MainWindow::insertMenu() {
    auto* menu = menuBar()->addMenu(tr("&Insert"));
    command(menu, Needs::Editable, {"importFile", "&File…", "Ctrl+I", "Photometric files, geometry, furniture, volumes; dropping them on the window does the same"}, [this] {
        QStringList files = QFileDialog::getOpenFileNames(this, tr("Import"), QFileInfo(qt(session_.document().file().string())).path(), tr(kImports));
        if (!files.isEmpty()) import(files);
    });
    luminaireMenu_ = menu->addMenu(tr("&Luminaire"));
    connect(luminaireMenu_, &QMenu::aboutToShow, this, &MainWindow::luminaireMenu);
    command(menu, Needs::Editable, {"insertSurface", "&Calculation surface", "Ctrl+G", "A horizontal one over the whole room, 0.75 m above its floor; its properties change it"}, [this] { insertSurface(); });
    command(menu, Needs::Editable, {"insertView", "&View from here", "Ctrl+Shift+V", "The active view's camera, by a name"}, [this] {
        bool given = false;
        const auto name = QInputDialog::getText(this, tr("View from here"), tr("Name of the view"), QLineEdit::Normal, tr("view %1").arg(session_.project()->project.views.size() + 1), &given);
        if (given && !name.isEmpty()) change("Add view", edits::addView(session_.project(), views_->cameraAsView(name.toStdString())));
    });
}

void MainWindow::luminaireMenu() {
    luminaireMenu_->clear();
    const auto project = session_.project();
    if (!project || project->project.scene.luminaireTypes.empty()) {
        luminaireMenu_->addAction(tr("Import a photometric file first"))->setEnabled(false);
        return;
    }
    for (const auto& type : project->project.scene.luminaireTypes)
        luminaireMenu_->addAction(qt(type.id + "  " + type.description), this, [this, id = type.id] { insertLuminaire(id); })->setEnabled(session_.editable());
}

void MainWindow::insertLuminaire(const std::string& type) {
    // Beside one of its kind when one is selected, else in the middle of the ceiling.
    const auto& scene = session_.project()->project.scene;
    const auto box = scene.bounds();
    Vec3d position = box.isEmpty() ? Vec3d(0, 0, 0) : scene.toUser(Vec3(box.center().x, box.center().y, box.max.z - 0.05F));
    if (session_.selection().thing == Thing::Luminaire) position = scene.toUser(scene.luminaires[session_.selection().index].position) + Vec3d(kCopyShiftM, 0, 0);
    change("Add luminaire " + type, edits::addLuminaire(type, position));
}

void MainWindow::insertSurface() {
    const auto& project = session_.project()->project;
    const auto box = project.scene.bounds();
    if (box.isEmpty()) return session_.place.note("There is no geometry yet to lay a calculation surface in.");
    const auto low = project.scene.toUser(box.min), high = project.scene.toUser(box.max);
    edits::GridChange grid;
    std::string name = "Workplane";
    const auto taken = [&] { return std::any_of(project.grids.begin(), project.grids.end(), [&](const auto& g) { return g.name == name; }); };
    for (int i = 2; taken(); ++i) name = "Workplane " + std::to_string(i);
    grid.name = name;
    grid.origin = Vec3d(low.x, low.y, low.z + kWorkplaneM);
    grid.u = Vec3d(high.x - low.x, 0, 0);
    grid.v = Vec3d(0, high.y - low.y, 0);
    grid.borderM = std::min(0.5, 0.2 * std::min(high.x - low.x, high.y - low.y));
    change("Add calculation surface", edits::addGrid(grid));
}

void MainWindow::import(const QStringList& files) {
    std::vector<std::filesystem::path> paths;
    for (const auto& file : files) paths.emplace_back(file.toStdString());
    auto* dialog = new ImportDialog(session_, paths, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

}  // namespace luxdeck::gui

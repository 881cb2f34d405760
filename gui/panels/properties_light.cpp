// Forms of luminaires and their types.
#include "gui/panels/polar_widget.h"
#include "gui/panels/properties_panel.h"
#include "gui/panels/property_form.h"
#include "gui/panels/text.h"

#include <QFileDialog>
#include <QPushButton>

namespace luxdeck::gui {

namespace {

QString efficacyText(const LuminaireType& type) {
    if (!(type.watts > 0)) return QObject::tr("no power stated");
    return QObject::tr("%1 W, %2 lm/W").arg(type.watts, 0, 'f', 1).arg(type.photometry.table.lumens() / type.watts, 0, 'f', 0);
}

}  // namespace

PropertyForm* PropertiesPanel::luminaireForm(const Project& project, std::size_t index) {
    const auto& luminaire = project.scene.luminaires[index];
    const auto& type = project.scene.luminaireTypes[luminaire.type];
    auto* rows = form(qt(luminaire.name), tr("Luminaire"));
    const auto placed = edits::placedLuminaire(project, session_.document().text(), index);
    if (!placed) {
        rows->fact(tr("Type"), qt(type.id));
        rows->note(qt(placed.error().message));
        return rows;
    }
    const auto edit = [this, index, name = qt(luminaire.name)](const QString& what, const edits::LuminaireChange& wanted) {
        change(what.arg(name), edits::changeLuminaires(session_.project(), {index}, wanted));
    };
    rows->text({tr("Name"), "luminaireName"}, placed->name, [=](const std::string& v) { edits::LuminaireChange c; c.name = v; edit(tr("Rename %1"), c); });
    QStringList types;
    for (const auto& each : project.scene.luminaireTypes) types << qt(each.id);
    rows->choice({tr("Type"), "luminaireType"}, types, qt(placed->type), [=](const QString& v) { edits::LuminaireChange c; c.type = v.toStdString(); edit(tr("Change the type of %1"), c); });
    rows->place({tr("Position"), "luminairePosition"}, placed->position, [=](const Vec3d& v) { edits::LuminaireChange c; c.position = v; edit(tr("Move %1"), c); });
    rows->direction({tr("Aim"), "luminaireAim"}, placed->aim, [=](const Vec3d& v) { edits::LuminaireChange c; c.aim = v; edit(tr("Aim %1"), c); });
    rows->number({tr("Rotation"), "luminaireRotation"}, placed->rotationDeg, {-360, 360, 15, 1, QStringLiteral("°")}, [=](double v) { edits::LuminaireChange c; c.rotationDeg = v; edit(tr("Turn %1"), c); });
    rows->dimming(placed->dimming, [=](double v) { edits::LuminaireChange c; c.dimming = v; edit(v > 0 ? tr("Dim %1") : tr("Switch %1 off"), c); });
    rows->fact(tr("Flux"), tr("%1 lm").arg(type.photometry.table.lumens() * luminaire.outputScale(), 0, 'f', 0));
    rows->fact(tr("Power"), efficacyText(type));
    if (placed->inArray) rows->note(tr("One of a row: changed alone, the row's luminaires are written one by one."));
    rows->button({tr("Duplicate"), "duplicateLuminaire"}, tr("Adds another, half a metre beside"), [this, index, name = qt(luminaire.name)] { change(tr("Duplicate %1").arg(name), edits::duplicateLuminaire(session_.project(), index, {0.5, 0, 0})); });
    rows->button({tr("Remove"), "removeLuminaire"}, tr("Takes the luminaire out of the project"), [this, index, name = qt(luminaire.name)] { change(tr("Remove %1").arg(name), edits::removeLuminaires(session_.project(), {index})); });
    return rows;
}

PropertyForm* PropertiesPanel::typeForm(const Project& project, std::size_t index) {
    const auto& type = project.scene.luminaireTypes[index];
    const auto& photometry = type.photometry;
    auto* rows = form(qt(type.id), tr("Luminaire type"));
    if (!type.description.empty()) rows->note(qt(type.description));
    rows->fact(tr("File"), qt(type.file));
    rows->button({tr("Exchange photometric file…"), "exchangePhotometry"}, tr("Takes another IES or EULUMDAT file for all luminaires of this type; one from elsewhere is copied beside the project"), [this, index] {
        const auto file = QFileDialog::getOpenFileName(this, tr("Photometric file"), {}, tr("Photometric files (*.ies *.ldt *.IES *.LDT)"));
        if (!file.isEmpty()) exchange(index, file.toStdString());
    });
    rows->fact(tr("Flux"), photometry.lumensDeclared > 0 ? tr("%1 lm, declared %2 lm").arg(photometry.table.lumens(), 0, 'f', 0).arg(photometry.lumensDeclared, 0, 'f', 0)
                                                         : tr("%1 lm, none declared").arg(photometry.table.lumens(), 0, 'f', 0));
    rows->fact(tr("Power"), efficacyText(type));
    const auto all = edits::luminairesOfType(project, index);
    rows->fact(tr("Used"), all.size() == 1 ? tr("one luminaire") : tr("%1 luminaires").arg(all.size()));
    if (!all.empty()) {
        // Of all together: that of the first, where they differ.
        rows->dimming(project.scene.luminaires[all.front()].dimming, [this, all, id = qt(type.id)](double v) {
            edits::LuminaireChange wanted;
            wanted.dimming = v;
            change(tr("Dim all %1").arg(id), edits::changeLuminaires(session_.project(), all, wanted));
        });
    }
    rows->widget(new PolarWidget(photometry.table, rows));
    for (const auto& repair : photometry.repairs) rows->note(tr("Repaired: %1").arg(qt(repair)));
    for (const auto& warning : photometry.warnings) rows->note(tr("Warning: %1").arg(qt(warning)));
    return rows;
}

void PropertiesPanel::exchange(std::size_t type, const std::string& file) {
    const auto shown = session_.project();
    if (!shown || type >= shown->project.scene.luminaireTypes.size()) return;
    const auto placed = edits::photometryForProject(session_.document().file(), file);
    if (!placed) return say(qt(placed.error().text()));
    const auto& id = shown->project.scene.luminaireTypes[type].id;
    change(tr("Exchange the file of %1").arg(qt(id)), edits::exchangePhotometry(id, placed->shown));
    if (placed->copied) session_.place.note("The file was copied into the project's folder as " + placed->shown);
}

}  // namespace luxdeck::gui

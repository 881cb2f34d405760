// Forms of the project, its surfaces, views, objects, materials and volumes.
#include "gui/panels/properties_panel.h"
#include "gui/panels/property_form.h"
#include "gui/panels/text.h"

#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace luxdeck::gui {

namespace {

QString colourText(const Rgb& c) { return QStringLiteral("%1  %2  %3").arg(c.r, 0, 'f', 3).arg(c.g, 0, 'f', 3).arg(c.b, 0, 'f', 3); }

QString kindText(MaterialKind kind) {
    switch (kind) {
        case MaterialKind::Matte: return QObject::tr("Matte");
        case MaterialKind::Plastic: return QObject::tr("Plastic: matte under gloss");
        case MaterialKind::Metal: return QObject::tr("Metal");
        case MaterialKind::Mirror: return QObject::tr("Mirror");
        case MaterialKind::ThinGlass: return QObject::tr("Glass pane");
        case MaterialKind::MetallicRoughness: return QObject::tr("Metallic and rough");
        case MaterialKind::Ward: return QObject::tr("Gloss with a grain, or translucent");
        case MaterialKind::Dielectric: return QObject::tr("Solid glass");
        case MaterialKind::Mix: return QObject::tr("Mixture of two");
    }
    return {};
}

QString judged(const JudgedInterval& value, const QString& unit) {
    auto text = qt(intervalText(value.interval.value, value.interval.ci95)) + unit;
    if (value.required) text += QObject::tr(", %1%2 required: %3").arg(qt(numberText(*value.required)), unit, QString::fromUtf8(verdictText(value.verdict)));
    return text;
}

Vec3d pivotInUser(const Scene& scene, std::size_t object) {
    Box3d bounds;
    for (const auto& mesh : scene.meshes)
        if (mesh.object == object) bounds.extendBy(triangleBounds(mesh));
    return bounds.isEmpty() ? Vec3d(0, 0, 0) : pivotOf(bounds) + scene.origin;
}

}  // namespace

PropertyForm* PropertiesPanel::projectForm(const Project& project) {
    auto* rows = form(qt(project.info.name), tr("Project: what the report's cover says"));
    const auto field = [&](const QString& label, const char* name, const char* key, const std::string& value) {
        rows->text({label, name}, value, [this, label, key](const std::string& v) { change(tr("Change %1").arg(label.toLower()), edits::setInfo(key, v)); });
    };
    field(tr("Name"), "projectName", "name", project.info.name);
    field(tr("Client"), "projectClient", "client", project.info.client);
    field(tr("Designer"), "projectDesigner", "designer", project.info.designer);
    field(tr("Location"), "projectLocation", "location", project.info.location);
    field(tr("Date"), "projectDate", "date", project.info.date);
    rows->fact(tr("Contains"), tr("%1 triangles, %2 luminaires, %3 calculation surfaces").arg(project.scene.triangleCount()).arg(project.scene.luminaires.size()).arg(project.grids.size()));
    return rows;
}

PropertyForm* PropertiesPanel::gridForm(const Project& project, std::size_t index) {
    const auto& grid = project.grids[index];
    auto* rows = form(qt(grid.name), grid.kind == GridKind::Planar ? tr("Calculation surface") : tr("Calculation surface, cylindrical"));
    const auto edit = [this, index, name = qt(grid.name)](const edits::GridChange& wanted) { change(tr("Change %1").arg(name), edits::changeGrid(index, wanted)); };
    rows->text({tr("Name"), "gridName"}, grid.name, [=](const std::string& v) { edits::GridChange c; c.name = v; edit(c); });
    if (grid.points.empty()) {
        rows->place({tr("Corner"), "gridOrigin"}, grid.origin, [=](const Vec3d& v) { edits::GridChange c; c.origin = v; edit(c); });
        rows->place({tr("Edge u"), "gridU"}, grid.u, [=](const Vec3d& v) { edits::GridChange c; c.u = v; edit(c); });
        rows->place({tr("Edge v"), "gridV"}, grid.v, [=](const Vec3d& v) { edits::GridChange c; c.v = v; edit(c); });
        const auto& units = session_.display().units;
        PropertyForm::Range length;
        length.low = 0, length.high = 1000, length.unit = QString::fromUtf8(units.lengthUnit());
        length.least = grid.counts ? tr("%1 x %2 points").arg((*grid.counts)[0]).arg((*grid.counts)[1]) : tr("by EN 12464-1");
        rows->number({tr("Spacing"), "gridSpacing"}, units.lengthOf(grid.spacingM.value_or(0)), length, [=](double v) { edits::GridChange c; c.spacingM = units.metres(v); edit(c); });
    } else {
        rows->fact(tr("Points"), QString::number(grid.points.size()));
    }
    QStringList ids{tr("none")};
    for (const auto& id : edits::requirementIds(session_.document().text())) ids << qt(id);
    const auto now = edits::requirementId(session_.document().text(), index);
    rows->choice({tr("Requirement"), "gridRequirement"}, ids, now.empty() ? ids.front() : qt(now), [=](const QString& v) { edits::GridChange c; c.requirement = v == ids.front() ? "" : v.toStdString(); edit(c); });
    for (const auto& r : grid.requirements) rows->note(qt(r.source.empty() ? r.name : r.name + " (" + r.source + ")"));
    addResults(*rows, grid.name);
    rows->button({tr("Remove"), "removeGrid"}, tr("Takes the surface out of the project"), [this, index, name = qt(grid.name)] { change(tr("Remove %1").arg(name), edits::removeGrid(index)); });
    return rows;
}

void PropertiesPanel::addResults(PropertyForm& rows, const std::string& name) {
    const auto result = session_.solving.result();
    rows.heading(tr("Illuminance"));
    const auto at = result ? std::find_if(result->grids.begin(), result->grids.end(), [&](const GridResult& g) { return g.name == name; }) : std::vector<GridResult>::const_iterator();
    if (!result || at == result->grids.end()) {
        rows.note(tr("Not calculated yet."));
        return;
    }
    const auto& units = session_.display().units;
    const auto shown = [&](JudgedInterval v) {
        v.interval = {units.illuminance(v.interval.value), units.illuminance(v.interval.ci95)};
        if (v.required) v.required = units.illuminance(*v.required);
        return judged(v, QStringLiteral(" ") + QString::fromUtf8(units.illuminanceUnit()));
    };
    rows.fact(tr("Ēm"), shown(at->mean))->setObjectName(QStringLiteral("gridMean"));
    rows.fact(tr("Emin"), shown(at->minimum));
    rows.fact(tr("Uo"), judged(at->uniformity, {}));
    if (!session_.solving.current()) rows.note(tr("Of an earlier state of the project."));
}

PropertyForm* PropertiesPanel::viewForm(const Project& project, std::size_t index) {
    const auto& view = project.views[index];
    auto* rows = form(qt(view.name), view.kind == ViewKind::Fisheye ? tr("View, fisheye") : tr("View"));
    const auto edit = [this, index](const QString& what, const View& wanted) { change(what.arg(qt(wanted.name)), edits::changeView(index, wanted)); };
    rows->text({tr("Name"), "viewName"}, view.name, [this, index](const std::string& v) { change(tr("Rename view"), edits::renameView(index, v)); });
    rows->place({tr("Position"), "viewPosition"}, view.position, [=](const Vec3d& v) { auto w = view; w.position = v; edit(tr("Move view %1"), w); });
    rows->direction({tr("Direction"), "viewDirection"}, view.direction, [=](const Vec3d& v) { auto w = view; w.direction = v; edit(tr("Turn view %1"), w); });
    if (view.kind == ViewKind::Perspective)
        rows->number({tr("Angle of view"), "viewFov"}, view.verticalFovDeg, {0.1, 170, 1, 1, QStringLiteral("°")}, [=](double v) { auto w = view; w.verticalFovDeg = v; edit(tr("Change view %1"), w); });
    rows->fact(tr("Picture"), tr("%1 x %2 pixels").arg(view.width).arg(view.height));
    rows->button({tr("Remove"), "removeView"}, tr("Takes the view out of the project"), [this, index, name = qt(view.name)] { change(tr("Remove view %1").arg(name), edits::removeView(index)); });
    return rows;
}

PropertyForm* PropertiesPanel::objectForm(const Project& project, std::size_t index) {
    const auto& object = project.scene.objects[index];
    const auto pivot = pivotInUser(project.scene, index);
    auto* rows = form(qt(object.name), object.movable ? tr("Furniture") : tr("Part of the geometry"));
    rows->place({tr("Position"), "objectPosition"}, pivot, [this, pivot, name = object.name](const Vec3d& v) {
        change(tr("Move %1").arg(qt(name)), edits::moveObject(session_.project(), name, {v - pivot, 0}));
    });
    rows->number({tr("Turn by"), "objectTurn"}, 0, {-360, 360, 15, 1, QStringLiteral("°")}, [this, name = object.name](double v) {
        change(tr("Turn %1").arg(qt(name)), edits::moveObject(session_.project(), name, {{0, 0, 0}, v}));
    });
    rows->flag({tr("May be moved in the plan"), "objectMovable"}, object.movable, [this, name = object.name](bool v) {
        change(v ? tr("Make %1 movable").arg(qt(name)) : tr("Fix %1").arg(qt(name)), edits::setMovable(session_.project(), name, v));
    });
    if (object.movable) addFurnishing(*rows, object.name);
    return rows;
}

/// Where its light is from when it moves; all else of it is the furniture panel's.
void PropertiesPanel::addFurnishing(PropertyForm& rows, const std::string& object) {
    const auto& hand = session_.furnishing;
    rows.heading(tr("Light while it is moved"));
    if (hand.object() == object && hand.state() == Furnishing::State::Ready) {
        rows.note(qt(hand.statement(session_.display().units)))->setObjectName(QStringLiteral("furnitureStatement"));
        return;
    }
    auto* button = rows.button({tr("Move with light"), "moveWithLight"}, tr("Its illuminance then follows each move. The light of the room without it is calculated first, once"), [this, object] { session_.furnishing.begin(object); });
    button->setEnabled(hand.object() != object || hand.state() == Furnishing::State::Idle);
}

PropertyForm* PropertiesPanel::materialForm(const Project& project, std::size_t index) {
    const auto& material = project.scene.materials[index];
    auto* rows = form(qt(material.name), tr("Material"));
    rows->fact(tr("Kind"), kindText(material.kind));
    rows->fact(tr("Reflectance"), colourText(material.reflectance));
    rows->fact(tr("Specular"), colourText(material.specular));
    rows->fact(tr("Roughness"), QString::number(material.roughness, 'f', 2));
    if (material.kind == MaterialKind::ThinGlass) rows->fact(tr("Transmittance"), colourText(material.transmittance));
    return rows;
}

PropertyForm* PropertiesPanel::volumeForm(std::size_t index) {
    const auto& state = session_.volumes.all()[index];
    auto* rows = form(qt(state.name), state.without.empty() ? tr("Irradiance volume") : tr("Irradiance volume of the room without %1").arg(qt(state.without)));
    rows->fact(tr("Vertices"), QString::number(state.volume->quality.size()));
    rows->fact(tr("Bins"), tr("%1 at each").arg(state.volume->binCount()));
    rows->fact(tr("File"), state.file.empty() ? tr("not saved") : qt(state.file.filename().string()));
    if (!state.current) rows->note(tr("Of an earlier state of the project."));
    return rows;
}

}  // namespace luxdeck::gui

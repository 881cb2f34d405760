#include "gui/view3d/grid_layer.h"

#include "analysis/grids/grid_points.h"
#include "gui/session/surface_light.h"
#include "gui/view3d/section_plane.h"

#include <algorithm>
#include <cmath>

#include <vtkProperty.h>

namespace luxdeck::gui {

namespace {

constexpr double kFaded = 0.35;        // surfaces beside the selected one
constexpr double kPointM = 0.06;      // radius of a point shown by itself

QString qt(const std::string& text) { return QString::fromStdString(text); }

bool isField(const GridResult& grid) { return grid.columns > 0 && grid.rows > 0 && grid.kind == GridKind::Planar; }

/// The verdict on a surface: the worst of its statistics.
Verdict verdictOf(const GridResult& grid) {
    Verdict worst = Verdict::None;
    for (const auto& judged : {grid.mean, grid.minimum, grid.uniformity}) {
        if (judged.verdict == Verdict::NotMet) return Verdict::NotMet;
        if (judged.verdict == Verdict::Undecided || worst == Verdict::None) worst = judged.verdict == Verdict::None ? worst : judged.verdict;
    }
    return worst;
}

Layer::Range rangeOf(const SolveResult& result, LightPart part) {
    Layer::Range range{1e300, -1e300};
    for (const auto& grid : result.grids)
        for (const auto& point : grid.points) {
            const double lux = lightOf(point, part).value;
            if (std::isfinite(lux)) range = {std::min(range.low, lux), std::max(range.high, lux)};
        }
    return range;
}

}  // namespace

/// One mesh with how it is drawn.
struct GridLayer::Surface {
    enum class Role { Field, Lines, Outline, Points } role = Role::Field;
    bool strong = false, faded = false;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
};

GridLayer::GridLayer(vtkRenderer& renderer, const SharedScene& shared) : renderer_(renderer), shared_(shared) {}

GridLayer::~GridLayer() = default;

Layer::Range GridLayer::lightRange(const Session& session, const ViewSettings& view) {
    const auto result = session.solving.result();
    if (!view.grids || !result) return {};
    return rangeOf(*result, view.part);
}

bool GridLayer::update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) {
    const auto& picked = session.selection();
    MadeFrom now{shared_.project, session.solving.result(), session.solving.current(), scale, session.display().units, view, {}};
    if (picked.thing == Thing::Grid) now.selected = picked.index;
    if (now == from_) return false;
    from_ = now;
    rebuild();
    return true;
}

void GridLayer::clear() {
    for (const auto& surface : surfaces_) renderer_.RemoveActor(surface->actor);
    surfaces_.clear();
    texts_.clear();
}

void GridLayer::rebuild() {
    clear();
    if (!from_.project || !from_.view.grids) return;
    const LightColours colours(from_.scale);
    // The result of a project with other surfaces has no place in this one.
    if (from_.result && from_.result->grids.size() == from_.project->project.grids.size())
        addResults(colours);
    else
        addOutlines();
    restyle();
}

GridLayer::Surface& GridLayer::newSurface() {
    auto& surface = *surfaces_.emplace_back(std::make_unique<Surface>());
    surface.actor->SetMapper(surface.mapper);
    surface.actor->GetProperty()->LightingOff();
    surface.mapper->ScalarVisibilityOff();
    if (from_.view.section.on) {
        placeSection(*section_, from_.view.section, shared_.parts->sceneBounds());
        surface.mapper->AddClippingPlane(section_);
    }
    renderer_.AddActor(surface.actor);
    return surface;
}

void GridLayer::addResults(const LightColours& colours) {
    std::vector<PointSet> sets;
    for (std::size_t i = 0; i < from_.result->grids.size(); ++i) {
        const auto& grid = from_.result->grids[i];
        if (isField(grid)) {
            addSurface(grid, i, colours);
        } else {
            PointSet set{grid.kind, {}, {}, valuesOf(grid, from_.view.part), kPointM};
            for (const auto& point : grid.points) {
                set.points.push_back(rebased(point.position));
                set.normals.push_back(point.normal);
            }
            sets.push_back(std::move(set));
        }
        if (from_.view.values) addValues(grid, i, colours);
        if (from_.view.verdicts) addTitle(grid, i);
    }
    addPoints(sets, colours);
}

void GridLayer::addSurface(const GridResult& grid, std::size_t index, const LightColours& colours) {
    const SurfaceFrame frame{rebased(grid.origin), grid.u, grid.v};
    const auto values = valuesOf(grid, from_.view.part);
    const bool faded = from_.selected && !chosen(index);
    auto& field = newSurface();
    field.faded = faded;
    field.mapper->SetInputData(surfaceQuad(frame));
    vtkNew<vtkTexture> texture;
    texture->SetInputData(fieldTexture(values, grid.columns, grid.rows, colours, !from_.current));
    texture->InterpolateOn();
    field.actor->SetTexture(texture);

    auto& outline = newSurface();
    outline.role = Surface::Role::Outline;
    outline.strong = chosen(index);
    outline.mapper->SetInputData(surfaceOutline(frame));
    if (!from_.view.isolines || faded) return;

    std::vector<LevelMark> marks;
    auto& lines = newSurface();
    lines.role = Surface::Role::Lines;
    lines.mapper->SetInputData(isolineShapes(values, grid.columns, grid.rows, frame, colours, from_.units, marks));
    for (const auto& mark : marks) {
        Annotation text;
        text.kind = Annotation::Kind::Isoline;
        text.at = mark.at;
        text.text = qt(numberText(from_.units.illuminance(mark.lux)));
        text.ground = QColor(shownColour(colours.colour(mark.lux), !from_.current));
        texts_.push_back(text);
    }
}

/// Before the first solve: where the surfaces are, and their points.
void GridLayer::addOutlines() {
    std::vector<PointSet> sets;
    for (std::size_t i = 0; i < from_.project->project.grids.size(); ++i) {
        const auto& grid = from_.project->project.grids[i];
        const auto layout = layOut(grid);
        if (!layout) continue;
        PointSet set{grid.kind, {}, layout->normals, {}, 0.5 * kPointM};
        for (const auto& point : layout->points) set.points.push_back(rebased(point));
        sets.push_back(std::move(set));
        if (layout->columns == 0) continue;
        auto& outline = newSurface();
        outline.role = Surface::Role::Outline;
        outline.strong = chosen(i);
        outline.mapper->SetInputData(surfaceOutline({rebased(layout->origin), layout->u, layout->v}));
    }
    addPoints(sets, LightColours(from_.scale));
}

void GridLayer::addPoints(const std::vector<PointSet>& sets, const LightColours& colours) {
    if (sets.empty()) return;
    auto& points = newSurface();
    points.role = Surface::Role::Points;
    points.mapper->SetInputData(pointShapes(sets, colours, !from_.current));
}

void GridLayer::addValues(const GridResult& grid, std::size_t index, const LightColours& colours) {
    if (from_.selected && !chosen(index)) return;
    for (const auto& point : grid.points) {
        const auto light = lightOf(point, from_.view.part);
        Annotation text;
        text.at = rebased(point.position);
        const double shown = from_.units.illuminance(light.value);
        text.text = qt(from_.view.intervals ? intervalText(shown, from_.units.illuminance(light.ci95)) : numberText(shown));
        if (isField(grid)) text.ground = QColor(shownColour(colours.colour(light.value), !from_.current));
        text.old = !from_.current;
        texts_.push_back(text);
    }
}

void GridLayer::addTitle(const GridResult& grid, std::size_t index) {
    if (grid.points.empty()) return;
    Annotation title;
    title.kind = Annotation::Kind::Surface;
    title.at = rebased(grid.columns > 0 ? grid.origin + grid.u * 0.5 + grid.v : grid.points.front().position);
    title.text = qt(grid.name);
    const auto& mean = grid.mean.interval;
    title.brief = qt(from_.units.illuminanceText(mean.value));
    title.detail = QStringLiteral("Ēm ") + title.brief;
    if (from_.view.intervals) title.detail = QStringLiteral("Ēm %1 %2").arg(qt(intervalText(from_.units.illuminance(mean.value), from_.units.illuminance(mean.ci95))), QString::fromUtf8(from_.units.illuminanceUnit()));
    if (std::isfinite(grid.uniformity.interval.value)) title.detail += QStringLiteral("  Uo %1").arg(grid.uniformity.interval.value, 0, 'f', 2);
    if (!from_.current) title.detail += QStringLiteral("  ·  old");
    else if (!from_.result->complete) title.detail += QStringLiteral("  …");
    title.verdict = from_.current ? verdictOf(grid) : Verdict::None;
    title.strong = chosen(index);
    title.old = !from_.current;
    texts_.push_back(title);
}

void GridLayer::restyle() {
    const auto ink = rgbOf(colours_.ink), accent = rgbOf(colours_.accent);
    for (const auto& surface : surfaces_) {
        auto& property = *surface->actor->GetProperty();
        switch (surface->role) {
            case Surface::Role::Field: property.SetOpacity(surface->faded ? kFaded : 1); break;
            case Surface::Role::Outline: {
                const auto& colour = surface->strong ? accent : ink;
                property.SetColor(colour[0], colour[1], colour[2]);
                property.SetLineWidth(surface->strong ? 3.0F : 1.2F);
                property.SetOpacity(surface->strong ? 1 : 0.75);
                break;
            }
            case Surface::Role::Lines: property.SetLineWidth(1.6F); [[fallthrough]];
            case Surface::Role::Points:
                surface->mapper->ScalarVisibilityOn();
                surface->mapper->SetScalarModeToUsePointFieldData();
                surface->mapper->SelectColorArray("colours");
                surface->mapper->SetColorModeToDirectScalars();
                break;
        }
        if (surface->role != Surface::Role::Lines) continue;
        surface->mapper->SetResolveCoincidentTopologyToPolygonOffset();
        surface->mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
    }
}

void GridLayer::setColours(const ViewColours& colours) {
    colours_ = colours;
    restyle();
}

}  // namespace luxdeck::gui

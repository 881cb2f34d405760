#include "gui/view3d/lattice_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>

namespace luxdeck::gui {

namespace {

/// Corners of a cell (x fastest) that its twelve edges join.
constexpr std::array<std::array<std::size_t, 2>, 12> kEdges{{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// Edges of the first level's cells, or of all that divisions made; what cells share is there once.
vtkSmartPointer<vtkPolyData> edges(const Lattice& lattice, bool firstLevel) {
    vtkNew<vtkPoints> points;
    for (const auto& v : lattice.vertices()) points->InsertNextPoint(v.x, v.y, v.z);
    vtkNew<vtkCellArray> lines;
    std::unordered_set<std::uint64_t> drawn;
    for (std::uint32_t cell = 0; cell < lattice.cells().size(); ++cell) {
        if ((lattice.levelOf(cell) == 0) != firstLevel) continue;
        const auto& corners = lattice.cells()[cell].vertices;
        for (const auto& [from, to] : kEdges) {
            const vtkIdType ends[2] = {corners[from], corners[to]};
            if (drawn.insert((std::uint64_t{corners[from]} << 32U) | corners[to]).second) lines->InsertNextCell(2, ends);
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
}

void dress(vtkActor& actor, double r, double g, double b, double opacity) {
    vtkNew<vtkPolyDataMapper> mapper;
    actor.SetMapper(mapper);
    actor.PickableOff();
    actor.VisibilityOff();
    actor.GetProperty()->LightingOff();
    actor.GetProperty()->SetColor(r, g, b);
    actor.GetProperty()->SetOpacity(opacity);
}

}  // namespace

LatticeLayer::LatticeLayer(vtkRenderer& renderer) : renderer_(renderer) {
    dress(*first_, 0.35, 0.52, 0.68, 0.85);
    dress(*second_, 0.76, 0.55, 0.33, 0.4);
    for (vtkActor* actor : {first_.Get(), second_.Get()}) renderer_.AddActor(actor);
}

LatticeLayer::~LatticeLayer() {
    for (vtkActor* actor : {first_.Get(), second_.Get()}) renderer_.RemoveActor(actor);
}

bool LatticeLayer::update(const Session& session, const ViewSettings& view, const ResolvedScale&) {
    const VolumeState* state = view.firstLevelGrid || view.secondLevelGrid ? session.volumes.named(view.volume) : nullptr;
    bool changed = false;
    if (state != nullptr && state->volume != drawn_) {
        drawn_ = state->volume;
        vtkPolyDataMapper::SafeDownCast(first_->GetMapper())->SetInputData(edges(drawn_->lattice, true));
        vtkPolyDataMapper::SafeDownCast(second_->GetMapper())->SetInputData(edges(drawn_->lattice, false));
        changed = true;
    }
    const auto show = [&](vtkActor& actor, bool visible) {
        changed = changed || (actor.GetVisibility() != 0) != visible;
        actor.SetVisibility(visible);
    };
    show(*first_, state != nullptr && view.firstLevelGrid);
    show(*second_, state != nullptr && view.secondLevelGrid);
    return changed;
}

}  // namespace luxdeck::gui

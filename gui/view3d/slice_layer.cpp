#include "gui/view3d/slice_layer.h"

#include "gui/session/scene_pick.h"
#include "gui/view3d/grid_shapes.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace luxdeck::gui {

namespace {

constexpr double kPlaneSamples = 16000, kRoomSamples = 120000;
constexpr float kFinestM = 0.05F;

/// Samples along `axes` (unit) that fill the bounds, about so many, their middles a step apart. A plane where the third
/// axis has no extent.
SampleGrid filling(const Box3& bounds, const std::array<Vec3, 3>& axes, const Vec3& through, bool plane) {
    std::array<float, 3> low{}, extent{};
    for (std::size_t i = 0; i < 3; ++i) {
        float reach = 0;
        for (int axis = 0; axis < 3; ++axis) reach += std::fabs(axes[i][axis]) * bounds.size()[axis] / 2;
        low[i] = dot(bounds.center(), axes[i]) - reach, extent[i] = 2 * reach;
    }
    if (plane) low[2] = dot(through, axes[2]), extent[2] = 0;
    const double step = plane ? std::sqrt(extent[0] * extent[1] / kPlaneSamples) : std::cbrt(double{extent[0]} * extent[1] * extent[2] / kRoomSamples);
    SampleGrid grid;
    grid.origin = axes[0] * low[0] + axes[1] * low[1] + axes[2] * low[2];
    for (std::size_t i = 0; i < 3; ++i) {
        const float wanted = std::max(static_cast<float>(step), kFinestM);
        const int cells = std::max(static_cast<int>(std::ceil(extent[i] / wanted)), plane && i == 2 ? 0 : 1);
        grid.counts[i] = cells + 1;
        grid.steps[i] = axes[i] * (cells > 0 ? extent[i] / static_cast<float>(cells) : 1.0F);
    }
    return grid;
}

SampleGrid planeOf(const CutPlane& slice, const Box3& scene, const Box3& volume) {
    const Frame frame = Frame::about(Vec3(slice.normal));
    return filling(volume, {frame.tangent, frame.bitangent, frame.normal}, Vec3(sectionPoint(slice, scene)), true);
}

SampleGrid roomOf(const Box3& volume) { return filling(volume, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {}, false); }

void dress(vtkRenderer& renderer, vtkActor& actor) {
    vtkNew<vtkPolyDataMapper> mapper;
    actor.SetMapper(mapper);
    actor.PickableOff();
    actor.VisibilityOff();
    renderer.AddActor(&actor);
}

vtkPolyDataMapper& mapperOf(vtkActor& actor) { return *vtkPolyDataMapper::SafeDownCast(actor.GetMapper()); }

}  // namespace

SliceLayer::SliceLayer(vtkRenderer& renderer) : renderer_(renderer) {
    for (vtkActor* actor : {plane_.Get(), lines_.Get(), isosurface_.Get()}) dress(renderer_, *actor);
    plane_->GetProperty()->LightingOff();
    lines_->GetProperty()->LightingOff();
    lines_->GetProperty()->SetLineWidth(1.5);
    mapperOf(*lines_).SetScalarModeToUsePointFieldData();
    mapperOf(*lines_).SelectColorArray("colours");
    mapperOf(*lines_).SetColorModeToDirectScalars();
    mapperOf(*lines_).SetResolveCoincidentTopologyToPolygonOffset();
    mapperOf(*lines_).SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
    mapperOf(*isosurface_).ScalarVisibilityOff();
    isosurface_->GetProperty()->SetAmbient(0.45);
    isosurface_->GetProperty()->SetDiffuse(0.6);
}

SliceLayer::~SliceLayer() {
    for (vtkActor* actor : {plane_.Get(), lines_.Get(), isosurface_.Get()}) renderer_.RemoveActor(actor);
}

/// What is to be shown; what was shown before stays until that is there.
void SliceLayer::take(const Session& session, const ViewSettings& view) {
    const VolumeState* state = view.slice.on || view.isosurface ? session.volumes.named(view.volume) : nullptr;
    if (state == nullptr || !view.slice.on) wantedPlane_.reset();
    if (state == nullptr || !view.isosurface) wantedRoom_.reset();
    if (state == nullptr) return;
    const Box3& volume = state->volume->lattice.bounds();
    const Box3 scene = session.project() ? session.project()->project.scene.bounds() : volume;
    const Vec3 facing(view.sliceFacing);
    if (view.slice.on)
        if (auto made = session.volumeLight.samples(*state, view.part, planeOf(view.slice, scene, volume), facing)) wantedPlane_ = std::move(made);
    if (view.isosurface)
        if (auto made = session.volumeLight.samples(*state, view.part, roomOf(volume), facing)) wantedRoom_ = std::move(made);
}

Layer::Range SliceLayer::lightRange(const Session& session, const ViewSettings& view) {
    take(session, view);
    if (!wantedPlane_) return wantedRoom_ ? Range{0, 2 * view.isosurfaceLux} : Range{};  // in the middle of the scale
    if (rangeOf_ != wantedPlane_) {
        std::vector<float> known;
        for (const float lux : wantedPlane_->lux)
            if (std::isfinite(lux)) known.push_back(lux);
        std::sort(known.begin(), known.end());
        // Beside a lamp there is more light than the scale is for.
        planeRange_ = known.empty() ? Range{} : Range{known.front(), known[(known.size() - 1) * 199 / 200]};
        rangeOf_ = wantedPlane_;
    }
    return planeRange_;
}

bool SliceLayer::update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) {
    take(session, view);
    const MadeFrom from{wantedPlane_, wantedRoom_, scale, session.display().units, view.isolines, view.isosurfaceLux};
    if (from == from_) return false;
    from_ = from;
    const LightColours colours(scale);
    levels_.clear();
    plane_->SetVisibility(from_.plane != nullptr);
    lines_->SetVisibility(from_.plane && from_.isolines);
    isosurface_->SetVisibility(from_.room != nullptr);
    if (from_.plane) drawPlane(colours);
    if (from_.plane && from_.isolines) drawLines(colours);
    if (from_.room) drawIsosurface(colours);
    return true;
}

/// Squares between samples of which all four corners are known.
void SliceLayer::drawPlane(const LightColours& colours) {
    const auto& [grid, facing, lux] = *from_.plane;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> values;
    for (int y = 0; y < grid.counts[1]; ++y)
        for (int x = 0; x < grid.counts[0]; ++x) {
            const Vec3 p = grid.at(x, y, 0);
            points->InsertNextPoint(p.x, p.y, p.z);
            values->InsertNextValue(lux[static_cast<std::size_t>(y) * grid.counts[0] + x]);
        }
    vtkNew<vtkCellArray> squares;
    for (int y = 0; y + 1 < grid.counts[1]; ++y)
        for (int x = 0; x + 1 < grid.counts[0]; ++x) {
            const vtkIdType first = static_cast<vtkIdType>(y) * grid.counts[0] + x;
            const vtkIdType corners[4] = {first, first + 1, first + 1 + grid.counts[0], first + grid.counts[0]};
            const bool known = std::all_of(std::begin(corners), std::end(corners), [&lux = lux](vtkIdType c) { return std::isfinite(lux[static_cast<std::size_t>(c)]); });
            if (known) squares->InsertNextCell(4, corners);
        }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(squares);
    data->GetPointData()->SetScalars(values);
    auto& mapper = mapperOf(*plane_);
    mapper.SetInputData(data);
    mapper.SetLookupTable(colours.table());
    mapper.UseLookupTableScalarRangeOn();
    mapper.InterpolateScalarsBeforeMappingOn();
}

void SliceLayer::drawLines(const LightColours& colours) {
    const auto& [grid, facing, lux] = *from_.plane;
    // Where the scale has ended all colours are the same: no lines either.
    std::vector<double> values;
    for (const float value : lux) values.push_back(std::min<double>(value, from_.scale.high));
    const SurfaceFrame frame{Vec3d(grid.origin - (grid.steps[0] + grid.steps[1]) * 0.5F), Vec3d(grid.steps[0]) * grid.counts[0], Vec3d(grid.steps[1]) * grid.counts[1]};
    std::vector<LevelMark> marks;
    mapperOf(*lines_).SetInputData(isolineShapes(values, grid.counts[0], grid.counts[1], frame, colours, from_.units, marks));
    for (const auto& mark : marks) {
        Annotation text;
        text.kind = Annotation::Kind::Isoline;
        text.at = mark.at;
        text.text = QString::fromStdString(numberText(from_.units.illuminance(mark.lux)));
        text.ground = QColor(shownColour(colours.colour(mark.lux), false));
        levels_.push_back(text);
    }
}

void SliceLayer::drawIsosurface(const LightColours& colours) {
    const auto& [grid, facing, lux] = *from_.room;
    vtkNew<vtkImageData> image;
    image->SetDimensions(grid.counts[0], grid.counts[1], grid.counts[2]);
    image->SetOrigin(grid.origin.x, grid.origin.y, grid.origin.z);
    image->SetSpacing(grid.steps[0].x, grid.steps[1].y, grid.steps[2].z);
    image->AllocateScalars(VTK_FLOAT, 1);
    std::copy(lux.begin(), lux.end(), static_cast<float*>(image->GetScalarPointer()));
    vtkNew<vtkFlyingEdges3D> surface;
    surface->SetInputData(image);
    surface->SetValue(0, from_.isosurfaceLux);
    surface->ComputeScalarsOff();
    surface->Update();
    // Between the known and the unknown there is no surface: its points are not numbers.
    auto* found = surface->GetOutput();
    vtkNew<vtkCellArray> triangles;
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    for (found->GetPolys()->InitTraversal(); found->GetPolys()->GetNextCell(count, corners) != 0;) {
        const bool known = std::all_of(corners, corners + count, [&](vtkIdType c) {
            const double* p = found->GetPoint(c);
            return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
        });
        if (known) triangles->InsertNextCell(count, corners);
    }
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
        if (const double* p = found->GetPoint(i); !std::isfinite(p[0] + p[1] + p[2])) found->GetPoints()->SetPoint(i, image->GetOrigin());
    found->SetPolys(triangles);
    mapperOf(*isosurface_).SetInputData(found);
    const auto colour = colours.colour(from_.isosurfaceLux);
    isosurface_->GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

}  // namespace luxdeck::gui

#include "gui/view3d/furniture_layer.h"

#include <algorithm>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace luxdeck::gui {

namespace {

std::vector<float> luxOf(const FurnitureLighting& lighting) {
    std::vector<float> lux;
    lux.reserve(lighting.lux().size());
    for (const auto& rgb : lighting.lux()) lux.push_back(luminance(rgb));
    return lux;
}

/// From the object's own frame to the scene.
vtkSmartPointer<vtkMatrix4x4> matrixOf(const Placement& place) {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    for (int column = 0; column < 3; ++column) {
        Vec3 axis(0, 0, 0);
        axis[column] = 1;
        const Vec3 d = place.direction(axis);
        for (int row = 0; row < 3; ++row) matrix->SetElement(row, column, d[row]);
    }
    for (int row = 0; row < 3; ++row) matrix->SetElement(row, 3, place.shift[row]);
    return matrix;
}

bool same(const Placement& a, const Placement& b) { return a.cosine == b.cosine && a.sine == b.sine && a.shift == b.shift; }

}  // namespace

FurnitureLayer::FurnitureLayer(vtkRenderer& renderer) : renderer_(renderer) {
    mapper_->SetInputData(mesh_);
    mapper_->SetScalarModeToUsePointData();
    mapper_->SetColorModeToDirectScalars();
    actor_->SetMapper(mapper_);
    actor_->GetProperty()->LightingOff();
    actor_->VisibilityOff();
    renderer_.AddActor(actor_);
}

FurnitureLayer::~FurnitureLayer() { renderer_.RemoveActor(actor_); }

void FurnitureLayer::take(const MovableObject& object) {
    vtkNew<vtkPoints> points;
    for (const auto& p : object.positions) points->InsertNextPoint(p.x, p.y, p.z);
    vtkNew<vtkCellArray> faces;
    for (const auto& t : object.triangles) {
        const vtkIdType corners[3] = {t[0], t[1], t[2]};
        faces->InsertNextCell(3, corners);
    }
    mesh_->SetPoints(points);
    mesh_->SetPolys(faces);
    lux_.clear();
}

Layer::Range FurnitureLayer::lightRange(const Session& session, const ViewSettings& view) {
    const auto* lighting = session.furnishing.lighting();
    if (lighting == nullptr || !view.grids) return {};
    Range range{1e300, -1e300};
    for (const float lux : luxOf(*lighting))
        if (std::isfinite(lux)) range = {std::min(range.low, double{lux}), std::max(range.high, double{lux})};
    return range;
}

bool FurnitureLayer::update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) {
    const auto* lighting = session.furnishing.lighting();
    const bool wanted = lighting != nullptr && view.grids && view.surfaces != SurfaceLook::Hidden;
    const bool changed = wanted != shown();
    actor_->SetVisibility(wanted ? 1 : 0);
    if (!wanted) return changed;
    if (lighting != of_) take(lighting->object());
    auto lux = luxOf(*lighting);
    if (!changed && lighting == of_ && lux == lux_ && scale == scale_ && same(lighting->placement(), place_)) return false;
    of_ = lighting;
    lux_ = std::move(lux);
    scale_ = scale;
    place_ = lighting->placement();
    const LightColours colours(scale);
    vtkNew<vtkUnsignedCharArray> shades;
    shades->SetNumberOfComponents(3);
    shades->SetNumberOfTuples(static_cast<vtkIdType>(lux_.size()));
    for (std::size_t i = 0; i < lux_.size(); ++i) {
        const auto colour = std::isfinite(lux_[i]) ? colours.colour(double{lux_[i]}) : tonemap::Colour8{128, 128, 128};
        shades->SetTypedTuple(static_cast<vtkIdType>(i), colour.data());
    }
    mesh_->GetPointData()->SetScalars(shades);
    mesh_->Modified();
    actor_->SetUserMatrix(matrixOf(place_));
    return true;
}

}  // namespace luxdeck::gui

#include "gui/view3d/glyph_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace luxdeck::gui {

namespace {

constexpr double kCrossArmM = 0.025;
constexpr double kCrossGrey[3] = {0.55, 0.56, 0.58};  // seen on light and on dark

}  // namespace

GlyphLayer::GlyphLayer(vtkRenderer& renderer) : renderer_(renderer), glyphs_(renderer) {
    vtkNew<vtkPolyDataMapper> mapper;
    crosses_->SetMapper(mapper);
    crosses_->PickableOff();
    crosses_->VisibilityOff();
    crosses_->GetProperty()->LightingOff();
    crosses_->GetProperty()->SetColor(kCrossGrey[0], kCrossGrey[1], kCrossGrey[2]);
    renderer_.AddActor(crosses_);
}

GlyphLayer::~GlyphLayer() { renderer_.RemoveActor(crosses_); }

/// What is to be shown; what was shown before stays until that is there.
void GlyphLayer::take(const Session& session, const ViewSettings& view) {
    const VolumeState* state = view.glyphs ? session.volumes.named(view.volume) : nullptr;
    if (state == nullptr) return wanted_.reset();
    if (auto made = session.volumeLight.spheres(*state, view.part, view.order)) wanted_ = std::move(made);
}

Layer::Range GlyphLayer::lightRange(const Session& session, const ViewSettings& view) {
    take(session, view);
    return wanted_ ? Range{wanted_->low, wanted_->high} : Range{};
}

bool GlyphLayer::update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) {
    take(session, view);
    const bool visible = wanted_ != nullptr;
    bool changed = visible != visible_;
    visible_ = visible;
    if (visible && (wanted_ != coloured_ || scale != scale_)) {
        if (wanted_->volume != placed_) glyphs_.place(*wanted_->volume), markUnusable(*wanted_->volume);
        glyphs_.colour(*wanted_, LightColours(scale));
        placed_ = wanted_->volume, coloured_ = wanted_, scale_ = scale;
        changed = true;
    }
    if (view.glyphRadiusM != radiusM_) {
        glyphs_.setRadius(radiusM_ = view.glyphRadiusM);
        changed = changed || visible;
    }
    glyphs_.setVisible(visible);
    crosses_->SetVisibility(visible);
    return changed;
}

void GlyphLayer::markUnusable(const IrradianceVolume& volume) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (std::size_t v = 0; v < volume.vertexCount(); ++v) {
        if (volume.quality[v].usable()) continue;
        const Vec3d at(volume.lattice.vertices()[v]);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3d arm(0);
            arm[axis] = kCrossArmM;
            const auto low = at - arm, high = at + arm;
            const vtkIdType ends[2] = {points->InsertNextPoint(low.x, low.y, low.z), points->InsertNextPoint(high.x, high.y, high.z)};
            lines->InsertNextCell(2, ends);
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    vtkPolyDataMapper::SafeDownCast(crosses_->GetMapper())->SetInputData(data);
}

}  // namespace luxdeck::gui

#include "gui/view3d/luminaire_layer.h"

#include "gui/view3d/luminaire_shapes.h"
#include "gui/view3d/section_plane.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>
#include <numeric>

namespace luxdeck::gui {

namespace {

constexpr double kSolidM = 0.9;        // from the luminaire to the farthest point of the largest solid
constexpr double kAimM = 6;            // of the line a luminaire is aimed along, at most

std::vector<std::uint32_t> allOf(const Scene& scene) {
    std::vector<std::uint32_t> all(scene.luminaires.size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

/// From the luminaire straight on to what it is aimed at.
vtkSmartPointer<vtkPolyData> aimLine(const LitProject& project, const Luminaire& luminaire) {
    Ray ray;
    ray.origin = luminaire.position;
    ray.direction = -luminaire.frame.normal;
    ray.tMin = 0.01F;
    Hit hit;
    project.lit.raycaster().closestHits({&ray, 1}, {&hit, 1}, Targets::Opaque);
    const float length = std::min(hit.distance, static_cast<float>(kAimM));
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    const int dashes = std::max(1, static_cast<int>(length / 0.12F));
    for (int i = 0; i < dashes; ++i) {
        const vtkIdType ends[2] = {2 * i, 2 * i + 1};
        for (const float part : {0.0F, 0.6F}) {
            const Vec3 p = ray.origin + ray.direction * (length * (static_cast<float>(i) + part) / static_cast<float>(dashes));
            points->InsertNextPoint(p.x, p.y, p.z);
        }
        lines->InsertNextCell(2, ends);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
}

}  // namespace

LuminaireLayer::LuminaireLayer(vtkRenderer& renderer, const SharedScene& shared) : renderer_(renderer), shared_(shared) {
    for (auto* drawn : {&bodies_, &outlines_, &solids_, &selectedBody_, &selectedOutline_, &selectedSolid_, &aim_}) add(*drawn);
    for (auto* drawn : {&bodies_, &selectedBody_}) {
        drawn->mapper->SetScalarModeToUsePointFieldData();
        drawn->mapper->SelectColorArray("colours");
        drawn->mapper->SetColorModeToDirectScalars();
    }
    solids_.actor->GetProperty()->SetOpacity(0.30);
    selectedSolid_.actor->GetProperty()->SetOpacity(0.45);
    for (auto* drawn : {&solids_, &selectedSolid_}) {
        drawn->mapper->ScalarVisibilityOff();
        drawn->actor->GetProperty()->SetColor(1.0, 0.72, 0.18);
    }
    for (auto* drawn : {&outlines_, &selectedOutline_, &aim_}) drawn->mapper->ScalarVisibilityOff();
    selectedOutline_.actor->GetProperty()->SetLineWidth(3);
    aim_.actor->GetProperty()->SetLineWidth(1.5F);
}

void LuminaireLayer::add(Drawn& drawn) {
    drawn.actor->SetMapper(drawn.mapper);
    drawn.actor->GetProperty()->LightingOff();
    drawn.actor->VisibilityOff();
    renderer_.AddActor(drawn.actor);
}

double LuminaireLayer::metresPerCandela() const {
    double most = 0;
    for (const auto& luminaire : scene()->luminaires) most = std::max(most, largestIntensity(*scene(), luminaire));
    return most > 0 ? kSolidM / most : 0;
}

void LuminaireLayer::rebuild() {
    of_ = shared_.project;
    if (scene() == nullptr) return;
    const auto all = allOf(*scene());
    bodies_.mapper->SetInputData(luminaireBodies(*scene(), all));
    outlines_.mapper->SetInputData(luminaireOutlines(*scene(), all));
    solids_.mapper->SetInputData(allSolids_ ? candelaSolids(*scene(), all, metresPerCandela(), false) : vtkSmartPointer<vtkPolyData>::New());
}

void LuminaireLayer::rebuildSelected() {
    for (auto* drawn : {&selectedBody_, &selectedOutline_, &selectedSolid_}) drawn->actor->SetUserMatrix(nullptr);
    if (selected_ < 0) return;
    const std::vector<std::uint32_t> one{static_cast<std::uint32_t>(selected_)};
    const auto& luminaire = scene()->luminaires[one[0]];
    selectedBody_.mapper->SetInputData(luminaireBodies(*scene(), one));
    selectedOutline_.mapper->SetInputData(luminaireOutlines(*scene(), one));
    selectedSolid_.mapper->SetInputData(candelaSolids(*scene(), one, metresPerCandela(), true));
    aim_.mapper->SetInputData(aimLine(*shared_.project, luminaire));
}

void LuminaireLayer::restyle() {
    const bool any = shown_ && scene() != nullptr;
    bodies_.actor->SetVisibility(any);
    outlines_.actor->SetVisibility(any && !moving_);
    solids_.actor->SetVisibility(any && allSolids_ && !moving_);
    for (auto* drawn : {&selectedBody_, &selectedOutline_, &selectedSolid_, &aim_}) drawn->actor->SetVisibility(any && selected_ >= 0);
    const auto edge = rgbOf(colours_.edge), accent = rgbOf(colours_.accent);
    outlines_.actor->GetProperty()->SetColor(edge[0], edge[1], edge[2]);
    for (auto* drawn : {&selectedOutline_, &aim_}) drawn->actor->GetProperty()->SetColor(accent[0], accent[1], accent[2]);
}

void LuminaireLayer::clip() {
    if (shared_.parts) placeSection(*section_, cut_, shared_.parts->sceneBounds());
    for (auto* drawn : {&bodies_, &outlines_, &solids_, &selectedBody_, &selectedOutline_, &selectedSolid_}) {
        drawn->mapper->RemoveAllClippingPlanes();
        if (cut_.on) drawn->mapper->AddClippingPlane(section_);
    }
}

bool LuminaireLayer::update(const Session& session, const ViewSettings& view, const ResolvedScale& /*scale*/) {
    const auto& picked = session.selection();
    const bool fresh = of_ != shared_.project || view.candelaSolids != allSolids_;
    allSolids_ = view.candelaSolids;
    if (fresh) rebuild();
    const bool one = scene() != nullptr && picked.thing == Thing::Luminaire && picked.index < scene()->luminaires.size();
    const std::int64_t selected = one ? static_cast<std::int64_t>(picked.index) : -1;
    const bool marks = fresh || selected != selected_;
    selected_ = selected;
    if (marks) rebuildSelected();
    const bool cuts = fresh || view.section != cut_;
    cut_ = view.section;
    if (cuts) clip();
    if (!marks && !cuts && view.luminaires == shown_) return false;
    shown_ = view.luminaires;
    restyle();
    return true;
}

void LuminaireLayer::annotate(std::vector<Annotation>& to) const {
    if (!shown_ || scene() == nullptr) return;
    for (std::size_t i = 0; i < scene()->luminaires.size(); ++i) {
        const auto& luminaire = scene()->luminaires[i];
        Annotation mark;
        mark.kind = Annotation::Kind::Mark;
        mark.at = Vec3d(luminaire.position);
        mark.strong = static_cast<std::int64_t>(i) == selected_;
        mark.text = QString::fromStdString(scene()->luminaireTypes[luminaire.type].id);
        to.push_back(mark);
    }
}

void LuminaireLayer::setColours(const ViewColours& colours) {
    colours_ = colours;
    restyle();
}

void LuminaireLayer::setMoving(bool moving) {
    moving_ = moving;
    restyle();
}

void LuminaireLayer::placeSelected(const vtkMatrix4x4& where) {
    for (auto* drawn : {&selectedBody_, &selectedOutline_, &selectedSolid_}) {
        vtkNew<vtkMatrix4x4> matrix;
        matrix->DeepCopy(&where);
        drawn->actor->SetUserMatrix(matrix);
    }
}

}  // namespace luxdeck::gui

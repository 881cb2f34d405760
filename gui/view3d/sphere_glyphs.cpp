#include "gui/view3d/sphere_glyphs.h"

#include "engine/core/parallel.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkShaderProperty.h>
#include <vtkTextureObject.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

/// Sides of the picture of all bins: graphics cards of the last fifteen years hold it.
constexpr int kMostAcross = 8192;

/// VTK draws no polygon without an area: a square's corners lie that far from its middle, until the shader moves them.
constexpr float kSpreadM = 0.0009765625F;

const char* const kVertexDeclarations = R"(
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;
uniform int cameraParallel;
in vec4 glyphCorner;            // of the square, -1 .. 1; corner of the sphere's tile
out vec3 squarePoint;
flat out vec3 sphereCentre;
flat out vec2 sphereTile;
flat out vec3 cameraAt;         // parallel projection: the direction towards the camera
flat out int parallelView;
)";

const char* const kVertexBody = R"(
  mat3 turn = mat3(MCVCMatrix);
  vec3 back = vec3(turn[0].z, turn[1].z, turn[2].z);
  vec3 up = vec3(turn[0].y, turn[1].y, turn[2].y);
  vec3 eye = -MCVCMatrix[3].xyz * turn;
  sphereCentre = vertexMC.xyz - vec3(glyphCorner.xy * 0.0009765625, 0.0);
  vec3 towards = cameraParallel != 0 ? back : normalize(eye - sphereCentre);
  vec3 across = normalize(cross(up, towards));
  vec3 along = cross(towards, across);
  float away = cameraParallel != 0 ? 1.0e9 : max(length(eye - sphereCentre), 1.001 * glyphRadius);
  float outline = glyphRadius * (cameraParallel != 0 ? 1.0 : inversesqrt(max(1.0 - glyphRadius * glyphRadius / (away * away), 1.0e-3)));
  squarePoint = sphereCentre + (across * glyphCorner.x + along * glyphCorner.y) * outline;
  sphereTile = glyphCorner.zw;
  cameraAt = cameraParallel != 0 ? back : eye;
  parallelView = cameraParallel;
  gl_Position = MCDCMatrix * vec4(squarePoint, 1.0);
)";

const char* const kFragmentDeclarations = R"(
uniform mat4 MCDCMatrix;
uniform sampler2D glyphBins;
in vec3 squarePoint;
flat in vec3 sphereCentre;
flat in vec2 sphereTile;
flat in vec3 cameraAt;
flat in int parallelView;
// The concentric map's inverse, as engine/volume/directions.h has it.
ivec2 binOf(vec3 d) {
  float radius = sqrt(min(dot(d.xy, d.xy) / (1.0 + abs(d.z)), 1.0));
  vec2 a = abs(d.xy);
  float across = radius * min(atan(min(a.x, a.y), max(max(a.x, a.y), 1.0e-20)) * 1.27323954, 1.0);
  vec2 square = a.x > a.y ? vec2(radius, across) : vec2(across, radius);
  square = 0.5 + 0.5 * vec2(d.x < 0.0 ? -square.x : square.x, d.y < 0.0 ? -square.y : square.y);
  ivec2 cell = min(ivec2(square * float(glyphSide)), ivec2(glyphSide - 1));
  return ivec2(cell.x + (d.z < 0.0 ? glyphSide : 0), cell.y);
}
)";

const char* const kFragmentBody = R"(
  vec3 ahead = parallelView != 0 ? -cameraAt : normalize(squarePoint - cameraAt);
  vec3 offset = squarePoint - sphereCentre;
  float nearest = -dot(offset, ahead);
  float inside = glyphRadius * glyphRadius - dot(offset, offset) + nearest * nearest;
  if (inside < 0.0) discard;
  vec3 normal = (offset + ahead * (nearest - sqrt(inside))) / glyphRadius;
  vec4 clip = MCDCMatrix * vec4(sphereCentre + normal * glyphRadius, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
  // A darker rim sets spheres off from each other; the face keeps the legend's colours.
  float rim = 1.0 - 0.35 * pow(1.0 + dot(normal, ahead), 3.0);
  gl_FragData[0] = vec4(texelFetch(glyphBins, ivec2(sphereTile) + binOf(normal), 0).rgb * rim, 1.0);
)";

}  // namespace

SphereGlyphs::SphereGlyphs(vtkRenderer& renderer) : renderer_(renderer) {
    actor_->SetMapper(mapper_);
    actor_->PickableOff();
    actor_->VisibilityOff();
    actor_->ForceOpaqueOn();
    actor_->GetProperty()->LightingOff();
    mapper_->ScalarVisibilityOff();
    mapper_->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);  // a radius is not scaled with the points
    mapper_->SetResolveCoincidentTopology(false);
    addShaders();
    setRadius(0.1);
    mapper_->AddObserver(vtkCommand::UpdateShaderEvent, this, &SphereGlyphs::bind);
    renderer_.AddActor(actor_);
}

SphereGlyphs::~SphereGlyphs() { renderer_.RemoveActor(actor_); }

void SphereGlyphs::addShaders() {
    auto* shaders = actor_->GetShaderProperty();
    shaders->AddVertexShaderReplacement("//VTK::Camera::Dec", true, kVertexDeclarations, false);
    shaders->AddVertexShaderReplacement("//VTK::PositionVC::Dec", true, "", false);
    shaders->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, kVertexBody, false);
    shaders->AddFragmentShaderReplacement("//VTK::PositionVC::Dec", true, kFragmentDeclarations, false);
    shaders->AddFragmentShaderReplacement("//VTK::PositionVC::Impl", true, "", false);
    shaders->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kFragmentBody, false);
}

void SphereGlyphs::place(const IrradianceVolume& volume) {
    side_ = volume.settings.side;
    tilesAcross_ = std::max(kMostAcross / (2 * side_), 1);
    vertices_.clear();
    for (std::uint32_t v = 0; v < volume.vertexCount(); ++v)
        if (volume.quality[v].usable()) vertices_.push_back(v);
    const auto most = static_cast<std::size_t>(tilesAcross_) * static_cast<std::size_t>(std::max(kMostAcross / side_, 1));
    if (vertices_.size() > most) {
        const std::size_t step = (vertices_.size() + most - 1) / most;
        for (std::size_t i = 0; i * step < vertices_.size(); ++i) vertices_[i] = vertices_[i * step];
        vertices_.resize((vertices_.size() + step - 1) / step);
    }
    const int count = static_cast<int>(vertices_.size());
    // Not wider than it needs to be.
    tilesAcross_ = std::clamp(static_cast<int>(std::ceil(std::sqrt(count / 2.0))), 1, tilesAcross_);
    width_ = tilesAcross_ * 2 * side_, height_ = std::max((count + tilesAcross_ - 1) / tilesAcross_, 1) * side_;

    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> squares;
    vtkNew<vtkFloatArray> corners;
    corners->SetName("glyphCorner");
    corners->SetNumberOfComponents(4);
    for (int i = 0; i < count; ++i) {
        const Vec3& at = volume.lattice.vertices()[vertices_[static_cast<std::size_t>(i)]];
        const float tileX = static_cast<float>(i % tilesAcross_ * 2 * side_), tileY = static_cast<float>(i / tilesAcross_ * side_);
        vtkIdType square[4];
        for (int corner = 0; corner < 4; ++corner) {
            const float x = corner == 0 || corner == 3 ? -1 : 1, y = corner < 2 ? -1 : 1;
            square[corner] = points->InsertNextPoint(at.x + x * kSpreadM, at.y + y * kSpreadM, at.z);
            corners->InsertNextTuple4(x, y, tileX, tileY);
        }
        squares->InsertNextCell(4, square);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(squares);
    data->GetPointData()->AddArray(corners);
    mapper_->SetInputData(data);
    mapper_->MapDataArrayToVertexAttribute("glyphCorner", "glyphCorner", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("glyphSide", side_);
}

void SphereGlyphs::colour(const LightSpheres& spheres, const LightColours& colours) {
    picture_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3, 0);
    const auto side = static_cast<std::size_t>(side_), bins = 2 * side * side;
    parallelFor(vertices_.size(), [&](std::size_t i) {
        const float* values = &spheres.values[vertices_[i] * bins];
        const std::size_t x = i % static_cast<std::size_t>(tilesAcross_) * 2 * side, y = i / static_cast<std::size_t>(tilesAcross_) * side;
        for (std::size_t bin = 0; bin < bins; ++bin) {
            const std::size_t row = bin / side, lower = row >= side ? 1 : 0;
            const std::size_t pixel = (y + row - lower * side) * static_cast<std::size_t>(width_) + x + lower * side + bin % side;
            const auto rgb = colours.colour(values[bin]);
            std::copy(rgb.begin(), rgb.end(), &picture_[pixel * 3]);
        }
    });
    uploaded_ = false;
    actor_->Modified();
}

void SphereGlyphs::setRadius(double metres) {
    for (auto* uniforms : {actor_->GetShaderProperty()->GetVertexCustomUniforms(), actor_->GetShaderProperty()->GetFragmentCustomUniforms()})
        uniforms->SetUniformf("glyphRadius", static_cast<float>(metres));
}

void SphereGlyphs::setVisible(bool visible) { actor_->SetVisibility(visible && !vertices_.empty()); }

/// While it is drawn: the picture goes to the graphics card when it is another one, or another card.
void SphereGlyphs::bind(vtkObject*, unsigned long, void* program) {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer_.GetRenderWindow());
    if (window == nullptr || program == nullptr || picture_.empty()) return;
    if (!uploaded_ || texture_->GetContext() != window || texture_->GetHandle() == 0) {
        texture_->SetContext(window);
        texture_->SetMinificationFilter(vtkTextureObject::Nearest);
        texture_->SetMagnificationFilter(vtkTextureObject::Nearest);
        uploaded_ = texture_->Create2DFromRaw(static_cast<unsigned>(width_), static_cast<unsigned>(height_), 3, VTK_UNSIGNED_CHAR, picture_.data());
    }
    texture_->Activate();
    static_cast<vtkShaderProgram*>(program)->SetUniformi("glyphBins", texture_->GetTextureUnit());
}

}  // namespace luxdeck::gui

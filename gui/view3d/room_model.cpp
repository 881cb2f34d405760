#include "gui/view3d/room_model.h"

#include "gui/view3d/crease_edges.h"
#include "gui/view3d/view_colours.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkIdTypeArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace luxdeck::gui {

namespace {

constexpr Rgb kPlain{0.72F, 0.73F, 0.75F};

unsigned char byte(float linear) { return static_cast<unsigned char>(std::lround(255 * encodedSrgb(linear))); }

/// How light a face is by where it looks: bright from above, walls by their direction, so that corners are seen.
float evenLight(const Vec3& n) {
    const float sideways = 0.76F + 0.10F * n.x - 0.07F * n.y;
    return std::clamp(sideways + (n.z > 0 ? 0.24F : 0.12F) * n.z, 0.4F, 1.0F);
}

/// What colour a material has, by and large.
Rgb shownColour(const Scene& scene, const Material& material) {
    switch (material.kind) {
        case MaterialKind::Mix: return (shownColour(scene, scene.materials[material.mixFirst]) + shownColour(scene, scene.materials[material.mixSecond])) * 0.5F;
        case MaterialKind::ThinGlass:
        case MaterialKind::Dielectric: return {0.62F, 0.74F, 0.80F};
        case MaterialKind::Metal:
        case MaterialKind::Mirror: return material.specular * 0.75F;
        case MaterialKind::Ward: return material.reflectance + material.specular * 0.5F + material.diffuseTransmittance;
        default: break;
    }
    if (!material.emits()) return material.reflectance;
    return material.reflectance + material.emission * (0.8F / material.emission.max());
}

bool isGlass(const Material& material) {
    return material.kind == MaterialKind::ThinGlass || material.kind == MaterialKind::Dielectric || (material.kind == MaterialKind::Ward && !material.specularTransmittance.isBlack());
}

/// Grows one part triangle by triangle.
class PartBuilder {
public:
    void add(const Scene& scene, const Mesh& mesh, std::uint32_t triangle) {
        const auto& t = mesh.triangles[triangle];
        const auto& material = scene.materials[mesh.material];
        const Vec3 face = cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]).normalized();
        const Rgb colour = shownColour(scene, material);
        connectivity_->InsertNextValue(points_->GetNumberOfPoints());
        for (const auto v : t) {
            points_->InsertNextPoint(mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z);
            const float light = evenLight(mesh.normals.empty() ? face : mesh.normals[v]);
            addColour(*materials_, colour * light);
            addColour(*plain_, kPlain * light);
        }
        edges_.add({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, face);
    }
    [[nodiscard]] RoomPart finish() {
        RoomPart part;
        part.faces = vtkSmartPointer<vtkPolyData>::New();
        part.faces->SetPoints(points_);
        part.faces->SetPolys(triangles());
        materials_->SetName("materials");
        plain_->SetName("plain");
        part.faces->GetPointData()->AddArray(materials_);
        part.faces->GetPointData()->AddArray(plain_);
        part.edges = edges_.lines();
        return part;
    }

private:
    static void addColour(vtkUnsignedCharArray& to, const Rgb& colour) {
        const std::array<unsigned char, 3> rgb{byte(colour.r), byte(colour.g), byte(colour.b)};
        to.InsertNextTypedTuple(rgb.data());
    }
    static vtkSmartPointer<vtkUnsignedCharArray> colours() {
        auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
        array->SetNumberOfComponents(3);
        return array;
    }
    [[nodiscard]] vtkSmartPointer<vtkCellArray> triangles() const {
        auto cells = vtkSmartPointer<vtkCellArray>::New();
        const auto count = connectivity_->GetNumberOfValues();
        cells->AllocateExact(count, 3 * count);
        for (vtkIdType i = 0; i < count; ++i) {
            const vtkIdType first = connectivity_->GetValue(i);
            const std::array<vtkIdType, 3> corners{first, first + 1, first + 2};
            cells->InsertNextCell(3, corners.data());
        }
        return cells;
    }

    vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkIdTypeArray> connectivity_ = vtkSmartPointer<vtkIdTypeArray>::New();  // first point of each triangle
    vtkSmartPointer<vtkUnsignedCharArray> materials_ = colours(), plain_ = colours();
    CreaseEdges edges_;
};

}  // namespace

std::shared_ptr<const RoomModel> RoomModel::of(const Scene& scene, const SceneParts& parts) {
    using Key = std::tuple<std::int64_t, ShellSide, bool>;
    std::map<Key, PartBuilder> builders;
    for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
        const auto& mesh = scene.meshes[m];
        const std::int64_t movable = scene.objects[mesh.object].movable ? std::int64_t{mesh.object} : -1;
        const bool glass = isGlass(scene.materials[mesh.material]);
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) builders[{movable, parts.side(m, t), glass}].add(scene, mesh, t);
    }
    auto model = std::make_shared<RoomModel>();
    for (auto& [key, builder] : builders) {
        auto part = builder.finish();
        std::tie(part.movable, part.side, part.glass) = key;
        model->parts.push_back(std::move(part));
    }
    return model;
}

RoomPart RoomModel::object(const Scene& scene, std::uint32_t index) {
    PartBuilder builder;
    for (const auto& mesh : scene.meshes)
        for (std::uint32_t t = 0; mesh.object == index && t < mesh.triangles.size(); ++t) builder.add(scene, mesh, t);
    return builder.finish();
}

}  // namespace luxdeck::gui

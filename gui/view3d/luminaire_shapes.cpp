#include "gui/view3d/luminaire_shapes.h"

#include "engine/scene/opening.h"
#include "gui/view3d/view_colours.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace luxdeck::gui {

namespace {

constexpr int kRound = 32;             // corners of a circle
constexpr float kPointRadiusM = 0.05F; // of a luminaire without a luminous opening

/// Polygons, lines and colours that grow together.
class Shape {
public:
    Shape() { colours_->SetNumberOfComponents(3), colours_->SetName("colours"); }

    void setColour(const Rgb& shown) {
        const auto byte = [](float v) { return static_cast<unsigned char>(std::lround(255 * std::clamp(v, 0.0F, 1.0F))); };
        colour_ = {byte(shown.r), byte(shown.g), byte(shown.b)};
    }
    vtkIdType point(const Vec3& p) {
        colours_->InsertNextTypedTuple(colour_.data());
        return points_->InsertNextPoint(p.x, p.y, p.z);
    }
    void face(const std::vector<vtkIdType>& corners) { faces_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data()); }
    void line(const std::vector<vtkIdType>& corners) { lines_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data()); }
    /// A rectangular net of points, closed along its rows where `round`.
    void net(int rows, int columns, bool round, const std::function<Vec3(int, int)>& at) {
        const vtkIdType first = points_->GetNumberOfPoints();
        for (int r = 0; r < rows; ++r)
            for (int c = 0; c < columns; ++c) point(at(r, c));
        const auto id = [&](int r, int c) { return first + r * columns + c % columns; };
        for (int r = 0; r + 1 < rows; ++r)
            for (int c = 0; c + (round ? 0 : 1) < columns; ++c) face({id(r, c), id(r, c + 1), id(r + 1, c + 1), id(r + 1, c)});
    }
    [[nodiscard]] vtkSmartPointer<vtkPolyData> finish() const {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetPolys(faces_);
        data->SetLines(lines_);
        data->GetPointData()->AddArray(colours_);
        return data;
    }

private:
    vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkCellArray> faces_ = vtkSmartPointer<vtkCellArray>::New(), lines_ = vtkSmartPointer<vtkCellArray>::New();
    vtkSmartPointer<vtkUnsignedCharArray> colours_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
    std::array<unsigned char, 3> colour_{};
};

PlacedOpening openingOf(const Scene& scene, std::uint32_t index) {
    const auto& luminaire = scene.luminaires[index];
    return PlacedOpening::of(luminaire, scene.luminaireTypes[luminaire.type].photometry.opening);
}

Rgb lightColour(const Scene& scene, const Luminaire& luminaire) {
    const Rgb& type = scene.luminaireTypes[luminaire.type].colour;
    Rgb bright = type * (1 / std::max(type.max(), 1e-6F));
    // Towards white, so that it looks like light.
    bright = bright * 0.5F + Rgb(0.5F);
    bright = {encodedSrgb(bright.r), encodedSrgb(bright.g), encodedSrgb(bright.b)};
    const float on = luminaire.dimming > 0 ? 0.35F + 0.65F * std::pow(static_cast<float>(luminaire.dimming), 0.45F) : 0;
    return bright * on + Rgb(0.30F, 0.32F, 0.35F) * (1 - on);
}

std::vector<Vec3> outline(const PlacedOpening& o) {
    std::vector<Vec3> corners;
    if (o.shape == OpeningShape::Rectangle || o.shape == OpeningShape::Box)
        for (const auto& [x, y] : std::array<std::array<float, 2>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) corners.push_back({x * o.halfM.x, y * o.halfM.y, -o.halfM.z});
    else
        for (int i = 0; i < kRound; ++i) {
            const float angle = 2 * kPi * static_cast<float>(i) / kRound, radius = o.shape == OpeningShape::Point ? kPointRadiusM : o.halfM.x;
            corners.push_back({radius * std::cos(angle), radius * std::sin(angle), o.shape == OpeningShape::Sphere || o.shape == OpeningShape::Point ? 0 : -o.halfM.z});
        }
    return corners;
}

void addBody(Shape& shape, const PlacedOpening& o) {
    const auto world = [&](const Vec3& local) { return o.centre + o.frame.toWorld(local); };
    if (o.shape == OpeningShape::Sphere || o.shape == OpeningShape::Point) {
        const float radius = o.shape == OpeningShape::Point ? kPointRadiusM : o.halfM.x;
        shape.net(13, 24, true, [&](int r, int c) {
            const float polar = kPi * static_cast<float>(r) / 12, around = 2 * kPi * static_cast<float>(c) / 24;
            return world(Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)) * radius);
        });
        return;
    }
    const auto low = outline(o);
    std::vector<vtkIdType> ring;
    for (const auto& corner : low) ring.push_back(shape.point(world(corner)));
    shape.face(ring);
    if (o.flat()) return;
    ring.clear();
    for (const auto& corner : low) ring.push_back(shape.point(world({corner.x, corner.y, o.halfM.z})));
    shape.face(ring);
    shape.net(2, static_cast<int>(low.size()), true, [&](int r, int c) {
        const auto& corner = low[static_cast<std::size_t>(c)];
        return world({corner.x, corner.y, r == 0 ? -o.halfM.z : o.halfM.z});
    });
}

/// The angles of the solid's net from the nadir: the file's own, for beams may be narrow; fewer where there are very many.
std::vector<double> verticalAngles(const CandelaTable& table, int most) {
    std::vector<double> angles;
    if (table.type() == PhotometryType::C) {
        const auto& own = table.vertical();
        const std::size_t step = 1 + own.size() / static_cast<std::size_t>(most);
        for (std::size_t i = 0; i < own.size(); i += step) angles.push_back(own[i]);
        if (angles.back() != own.back()) angles.push_back(own.back());
    } else {
        for (int i = 0; i <= most; ++i) angles.push_back(180.0 * i / most);
    }
    return angles;
}

void addSolid(Shape& shape, const Scene& scene, std::uint32_t index, double metresPerCandela, bool fine) {
    const auto& luminaire = scene.luminaires[index];
    const auto& table = scene.luminaireTypes[luminaire.type].photometry.table;
    const auto angles = verticalAngles(table, fine ? 91 : 30);
    const int columns = fine ? 72 : 36;
    const double scale = metresPerCandela * luminaire.outputScale();
    shape.net(static_cast<int>(angles.size()), columns, true, [&](int r, int c) {
        const double v = angles[static_cast<std::size_t>(r)] * kDegree, h = 2 * kPiD * c / columns;
        const Vec3 local(static_cast<float>(std::sin(v) * std::cos(h)), static_cast<float>(std::sin(v) * std::sin(h)), static_cast<float>(-std::cos(v)));
        return luminaire.position + luminaire.frame.toWorld(local * static_cast<float>(double{table.intensity(local)} * scale));
    });
}

}  // namespace

vtkSmartPointer<vtkPolyData> luminaireBodies(const Scene& scene, const std::vector<std::uint32_t>& luminaires) {
    Shape shape;
    for (const auto index : luminaires) {
        shape.setColour(lightColour(scene, scene.luminaires[index]));
        addBody(shape, openingOf(scene, index));
    }
    return shape.finish();
}

vtkSmartPointer<vtkPolyData> luminaireOutlines(const Scene& scene, const std::vector<std::uint32_t>& luminaires) {
    Shape shape;
    for (const auto index : luminaires) {
        const auto opening = openingOf(scene, index);
        std::vector<vtkIdType> ring;
        for (const auto& corner : outline(opening)) ring.push_back(shape.point(opening.centre + opening.frame.toWorld(corner)));
        ring.push_back(ring.front());
        shape.line(ring);
    }
    return shape.finish();
}

vtkSmartPointer<vtkPolyData> candelaSolids(const Scene& scene, const std::vector<std::uint32_t>& luminaires, double metresPerCandela, bool fine) {
    Shape shape;
    for (const auto index : luminaires) addSolid(shape, scene, index, metresPerCandela, fine);
    return shape.finish();
}

double largestIntensity(const Scene& scene, const Luminaire& luminaire) {
    return double{scene.luminaireTypes[luminaire.type].photometry.table.maxIntensity()} * luminaire.outputScale();
}

}  // namespace luxdeck::gui

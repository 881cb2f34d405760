#include "gui/view3d/grid_shapes.h"

#include "analysis/grids/grid_field.h"
#include "analysis/report/value_field.h"
#include "engine/core/vec.h"
#include "tonemap/isolines.h"

#include <QColor>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

namespace luxdeck::gui {

namespace {

constexpr int kFinest = 32;          // texels a cell at most
constexpr int kTexels = 256;         // along the longer side
constexpr double kOldColour = 0.25;  // what is left of the colour of an old result

std::array<Vec3d, 4> cornersOf(const SurfaceFrame& f) { return {f.origin, f.origin + f.u, f.origin + f.u + f.v, f.origin + f.v}; }

vtkSmartPointer<vtkUnsignedCharArray> colourArray() {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetNumberOfComponents(3);
    array->SetName("colours");
    return array;
}

void addColour(vtkUnsignedCharArray& to, QRgb colour) {
    const std::array<unsigned char, 3> rgb{static_cast<unsigned char>(qRed(colour)), static_cast<unsigned char>(qGreen(colour)), static_cast<unsigned char>(qBlue(colour))};
    to.InsertNextTypedTuple(rgb.data());
}

double lightness(const tonemap::Colour8& c) { return (0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]) / 255; }

/// Where on a line its level is written: in its middle.
Vec3d middleOf(const std::vector<Vec3d>& path) { return path[path.size() / 2]; }

double lengthOf(const std::vector<Vec3d>& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).length();
    return length;
}

}  // namespace

QRgb shownColour(const tonemap::Colour8& colour, bool old) {
    if (!old) return qRgb(colour[0], colour[1], colour[2]);
    const double grey = 255 * lightness(colour) * 0.6 + 90;
    const auto mix = [&](int c) { return static_cast<int>(std::lround(std::min(255.0, kOldColour * c + (1 - kOldColour) * grey))); };
    return qRgb(mix(colour[0]), mix(colour[1]), mix(colour[2]));
}

vtkSmartPointer<vtkPolyData> surfaceQuad(const SurfaceFrame& frame) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> faces;
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    for (const auto& corner : cornersOf(frame)) points->InsertNextPoint(corner.x, corner.y, corner.z);
    for (const auto& [s, t] : std::array<std::array<float, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) places->InsertNextTuple2(s, t);
    const std::array<vtkIdType, 4> ids{0, 1, 2, 3};
    faces->InsertNextCell(4, ids.data());
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(faces);
    data->GetPointData()->SetTCoords(places);
    return data;
}

vtkSmartPointer<vtkPolyData> surfaceOutline(const SurfaceFrame& frame) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (const auto& corner : cornersOf(frame)) points->InsertNextPoint(corner.x, corner.y, corner.z);
    const std::array<vtkIdType, 5> ids{0, 1, 2, 3, 0};
    lines->InsertNextCell(5, ids.data());
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
}

vtkSmartPointer<vtkImageData> fieldTexture(const std::vector<double>& values, int columns, int rows, const LightColours& colours, bool old) {
    const int fine = std::clamp(kTexels / std::max(columns, rows), 1, kFinest);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(columns * fine, rows * fine, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int j = 0; j < rows * fine; ++j)
        for (int i = 0; i < columns * fine; ++i) {
            const QRgb colour = shownColour(colours.colour(sampleField(values, columns, rows, (i + 0.5) / fine - 0.5, (j + 0.5) / fine - 0.5)), old);
            *texel++ = static_cast<unsigned char>(qRed(colour));
            *texel++ = static_cast<unsigned char>(qGreen(colour));
            *texel++ = static_cast<unsigned char>(qBlue(colour));
        }
    return image;
}

vtkSmartPointer<vtkPolyData> isolineShapes(const std::vector<double>& values, int columns, int rows, const SurfaceFrame& frame, const LightColours& colours, const Units& units,
                                           std::vector<LevelMark>& marks) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    auto ink = colourArray();
    double low = 1e300, high = -1e300;
    for (const double v : values)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    std::vector<double> levels;
    if (columns > 1 && rows > 1 && high > low)
        for (const double shown : report::isolineLevels(units.illuminance(low), units.illuminance(high))) levels.push_back(units.lux(shown));
    std::map<double, std::pair<double, Vec3d>> longest;
    for (const auto& isoline : tonemap::isolines(values, columns, rows, levels)) {
        std::vector<Vec3d> path;
        for (const auto& p : isoline.points) path.push_back(frame.origin + frame.u * ((p[0] + 0.5) / columns) + frame.v * ((p[1] + 0.5) / rows));
        if (isoline.closed && !path.empty()) path.push_back(path.front());
        if (path.size() < 2) continue;
        const QRgb colour = lightness(colours.colour(isoline.level)) > 0.45 ? qRgb(14, 20, 30) : qRgb(255, 255, 255);
        std::vector<vtkIdType> ids;
        for (const auto& p : path) {
            ids.push_back(points->InsertNextPoint(p.x, p.y, p.z));
            addColour(*ink, colour);
        }
        lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
        auto& best = longest[isoline.level];
        if (const double length = lengthOf(path); length > best.first) best = {length, middleOf(path)};
    }
    for (const auto& [lux, best] : longest) marks.push_back({best.second, lux});
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    data->GetPointData()->AddArray(ink);
    return data;
}

vtkSmartPointer<vtkPolyData> pointShapes(const std::vector<PointSet>& sets, const LightColours& colours, bool old) {
    constexpr int kCorners = 20;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> faces;
    auto ink = colourArray();
    const auto ring = [&](const Frame& frame, const Vec3d& centre, double radius, QRgb colour) {
        std::vector<vtkIdType> ids;
        for (int k = 0; k < kCorners; ++k) {
            const double angle = 2 * kPiD * k / kCorners;
            const Vec3d p = centre + (Vec3d(frame.tangent) * std::cos(angle) + Vec3d(frame.bitangent) * std::sin(angle)) * radius;
            ids.push_back(points->InsertNextPoint(p.x, p.y, p.z));
            addColour(*ink, colour);
        }
        return ids;
    };
    for (const auto& set : sets)
        for (std::size_t i = 0; i < set.points.size(); ++i) {
            const QRgb colour = set.lux.empty() ? qRgb(150, 156, 164) : shownColour(colours.colour(set.lux[i]), old);
            const Vec3d normal = i < set.normals.size() ? set.normals[i] : Vec3d(0, 0, 1);
            const auto frame = Frame::about(Vec3(normal));
            if (set.kind == GridKind::Planar) {
                const auto disc = ring(frame, set.points[i], set.radiusM, colour);
                faces->InsertNextCell(kCorners, disc.data());
                continue;
            }
            const auto low = ring(frame, set.points[i] - normal * set.radiusM, 0.6 * set.radiusM, QColor(colour).darker(118).rgb());
            const auto high = ring(frame, set.points[i] + normal * set.radiusM, 0.6 * set.radiusM, colour);
            const auto cap = ring(frame, set.points[i] + normal * set.radiusM, 0.6 * set.radiusM, QColor(colour).lighter(108).rgb());
            faces->InsertNextCell(kCorners, cap.data());
            for (std::size_t k = 0; k < kCorners; ++k) {
                const std::size_t next = (k + 1) % kCorners;
                const std::array<vtkIdType, 4> side{low[k], low[next], high[next], high[k]};
                faces->InsertNextCell(4, side.data());
            }
        }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(faces);
    data->GetPointData()->AddArray(ink);
    return data;
}

}  // namespace luxdeck::gui

#include "gui/view3d/crease_edges.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr float kSameM = 2e-4F;        // corners closer than this are one
constexpr float kShortestM = 0.03F;    // of a drawn edge: small things would be ink alone
const float kSharpCosine = std::cos(32 * static_cast<float>(kDegree));

std::uint64_t cellOf(const Vec3& p) {
    const auto part = [](float v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::lround(v / kSameM))) & 0x1fffffU; };
    return part(p.x) | part(p.y) << 21U | part(p.z) << 42U;
}

}  // namespace

std::uint32_t CreaseEdges::cornerAt(const Vec3& position) {
    const auto [at, isNew] = cornerOf_.try_emplace(cellOf(position), static_cast<std::uint32_t>(corners_.size()));
    if (isNew) corners_.push_back(position);
    return at->second;
}

void CreaseEdges::add(const std::array<Vec3, 3>& corners, const Vec3& normal) {
    const std::array<std::uint32_t, 3> at{cornerAt(corners[0]), cornerAt(corners[1]), cornerAt(corners[2])};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto a = std::min(at[i], at[(i + 1) % 3]), b = std::max(at[i], at[(i + 1) % 3]);
        if (a == b || (corners_[a] - corners_[b]).length() < kShortestM) continue;
        const auto [edge, isNew] = edgeOf_.try_emplace(std::uint64_t{a} << 32U | b, static_cast<std::uint32_t>(edges_.size()));
        if (isNew) {
            edges_.push_back({a, b, normal});
            continue;
        }
        auto& known = edges_[edge->second];
        known.border = false;
        known.sharp |= dot(known.normal, normal) < kSharpCosine;
    }
}

vtkSmartPointer<vtkPolyData> CreaseEdges::lines() const {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto lines = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& edge : edges_) {
        if (!edge.border && !edge.sharp) continue;
        std::array<vtkIdType, 2> ends{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Vec3& p = corners_[i == 0 ? edge.from : edge.to];
            ends[i] = points->InsertNextPoint(p.x, p.y, p.z);
        }
        lines->InsertNextCell(2, ends.data());
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
}

}  // namespace luxdeck::gui

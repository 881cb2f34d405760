#include "engine/volume/occupancy.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace luxdeck {

namespace {

using Triangle = std::array<Vec3d, 3>;

bool separates(const Vec3d& axis, const Triangle& t, const Vec3d& half) {
    const double reach = half.x * std::abs(axis.x) + half.y * std::abs(axis.y) + half.z * std::abs(axis.z);
    const double a = axis.dot(t[0]), b = axis.dot(t[1]), c = axis.dot(t[2]);
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

/// The box that both an axis' range of cells and a triangle lie in.
std::array<int, 2> cellRange(const Lattice& lattice, int axis, double low, double high) {
    const auto& box = lattice.bounds();
    const double scale = lattice.firstLevel()[axis] / (double{box.max[axis]} - box.min[axis]);
    const double last = lattice.firstLevel()[axis] - 1;
    // One cell more on either side: the test of the box decides.
    return {static_cast<int>(std::clamp(std::floor((low - box.min[axis]) * scale) - 1, 0.0, last)),
            static_cast<int>(std::clamp(std::floor((high - box.min[axis]) * scale) + 1, 0.0, last))};
}

/// Calls visit(cell) for every cell of the first level that the triangle may touch.
template <class Visit>
void visitFirstLevel(const Lattice& lattice, const std::array<Vec3, 3>& t, const Visit& visit) {
    std::array<std::array<int, 2>, 3> range{};
    for (int axis = 0; axis < 3; ++axis)
        range[axis] = cellRange(lattice, axis, std::min({t[0][axis], t[1][axis], t[2][axis]}), std::max({t[0][axis], t[1][axis], t[2][axis]}));
    const auto n = lattice.firstLevel();
    for (int z = range[2][0]; z <= range[2][1]; ++z)
        for (int y = range[1][0]; y <= range[1][1]; ++y)
            for (int x = range[0][0]; x <= range[0][1]; ++x) visit(static_cast<std::uint32_t>((z * n[1] + y) * n[0] + x));
}

template <class Visit>
void forTriangles(const Scene& scene, const Visit& visit) {
    for (const auto& mesh : scene.meshes)
        for (const auto& t : mesh.triangles) visit(std::array<Vec3, 3>{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
}

std::uint32_t childrenOf(const Lattice& lattice) { return static_cast<std::uint32_t>(lattice.split() * lattice.split() * lattice.split()); }

}  // namespace

bool touches(const std::array<Vec3, 3>& triangle, const Box3& box) {
    const Vec3d centre = (Vec3d(box.min) + Vec3d(box.max)) * 0.5;
    // A face that lies on the side of a cell belongs to both its cells, whatever rounding says.
    const Vec3d half = (Vec3d(box.max) - Vec3d(box.min)) * (0.5 + 1e-6);
    const Triangle t{Vec3d(triangle[0]) - centre, Vec3d(triangle[1]) - centre, Vec3d(triangle[2]) - centre};
    const std::array<Vec3d, 3> edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    for (int i = 0; i < 3; ++i) {
        Vec3d axis(0, 0, 0);
        axis[i] = 1;
        if (separates(axis, t, half)) return false;
        for (const auto& edge : edges)
            if (separates(axis.cross(edge), t, half)) return false;
    }
    return !separates(edges[0].cross(edges[1]), t, half);
}

void divideByGeometry(Lattice& lattice, const Scene& scene) {
    const std::uint32_t children = childrenOf(lattice);
    std::function<void(std::uint32_t, const std::array<Vec3, 3>&)> insert = [&](std::uint32_t cell, const std::array<Vec3, 3>& t) {
        if (lattice.levelOf(cell) >= lattice.depth() || !touches(t, lattice.box(cell))) return;
        if (!lattice.divided(cell)) lattice.divide(cell);
        const auto first = lattice.cells()[cell].firstChild;
        for (std::uint32_t i = 0; i < children; ++i) insert(first + i, t);
    };
    forTriangles(scene, [&](const auto& t) { visitFirstLevel(lattice, t, [&](std::uint32_t cell) { insert(cell, t); }); });
}

std::vector<std::uint8_t> occupiedCells(const Lattice& lattice, const Scene& scene) {
    std::vector<std::uint8_t> occupied(lattice.cells().size());
    const std::uint32_t children = childrenOf(lattice);
    std::function<void(std::uint32_t, const std::array<Vec3, 3>&)> mark = [&](std::uint32_t cell, const std::array<Vec3, 3>& t) {
        if ((occupied[cell] != 0 && !lattice.divided(cell)) || !touches(t, lattice.box(cell))) return;
        occupied[cell] = 1;
        if (!lattice.divided(cell)) return;
        for (std::uint32_t i = 0; i < children; ++i) mark(lattice.cells()[cell].firstChild + i, t);
    };
    forTriangles(scene, [&](const auto& t) { visitFirstLevel(lattice, t, [&](std::uint32_t cell) { mark(cell, t); }); });
    return occupied;
}

}  // namespace luxdeck

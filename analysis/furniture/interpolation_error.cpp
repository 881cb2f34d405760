#include "analysis/furniture/interpolation_error.h"

#include "engine/volume/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck {

namespace {

constexpr double kSafety = 2;  // on what it is where light changes smoothly

}  // namespace

InterpolationError::InterpolationError(const IrradianceVolume& volume) {
    const auto& lattice = volume.lattice;
    const auto n = lattice.firstLevel();
    const auto first = static_cast<std::uint32_t>(n[0] * n[1] * n[2]);
    ofCell_.resize(lattice.cells().size());
    std::vector<std::uint8_t> known(first);
    std::array<double, 6> sums{};
    std::size_t found = 0;
    for (std::uint32_t cell = 0; cell < first; ++cell) {
        Axes error{};
        if (!(lattice.divided(cell) ? fromChildren(volume, cell, error) : fromNeighbours(volume, cell, error))) continue;
        known[cell] = 1, ++found;
        inherit(volume, cell, error);
        for (std::size_t axis = 0; axis < 6; ++axis) sums[axis] += error[axis];
    }
    Axes mean{};
    for (std::size_t axis = 0; axis < 6; ++axis) mean[axis] = found > 0 ? static_cast<float>(sums[axis] / static_cast<double>(found)) : std::numeric_limits<float>::infinity();
    for (std::uint32_t cell = 0; cell < first; ++cell)
        if (known[cell] == 0) inherit(volume, cell, mean);
}

/// To all that the cell was divided into; what was divided again speaks for itself.
void InterpolationError::inherit(const IrradianceVolume& volume, std::uint32_t cell, const Axes& error) {
    const auto& lattice = volume.lattice;
    ofCell_[cell] = error;
    if (!lattice.divided(cell)) return;
    const auto children = static_cast<std::uint32_t>(lattice.split() * lattice.split() * lattice.split());
    for (std::uint32_t c = 0; c < children; ++c) {
        const auto child = lattice.cells()[cell].firstChild + c;
        Axes own = error;
        if (lattice.divided(child) && !fromChildren(volume, child, own)) own = error;
        inherit(volume, child, own);
    }
}

bool InterpolationError::fromChildren(const IrradianceVolume& volume, std::uint32_t cell, Axes& out) const {
    const auto& lattice = volume.lattice;
    const auto& corners = lattice.cells()[cell].vertices;
    for (const auto v : corners)
        if (!volume.quality[v].usable()) return false;
    const auto box = lattice.box(cell);
    const auto children = static_cast<std::uint32_t>(lattice.split() * lattice.split() * lattice.split());
    std::array<double, 6> error2{};
    std::size_t count = 0;
    for (std::uint32_t child = 0; child < children; ++child)
        for (const auto v : lattice.cells()[lattice.cells()[cell].firstChild + child].vertices) {
            if (!volume.quality[v].usable() || std::find(corners.begin(), corners.end(), v) != corners.end()) continue;
            const auto weights = trilinearWeights((lattice.vertices()[v] - box.min) / (box.max - box.min));
            ++count;
            for (std::size_t axis = 0; axis < 6; ++axis) {
                double predicted = 0;
                for (std::size_t i = 0; i < 8; ++i) predicted += double{volume.quality[corners[i]].lux[axis]} * weights[i];
                const double off = predicted - volume.quality[v].lux[axis];
                error2[axis] += off * off;
            }
        }
    for (std::size_t axis = 0; axis < 6 && count > 0; ++axis) out[axis] = static_cast<float>(kSafety / 4 * std::sqrt(error2[axis] / static_cast<double>(count)));
    return count > 0;
}

bool InterpolationError::fromNeighbours(const IrradianceVolume& volume, std::uint32_t cell, Axes& out) const {
    const auto n = volume.lattice.firstLevel();
    const std::array<int, 3> at{static_cast<int>(cell) % n[0], static_cast<int>(cell) / n[0] % n[1], static_cast<int>(cell) / (n[0] * n[1])};
    // Vertices of the first level come first, x fastest.
    const auto quality = [&](const std::array<int, 3>& i) -> const VertexQuality& {
        return volume.quality[static_cast<std::size_t>((i[2] * (n[1] + 1) + i[1]) * (n[0] + 1) + i[0])];
    };
    std::array<double, 6> sums{};
    bool any = false;
    for (int along = 0; along < 3; ++along) {
        std::array<double, 6> bend{};
        int found = 0;
        for (int corner = 0; corner < 8; ++corner) {
            std::array<int, 3> i{at[0] + (corner & 1), at[1] + (corner >> 1 & 1), at[2] + (corner >> 2)};
            auto before = i, after = i;
            --before[along], ++after[along];
            if (before[along] < 0 || after[along] > n[along]) continue;
            const auto &a = quality(before), &b = quality(i), &c = quality(after);
            if (!a.usable() || !b.usable() || !c.usable()) continue;
            any = true, ++found;
            // An eighth of the second difference is the most that interpolation is off where it is the same all over the cell.
            for (std::size_t axis = 0; axis < 6; ++axis) bend[axis] += kSafety / 8 * std::abs(double{a.lux[axis]} - 2.0 * b.lux[axis] + c.lux[axis]);
        }
        for (std::size_t axis = 0; axis < 6 && found > 0; ++axis) sums[axis] += bend[axis] * bend[axis] / (found * found);
    }
    for (std::size_t axis = 0; axis < 6; ++axis) out[axis] = static_cast<float>(std::sqrt(sums[axis]));
    return any;
}

float InterpolationError::halfWidth(std::uint32_t cell, const Vec3& normal) const { return alongAxes(ofCell_[cell], normal); }

}  // namespace luxdeck

#pragma once

#include "engine/volume/volume.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luxdeck {

/// How far interpolation between a volume's vertices is off, cell by cell, judged from the vertices themselves [lx].
///
/// A divided cell's new vertices are compared with what its corners say of their places; where light changes smoothly its
/// children are off by a quarter of that. A cell that is not divided takes the mean second differences at its corners, and
/// where there are none, the volume's mean. The half-width of the 95 % interval is twice what follows: edges of shadows
/// between vertices are worse than smooth light, and may lie outside.
class InterpolationError {
public:
    explicit InterpolationError(const IrradianceVolume& volume);

    /// Half-width (95 %) of the illuminance on a surface that faces `normal` (unit) in a cell without children.
    [[nodiscard]] float halfWidth(std::uint32_t cell, const Vec3& normal) const;

private:
    using Axes = std::array<float, 6>;  // surfaces facing +x -x +y -y +z -z

    bool fromChildren(const IrradianceVolume& volume, std::uint32_t cell, Axes& out) const;
    bool fromNeighbours(const IrradianceVolume& volume, std::uint32_t cell, Axes& out) const;
    void inherit(const IrradianceVolume& volume, std::uint32_t cell, const Axes& error);

    std::vector<Axes> ofCell_;
};

/// x, y and z of a unit vector as the three axes that it points along, weighed by its squares. An axis that it does not
/// point along does not count, whatever its value: what is not known there may be infinite.
template <class Value>
float alongAxes(const std::array<Value, 6>& values, const Vec3& normal) {
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[axis] == 0) continue;
        sum += normal[axis] * normal[axis] * static_cast<float>(values[static_cast<std::size_t>(2 * axis + (normal[axis] < 0 ? 1 : 0))]);
    }
    return sum;
}

}  // namespace luxdeck

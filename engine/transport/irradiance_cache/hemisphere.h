#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"

#include <span>
#include <vector>

namespace luxdeck {

/// How a colour changes along each axis: a vector for each channel.
struct ColourGradient {
    Vec3 r{0, 0, 0}, g{0, 0, 0}, b{0, 0, 0};

    [[nodiscard]] Rgb along(const Vec3& way) const { return {dot(r, way), dot(g, way), dot(b, way)}; }
    void add(const Vec3& axis, const Rgb& value) { r += axis * value.r, g += axis * value.g, b += axis * value.b; }
    ColourGradient& operator+=(const ColourGradient& o) { return r += o.r, g += o.g, b += o.b, *this; }
    ColourGradient& operator*=(float f) { return r *= f, g *= f, b *= f, *this; }
    [[nodiscard]] ColourGradient toWorld(const Frame& frame) const { return {frame.toWorld(r), frame.toWorld(g), frame.toWorld(b)}; }
};

/// A hemisphere about +z cut into rings x sectors cells of equal projected solid angle; cell = ring * sectors + sector,
/// rings from the zenith down.
struct HemisphereCells {
    int rings = 1;
    int sectors = 3;

    /// About as many cells as asked for, about three times as many sectors as rings. Source: Ward & Heckbert 1992.
    static HemisphereCells about(double count);
    [[nodiscard]] int count() const { return rings * sectors; }
    /// A direction of a cell; within: 0 .. 1 each, uniform in projected solid angle.
    [[nodiscard]] Vec3 direction(int cell, Vec2 within) const;
};

/// What one ray of each cell found.
struct HemisphereCell {
    Rgb radiance;         // [cd/m^2]
    float distance = 0;   // to where it is from [m]; infinite: from afar
};

/// Irradiance on a surface and how it changes with the surface's place and normal, in the hemisphere's own axes.
struct IrradianceAndGradients {
    Rgb irradiance;               // [lx]
    ColourGradient rotation;      // to first order E(n) = E + rotation . n, n unit [lx]
    ColourGradient translation;   // E(x) = E(0) + translation . x [lx/m]
};

/// Source: Ward & Heckbert 1992, "Irradiance Gradients"; the rotation here is that of the integral of L (w . n) over the
/// fixed hemisphere, with the mean of tan over each cell. Each cell is taken to have one radiance, and an edge between
/// two cells to belong to what is nearer. The translational gradient is shortened by the part of it that the noise of the
/// cells explains. O(#cells).
///
/// cells          #grid.count()
/// leastDistance  what is nearer counts as this far: no edge can be followed further than to the point above it [m]
IrradianceAndGradients irradianceAndGradients(const HemisphereCells& grid, std::span<const HemisphereCell> cells, float leastDistance = 0);

/// Harmonic mean of distances, infinite ones counting as such [m].
float harmonicMean(std::span<const HemisphereCell> cells);

}  // namespace luxdeck

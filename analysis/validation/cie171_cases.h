#pragma once

#include "analysis/validation/cie171.h"
#include "analysis/validation/cie171_reference.h"
#include "engine/scene/scene_builder.h"

#include <string>
#include <vector>

namespace luxdeck::cie171 {

using Cases = std::vector<Cie171Case>;

void addLampCases(Cases& cases);        // 5.2, 5.3
void addFluxCases(Cases& cases);        // 5.4
void addGlassCases(Cases& cases);       // 5.5
void addReflectionCases(Cases& cases);  // 5.6, 5.7, 5.8
void addRoofCases(Cases& cases);        // 5.9, 5.10
void addFacadeCases(Cases& cases);      // 5.11 .. 5.14

/// A place and the way it faces.
struct Place {
    std::string name;
    Vec3d at{0, 0, 0}, normal{0, 0, 1};
};

inline SensorQuery sensorAt(const Vec3d& at, const Vec3d& normal) { return {Vec3(at), Vec3(normal.normalized()), SensorKind::Planar, {}}; }

/// A figure of a single sensor.
inline Cie171Quantity single(const Place& place, std::string unit, double weight, Cie171Reference reference) {
    return {place.name, std::move(unit), {sensorAt(place.at, place.normal)}, {weight}, false, std::move(reference)};
}

/// Sensors over a patch with weights that integrate over it [m^2], added to those that are there.
void integrateOver(const Patch& patch, const Vec3d& normal, int n, Cie171Quantity& quantity);

/// Adds a wall with a hole: the parts of the unit square that the hole leaves, as four quads.
struct Hole {
    double s0, s1, t0, t1;
};
Patch holeIn(const Patch& wall, const Hole& hole);
void addWall(SceneBuilder& builder, const Patch& wall, const Hole& hole, std::uint32_t material);
inline void addQuad(SceneBuilder& builder, const Patch& patch, std::uint32_t material) {
    builder.quad(Vec3(patch.corner), Vec3(patch.u), Vec3(patch.v), material);
}

/// Of a box from `low` to `high`: west is towards -x, south towards -y.
enum class Face { West, East, South, North, Floor, Ceiling };
Patch faceOf(const Vec3d& low, const Vec3d& high, Face face);
/// Adds the faces that are not open.
void addOtherFaces(SceneBuilder& builder, const Vec3d& low, const Vec3d& high, Face open, std::uint32_t material);

/// 6 mm of clear glass.
inline constexpr double kGlassTransmittance = 0.88, kGlassIor = 1.52;
Material clearGlass();

/// Zenith of every sky [cd/m^2].
inline constexpr double kZenithCdM2 = 1000;
/// The engine's sky of a CIE number (0 uniform, 16 traditional overcast), the ground below it.
Sky engineSky(const ReferenceSky& sky, double groundReflectance);
std::string nameOf(const ReferenceSky& sky);

}  // namespace luxdeck::cie171

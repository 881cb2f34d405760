#pragma once

#include "engine/core/result.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <functional>
#include <string>

namespace luxdeck {

/// Builds scenes by hand, one object at a time: of stability cases, tests and benches.
class SceneBuilder {
public:
    std::uint32_t material(Material m);
    std::uint32_t matte(float reflectance, const std::string& name = "matte");
    /// A one-sided emitter of this radiance [cd/m^2] with a reflectance.
    std::uint32_t glowing(float radianceCdM2, float reflectance);

    /// A parallelogram with normal u x v, split in n x n pieces of two triangles.
    SceneBuilder& quad(Vec3 origin, Vec3 u, Vec3 v, std::uint32_t material, int n = 1);
    /// The six faces of a box, normals inwards (a room) or outwards (an obstacle).
    SceneBuilder& box(Vec3 low, Vec3 high, std::uint32_t material, bool inwards, int n = 1);
    /// A sphere of triangles inscribed in the radius, normals inwards or outwards.
    SceneBuilder& sphere(Vec3 centre, float radius, std::uint32_t material, bool inwards, int segments = 64);
    SceneBuilder& mesh(Mesh mesh);

    /// A luminaire with the same intensity all around: lumens / 4 pi.
    SceneBuilder& isotropic(Vec3 position, double lumens, LuminousOpening opening = {});
    /// A luminaire with intensity candela0 * cos(angle to its nadir), downwards.
    SceneBuilder& lambertian(Vec3 position, double candela0, LuminousOpening opening, Vec3 aim = {0, 0, -1});
    SceneBuilder& luminaire(Vec3 position, CandelaTable table, LuminousOpening opening, Vec3 aim = {0, 0, -1});
    SceneBuilder& sky(Sky sky);
    SceneBuilder& texture(Texture texture);

    /// Checks the scene and gives it away.
    ///
    /// errors  InvalidArgument, as validate()
    Result<Scene> checked();
    /// The same; an invalid scene ends the program.
    Scene build();

private:
    Scene scene_;
};

/// A table by formula of the vertical angle [deg], axial, 181 angles.
CandelaTable axialTable(const std::function<double(double)>& candela);

}  // namespace luxdeck

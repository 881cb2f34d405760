#pragma once

#include "engine/raycast/raycaster.h"
#include "engine/sampling/light_sampler.h"
#include "engine/sampling/sky_sampler.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"
#include "engine/transport/radiance_estimator.h"

#include <functional>
#include <memory>
#include <string>

namespace luxdeck::test {

/// Builds scenes by hand, one object at a time. Shared by tests and benches.
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

    /// Checks the scene and gives it away; aborts the test on an invalid one.
    Scene build();

private:
    Scene scene_;
};

/// A table by formula of the vertical angle [deg], axial, 181 angles.
CandelaTable axialTable(const std::function<double(double)>& candela);

/// A closed cube of side 4 m, reflectance rho, an isotropic point luminaire in the middle.
Scene cubeRoom(float rho, double lumens);
/// A room of 6 x 4 x 2.8 m with coloured walls, three luminaires, a table, a rough metal box and a pane.
Scene furnishedRoom();
/// Everything that SceneNeeds knows, in one small room: mirror, glass, texture, sky through an opening,
/// emitting surface, smooth normals, colour.
Scene richRoom();

/// A scene with all that an estimator stands on.
struct Lit {
    explicit Lit(Scene s, bool bruteForce = false);
    Lit(Scene s, SceneNeeds forced);

    Scene scene;
    SceneNeeds needs;
    std::unique_ptr<Raycaster> raycaster;
    std::unique_ptr<LightSampler> lights;
    std::unique_ptr<Mirrors> mirrors;
    std::unique_ptr<SkySampler> sky;

    [[nodiscard]] TransportScene transport() const { return {scene, needs, *raycaster, *lights, *mirrors, sky.get()}; }
    [[nodiscard]] std::unique_ptr<RadianceEstimator> estimator(const std::string& algorithm,
                                                               const AlgorithmSettings& settings = {}) const;
};

}  // namespace luxdeck::test

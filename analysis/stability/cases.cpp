#include "analysis/stability/cases.h"

namespace luxdeck {

namespace stability {

SceneBuilder& furnace(SceneBuilder& b, float reflectance, Vec3 corner) {
    return b.box(corner, corner + Vec3(4, 4, 4), b.glowing(static_cast<float>(kFurnaceCdM2), reflectance), true, 2);
}

Scene integratingSphere(double metresPerUnit, LuminousOpening opening, double lumens) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, static_cast<float>(1 / metresPerUnit), b.matte(0.5F), true, 128).isotropic({0, 0, 0}, lumens, opening);
    Scene scene = b.build();
    for (auto& mesh : scene.meshes)  // as readers do: stored in the unit, made metres in double
        for (auto& p : mesh.positions) p = Vec3(Vec3d(p) * metresPerUnit);
    return scene;
}

SensorQuery sphereSensor() { return facing({0, 0, -0.999F}, {0, 0, 1}); }

namespace {

/// The sphere is a polyhedron of 128 x 64 faces: its area is 1e-3 smaller, and the sensor lies 1e-3 inside it, where
/// the lamp gives 2e-3 more.
constexpr double kPolyhedron = 5e-3;

}  // namespace

Criterion sphereTotal(double lumens) {
    const double lux = lumens / (4 * kPiD * (1 - 0.5));
    return is(lux, kPolyhedron * lux, "closed form lm / (4 pi R^2 (1 - rho))");
}

Criterion sphereStraight(double lumens) {
    const double lux = lumens / (4 * kPiD);
    return is(lux, kPolyhedron * lux, "closed form I / R^2");
}

}  // namespace stability

const std::vector<StabilityCase>& stabilityCases() {
    static const std::vector<StabilityCase> all = [] {
        stability::Cases cases;
        stability::addReflectionCases(cases);
        stability::addLightCases(cases);
        stability::addGeometryCases(cases);
        stability::addInputCases(cases);
        stability::addSensorCases(cases);
        stability::addGlassCases(cases);
        return cases;
    }();
    return all;
}

}  // namespace luxdeck

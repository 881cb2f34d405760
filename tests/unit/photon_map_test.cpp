// Photons: what leaves the lights is what sensors receive of them, caustics that no path finds, and where their density leaks.
#include "engine/transport/photon_map/photon_field.h"

#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace luxdeck::test {
namespace {

/// Mean illuminance of the square from (-1, -1, 0) to (1, 1, 0) by photons that come straight, with its standard error.
Estimate byPhotons(const Lit& lit) {
    const auto transport = lit.transport();
    const LightEmission emission(transport);
    constexpr std::uint32_t kPhotons = 1 << 18;
    MeanVariance mv;
    for (std::uint32_t i = 0; i < kPhotons; ++i) {
        SamplePath numbers(3, i);
        const auto photon = emission.emit(numbers);
        Hit hit;
        lit.raycaster->closestHits({&photon.ray, 1}, {&hit, 1}, Targets::Surfaces);
        const bool arrives = hit.mesh == 0 && photon.ray.direction.z < 0;
        mv.add(arrives ? double{luminance(photon.power)} / 4 : 0.0);
    }
    return {mv.mean(), std::sqrt(mv.meanVariance())};
}

Estimate bySensors(const Lit& lit) {
    std::vector<SensorQuery> sensors;
    constexpr int kSide = 12;  // midpoints: to 1e-3 of the mean of fields as smooth as these
    for (int i = 0; i < kSide * kSide; ++i)
        sensors.push_back(facing({-1 + 2 * (static_cast<float>(i % kSide) + 0.5F) / kSide, -1 + 2 * (static_cast<float>(i / kSide) + 0.5F) / kSide, 0}, {0, 0, 1}));
    return meanIlluminance(lit, *lit.estimator("direct"), sensors, 0.005).total;
}

/// A table that differs by plane and by type.
CandelaTable lopsided(PhotometryType type) {
    std::vector<double> v, h, candela;
    const bool c = type == PhotometryType::C;
    for (int i = 0; i <= 12; ++i) v.push_back(c ? 10.0 * i : -60.0 + 10.0 * i), h.push_back(c ? 30.0 * i : -60.0 + 10.0 * i);
    for (std::size_t i = 0; i < h.size(); ++i)
        for (std::size_t j = 0; j < v.size(); ++j) candela.push_back(300 + 250 * std::cos(v[j] * kDegree) * (1 + 0.6 * std::cos((h[i] - 40) * kDegree)));
    return *CandelaTable::create(type, v, h, candela);
}

// Invariant: what a surface receives straight is the same by photons and by sensors, whichever the light. 4.5 sigma of a normal
// variate: 7e-6 a comparison; 3e-3 for the midpoints and the flush offset of flat openings.
TEST(LightEmission, ArrivesAsSensorsReceiveIt) {
    std::vector<std::pair<std::string, Scene>> scenes;
    const auto floor = [](SceneBuilder& b) { b.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, b.matte(0)); };
    for (const auto type : {PhotometryType::C, PhotometryType::B, PhotometryType::A})
        for (const auto& opening : {LuminousOpening{}, LuminousOpening{OpeningShape::Rectangle, 1, 0.5, 0}, LuminousOpening{OpeningShape::Box, 0.6, 0.3, 0.4},
                                    LuminousOpening{OpeningShape::Cylinder, 0.4, 0.4, 0.5}}) {
            SceneBuilder b;
            floor(b);
            scenes.emplace_back("luminaire " + std::to_string(static_cast<int>(type)) + ", opening " + std::to_string(static_cast<int>(opening.shape)),
                                b.luminaire({0.4F, 0.2F, 2}, lopsided(type), opening, Vec3(0.2F, -0.3F, -1).normalized()).build());
        }
    SceneBuilder glowing, sky, sun;
    floor(glowing), floor(sky), floor(sun);
    scenes.emplace_back("emitting quad", glowing.quad({-0.5F, -0.3F, 1.5F}, {0, 1, 0.2F}, {1, 0, 0}, glowing.glowing(1000, 0)).build());
    const auto roof = [](SceneBuilder& b) { b.quad({-1, -1, 1}, {1, 0, 0}, {0, 2, 0}, b.matte(0)); };
    roof(sky);  // no shadow of the sun: midpoints do not find its edge
    scenes.emplace_back("overcast sky", sky.sky({SkyKind::CieOvercast, 1000, 0.2, Rgb(1.0F)}).build());
    Sky noon;
    noon.suns.push_back(Sun::ofNormalLux(Vec3(-0.3F, 0.2F, 1).normalized(), 5e4, Rgb(1.0F), 0.05));
    scenes.emplace_back("sun", sun.sky(noon).build());
    for (auto& [name, scene] : scenes) {
        const Lit lit(std::move(scene));
        const auto photons = byPhotons(lit), sensors = bySensors(lit);
        EXPECT_NEAR(photons.value, sensors.value, 4.5 * std::hypot(photons.standardError, sensors.standardError) + 3e-3 * sensors.value) << name;
        EXPECT_GT(sensors.value, 10) << name;
    }
}

std::unique_ptr<PhotonField> fieldOf(const Lit& lit, double effort = 1) {
    AlgorithmSettings settings;
    settings.effort = effort;
    auto field = PhotonField::create(lit.transport(), settings);
    EXPECT_TRUE(field) << field.error().text();
    return *std::move(field);
}

// What the others cannot: light of a point lamp, bent by a glass ball onto the floor. Of the flux that meets the ball, the
// fraction (1 - cos) / 2 of the sphere, Fresnel's equations let through 0.80 to 0.92: (1 - R)^2 where rays meet it straight
// and less at the rim; some of what is thrown back inside leaves downwards too, and 1/25 of the floor's light comes back from the ball.
TEST(PhotonMap, FindsTheCausticOfAPointLamp) {
    SceneBuilder b;
    Material glass;
    glass.name = "glass", glass.kind = MaterialKind::Dielectric, glass.ior = 1.5F, glass.transmittance = Rgb(1.0F);
    b.quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, b.matte(0.5F)).sphere({0, 0, 1}, 0.3F, b.material(glass), false, 64);
    const Lit lit(b.isotropic({0, 0, 2}, 10000).build());
    const auto field = fieldOf(lit);
    double lumens = 0;
    for (std::size_t e = 0; e < field->elements().size(); e += 2) lumens += double{field->elements().areaM2(e)} * double{field->lux(e).g};
    const double met = 10000 * (1 - std::sqrt(1 - 0.09)) / 2;
    EXPECT_GT(lumens, 0.78 * met);
    EXPECT_LT(lumens, 1.0 * met);
    // The bright spot lights a sensor above the floor, which for paths lies in the ball's shadow.
    const auto sensor = facing({0.35F, 0, 0.3F}, {-1, 0, -1});
    const auto withCaustic = illuminance(lit, *lit.estimator("photon_map"), sensor, 0.02).indirect, without = illuminance(lit, *lit.estimator("path"), sensor, 0.02).indirect;
    EXPECT_GT(withCaustic.value, 1.5 * without.value);
}

// By nature: an element that a wall divides has one density. As in radiosity, but its elements are smaller.
// Invariant: the leak is seen, as large as the card says, and a finer mesh has less.
TEST(PhotonMap, LeaksUnderWallsByNature) {
    SceneBuilder b;
    const auto white = b.matte(0.8F);
    b.box({0, 0, 0}, {8, 4, 3}, white, true).quad({3.37F, 0, 0}, {0, 4, 0}, {0, 0, 3}, white);
    const Lit lit(b.isotropic({1.7F, 2, 1.5F}, 10000).build());
    const auto dark = facing({3.6F, 2, 0.3F}, {-1, 0, -1}), bright = facing({1, 2, 1}, {-1, 0, 0});
    const auto leakAt = [&](double effort) {
        AlgorithmSettings settings;
        settings.effort = effort;
        const auto estimator = lit.estimator("photon_map", settings);
        return illuminance(lit, *estimator, dark, 0.02).total.value / illuminance(lit, *estimator, bright, 0.02).total.value;
    };
    const double coarse = leakAt(0.01), usual = leakAt(1);
    EXPECT_GT(usual, 1e-5);
    EXPECT_LT(usual, 0.05);
    EXPECT_LT(usual, coarse / 3);
    EXPECT_EQ(illuminance(lit, *lit.estimator("path"), dark, 0.02).total.value, 0);
}

}  // namespace
}  // namespace luxdeck::test

// Every registered algorithm against every closed form that it claims: |z| < 4 at a 95 % interval of at most
// 0.5 % of the value. False alarms: P(|z| > 4) = 6.3e-5 a check; seeds are fixed, so a pass stays a pass.

#include "tests/support/estimate.h"
#include "engine/algorithms/registry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>

namespace luxdeck::test {
namespace {

struct Case {
    std::string name;
    bool interreflection;                    // only for algorithms that claim it
    std::function<Scene()> scene;
    std::vector<SensorQuery> sensors;        // the expected value is their mean
    double expected;                         // [lx]
    double modelError = 0;                   // known deviation of the scene from the formula, relative
};

/// Quasi-random sensors on the inside of the cube [0, side]^3, the same number on each face.
std::vector<SensorQuery> cubeSensors(float side, int perFace) {
    std::vector<SensorQuery> sensors;
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < perFace; ++i) {
            const int axis = face / 2;
            const float w = face % 2 == 0 ? 0.0F : side;
            const float u = side * (static_cast<float>(i) + 0.5F) / static_cast<float>(perFace);
            const float v = side * unitFloat(reverseBits(static_cast<std::uint32_t>(i)));
            Vec3 p(0, 0, 0), n(0, 0, 0);
            p[axis] = w, p[(axis + 1) % 3] = u, p[(axis + 2) % 3] = v + 0.5F * side / static_cast<float>(perFace);
            n[axis] = face % 2 == 0 ? 1.0F : -1.0F;
            sensors.push_back(facing(p, n));
        }
    return sensors;
}

Scene pointSource() {
    SceneBuilder b;
    return b.isotropic({0, 0, 3}, 10000).build();
}

/// An emitting parallelogram of radiance 1000 cd/m^2, as a mesh.
Scene glowingQuad(Vec3 origin, Vec3 u, Vec3 v) {
    SceneBuilder b;
    return b.quad(origin, u, v, b.glowing(1000, 0)).build();
}

/// A luminaire of uniform luminance 1000 cd/m^2, its flush offset taken back.
Scene uniformLuminaire(OpeningShape shape, double length, double width, double height) {
    SceneBuilder b;
    const double area = shape == OpeningShape::Rectangle ? length * width : kPiD * length * length / 4;
    const LuminousOpening opening{shape, length, width, shape == OpeningShape::Sphere ? length : 0};
    const Vec3 centre{0, 0, static_cast<float>(height)};
    if (shape == OpeningShape::Sphere) return b.isotropic(centre, 1000 * area * 4 * kPiD, opening).build();
    return b.lambertian(centre + Vec3(0, 0, kFlushM), 1000 * area, opening).build();
}

/// Illuminance from a uniform polygon. Source: Lambert's contour formula, LIGHTING-FACTS F.3.
double polygonLux(const std::vector<Vec3d>& corners, const Vec3d& at, const Vec3d& normal, double radiance) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = (corners[i] - at).normalized(), b = (corners[(i + 1) % corners.size()] - at).normalized();
        const Vec3d c = a.cross(b);
        sum += std::atan2(c.length(), a.dot(b)) * normal.dot(c.normalized());
    }
    return std::abs(sum) * radiance / 2;
}

Scene furnace(float rho) {
    SceneBuilder b;
    return b.box({0, 0, 0}, {4, 4, 4}, b.glowing(10, rho), true, 2).build();
}

Scene integratingSphere() {
    SceneBuilder b;
    return b.sphere({0, 0, 0}, 1, b.matte(0.5F), true, 256).isotropic({0, 0, 0}, 1000).build();
}

Scene underSky(SkyKind kind) {
    SceneBuilder b;
    return b.sky({kind, 1000, 0.0, Rgb(1.0F)}).build();
}

/// Reflectance of one glass surface at normal incidence, n = 1.52.
constexpr float kGlassNormal = 0.52F * 0.52F / (2.52F * 2.52F);

/// A pane of clear glass between lamp and sensor, met at 60 degrees.
Scene throughPane() {
    SceneBuilder b;
    Material glass;
    glass.kind = MaterialKind::ThinGlass;
    glass.transmittance = Rgb((1 - kGlassNormal) / (1 + kGlassNormal));  // nothing absorbed inside
    glass.ior = 1.52F;
    b.quad({-50, -50, 1}, {100, 0, 0}, {0, 100, 0}, b.material(glass));
    return b.isotropic({2 * std::sqrt(3.0F), 0, 2}, 4 * kPiD * 1600).build();
}

std::vector<Case> cases() {
    const SensorQuery floor = facing({0, 0, 0}, {0, 0, 1});
    std::vector<Case> all{
        {"point_below", false, pointSource, {floor}, 10000 / (4 * kPiD) / 9},
        {"point_at_4m", false, pointSource, {facing({4, 0, 0}, {0, 0, 1})}, 10000 / (4 * kPiD) * 3 / 125},
        {"rectangle_luminaire", false, [] { return uniformLuminaire(OpeningShape::Rectangle, 2, 1, 3); }, {floor}, 203.626},
        {"disc_luminaire", false, [] { return uniformLuminaire(OpeningShape::Disc, 1, 1, 2); }, {floor}, 184.800},
        {"sphere_luminaire", false, [] { return uniformLuminaire(OpeningShape::Sphere, 1, 1, 2); }, {floor}, 196.350},
        {"quad_parallel", false, [] { return glowingQuad({-1, -0.5F, 3}, {0, 1, 0}, {2, 0, 0}); }, {floor}, 203.626},
        {"quad_perpendicular", false, [] { return glowingQuad({1.5F, 0, 0}, {0, 0, 2}, {0, 3, 0}); }, {floor}, 290.757},
        {"quad_contour", false, [] { return glowingQuad({-1, -2, 1}, {0.5F, 3, 1}, {2, 0, 0.2F}); }, {facing({0.3F, 0.1F, 0}, {0.2F, -0.1F, 1})},
         polygonLux({{-1, -2, 1}, {-0.5, 1, 2}, {1.5, 1, 2.2}, {1, -2, 1.2}}, Vec3d(0.3F, 0.1F, 0), Vec3d(0.2, -0.1, 1).normalized(), 1000)},
        {"sky_uniform", false, [] { return underSky(SkyKind::Uniform); }, {floor}, kPiD * 1000},
        {"sky_overcast", false, [] { return underSky(SkyKind::CieOvercast); }, {floor}, 7 * kPiD / 9 * 1000},
        {"sky_overcast_vertical", false, [] { return underSky(SkyKind::CieOvercast); }, {facing({0, 0, 0}, {1, 0, 0})}, 0.396177 * 7 * kPiD / 9 * 1000},
        {"sky_cylinder", false, [] { return underSky(SkyKind::Uniform); }, {{{0, 0, 0}, {0, 0, 1}, SensorKind::Cylindrical, {}}}, kPiD * 1000 / 2},
        // Clear glass, n = 1.52: T(60 deg) = 0.8435 with all interreflections (F.6); I cos / d^2 = 1600 * 0.5 / 16.
        {"pane_at_60_degrees", false, throughPane, {floor}, 50 * 0.8435, 1e-4},
        {"furnace_0.8", true, [] { return furnace(0.8F); }, {facing({1, 1.3F, 0}, {0, 0, 1})}, kPiD * 10 / 0.2},
        {"furnace_corner", true, [] { return furnace(0.8F); }, {facing({0.01F, 0.01F, 0}, {0, 0, 1})}, kPiD * 10 / 0.2},
        {"furnace_0.95", true, [] { return furnace(0.95F); }, {facing({1, 1.3F, 0}, {0, 0, 1})}, kPiD * 10 / 0.05},
        {"furnace_free_sensor", true, [] { return furnace(0.5F); }, {facing({1, 2, 3}, {1, 2, -2})}, kPiD * 10 / 0.5},
        {"furnace_cylinder", true, [] { return furnace(0.5F); }, {{{2, 1, 2}, {0, 0, 1}, SensorKind::Cylindrical, {}}}, kPiD * 10 / 0.5},
        // The sphere is a polyhedron inscribed with 256 x 128 faces: its area is 2.6e-4 smaller (measured below).
        {"integrating_sphere", true, integratingSphere, {facing({0, 0, -0.9998F}, {0, 0, 1}), facing({0.9998F, 0, 0}, {-1, 0, 0})}, 159.155, 1e-3},
    };
    for (const float rho : {0.2F, 0.5F, 0.8F, 0.95F})
        all.push_back({"cube_mean_" + std::to_string(rho).substr(0, 4), true, [rho] { return cubeRoom(rho, 10000); }, cubeSensors(4, 64),
                       10000 / (96 * (1 - double{rho})),
                       // 64 stratified points a face average the direct field, I cos / d^2, to 2e-3 of its mean.
                       3e-3});
    return all;
}

/// A closed form and an algorithm that claims it.
struct Claim {
    Case closedForm;
    Algorithm algorithm;
};

void PrintTo(const Claim& c, std::ostream* out) { *out << c.closedForm.name << " by " << c.algorithm.name; }

/// Every registered algorithm with every case that it claims.
std::vector<Claim> claims() {
    std::vector<Claim> all;
    for (const auto& c : cases())
        for (const auto& a : algorithms())
            if (a.interreflection || !c.interreflection) all.push_back({c, a});
    return all;
}

class ClosedForm : public testing::TestWithParam<Claim> {};

TEST_P(ClosedForm, IsMet) {
    const auto& [c, algorithm] = GetParam();
    const Lit lit(c.scene());
    const auto estimator = lit.estimator(algorithm.name);
    const auto e = meanIlluminance(lit, *estimator, c.sensors, 0.005).total;
    EXPECT_LE(1.96 * e.standardError, 0.005 * e.value) << "the interval asked for was not reached";
    // The five to six digits of the tabulated values add 1e-5; rounding in float 1e-6 of each of the terms.
    const double slack = (c.modelError + 1e-5 + algorithm.bias) * c.expected;
    EXPECT_LT(std::abs(e.value - c.expected), 4 * e.standardError + slack)
        << "value " << e.value << " +- " << 1.96 * e.standardError << ", expected " << c.expected;
}

std::string nameOf(const testing::TestParamInfo<ClosedForm::ParamType>& info) {
    auto name = info.param.closedForm.name + "_by_" + info.param.algorithm.name;
    for (auto& ch : name)
        if (ch == '.') ch = 'p';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, ClosedForm, testing::ValuesIn(claims()), nameOf);

// The flux that a luminaire sends through a closed black sphere is the flux of its table.
TEST(LuminaireFlux, ArrivesOnASphereAroundIt) {
    for (const auto shape : {OpeningShape::Point, OpeningShape::Rectangle, OpeningShape::Disc, OpeningShape::Box, OpeningShape::Cylinder, OpeningShape::Sphere}) {
        const auto table = axialTable([](double v) { return 300 + 200 * std::cos(2 * v * kDegree) + 100 * std::cos(v * kDegree); });
        const double lumens = table.lumens();
        SceneBuilder b;
        const LuminousOpening opening{shape, 0.4, shape == OpeningShape::Rectangle || shape == OpeningShape::Box ? 0.3 : 0.4,
                                      shape == OpeningShape::Rectangle || shape == OpeningShape::Disc ? 0 : shape == OpeningShape::Sphere ? 0.4 : 0.2};
        const Lit lit(b.luminaire({0, 0, 0}, table, opening).build());
        std::vector<SensorQuery> sensors;
        constexpr int kSensors = 2048;  // a Fibonacci lattice: integrates smooth fields to better than 1e-4
        for (int i = 0; i < kSensors; ++i) {
            const double z = 1 - (2 * i + 1.0) / kSensors, phi = i * kPiD * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
            const Vec3 d(static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)), static_cast<float>(z));
            sensors.push_back(facing(d * 2, -d));
        }
        const auto e = meanIlluminance(lit, *lit.estimator("direct"), sensors, 0.002).total;
        const double flux = e.value * 4 * kPiD * 4;
        // The far-field candela hold at every point of the opening: the flux through a sphere of any radius is
        // that of the table but for the flush offset and the floor of the projected area at grazing angles (1e-3).
        EXPECT_NEAR(flux / lumens, 1, 4 * e.standardError / e.value + 2e-3) << "shape " << static_cast<int>(shape);
    }
}

}  // namespace
}  // namespace luxdeck::test

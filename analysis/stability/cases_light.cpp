#include "analysis/stability/cases.h"

#include <cmath>

namespace luxdeck::stability {

namespace {

/// A lamp of this luminance and diameter: its flux is pi^2 L d^2.
constexpr double kTinyCdM2 = 1e6, kTinyM = 1e-3;
constexpr double kTinyLumens = kPiD * kPiD * kTinyCdM2 * kTinyM * kTinyM;

Scene tinySquare() {
    SceneBuilder b;
    const float side = static_cast<float>(kTinyM);
    return b.quad({-side / 2, -side / 2, 2}, {0, side, 0}, {side, 0, 0}, b.glowing(static_cast<float>(kTinyCdM2), 0)).build();
}

/// A spot of 2 degrees, 8 m below a ceiling that reflects everything; nothing else reflects.
struct SpotAtCeiling {
    static constexpr float kBelowM = 8, kSensorM = 2;
    static CandelaTable table() { return axialTable([](double v) { return v < 1 ? 1e6 : 0.0; }); }
    static Scene scene() {
        SceneBuilder b;
        b.quad({-20, -20, 0}, {0, 40, 0}, {40, 0, 0}, b.matte(1, "ceiling"));
        return b.luminaire({0, 0, -kBelowM}, table(), {}, {0, 0, 1}).build();
    }
    /// The table falls from 10^6 cd at the axis to 0 at 1 degree in a straight line; over the lit disc of radius a,
    /// each ring reflects I cos / d^2 / pi and reaches the sensor with cos^2 / D^2.
    static double lux() {
        constexpr int kRings = 4000;
        const double most = kDegree;
        double sum = 0;
        for (int i = 0; i < kRings; ++i) {
            const double angle = (i + 0.5) * most / kRings, radius = kBelowM * std::tan(angle);
            const double intensity = 1e6 * (1 - angle / most);
            const double solidAngle = 2 * kPiD * std::sin(angle) * most / kRings;
            const double d2 = radius * radius + kSensorM * kSensorM;
            sum += intensity * solidAngle / kPiD * kSensorM * kSensorM / (d2 * d2);
        }
        return sum;
    }
};

constexpr double kSunLux = 1e5, kHoleM = 0.01, kSheetM = 3;

/// A black sheet with a square hole, the sun in the zenith.
Scene sunThroughHole() {
    SceneBuilder b;
    const auto black = b.matte(0);
    const float h = static_cast<float>(kHoleM / 2), z = static_cast<float>(kSheetM), far = 50;
    b.quad({-far, -far, z}, {2 * far, 0, 0}, {0, far - h, 0}, black).quad({-far, h, z}, {2 * far, 0, 0}, {0, far - h, 0}, black);
    b.quad({-far, -h, z}, {far - h, 0, 0}, {0, 2 * h, 0}, black).quad({h, -h, z}, {far - h, 0, 0}, {0, 2 * h, 0}, black);
    Sky sky;
    sky.suns.push_back(Sun::ofNormalLux({0, 0, 1}, kSunLux));
    return b.sky(sky).build();
}

/// From its centre's sensor the hole lies wholly within the disc: luminance of the sun times the hole's solid angle.
double sunThroughHoleLux() {
    return kSunLux / (kPiD * std::pow(std::sin(kSunHalfAngle), 2)) * kHoleM * kHoleM / (kSheetM * kSheetM);
}

constexpr int kRows = 100;
constexpr float kGapM = 0.5F, kHeightM = 3;

Scene manyLuminaires() {
    SceneBuilder b;
    Scene scene = b.isotropic({0, 0, 0}, 4 * kPiD).build();  // 1 cd
    auto one = scene.luminaires.front();
    scene.luminaires.clear();
    for (int i = 0; i < kRows * kRows; ++i) {
        one.position = {kGapM * static_cast<float>(i % kRows), kGapM * static_cast<float>(i / kRows), kHeightM};
        scene.luminaires.push_back(one);
    }
    return scene;
}

double manyLuminairesLux(const Vec3d& at) {
    double sum = 0;
    for (int i = 0; i < kRows * kRows; ++i) {
        const Vec3d to = Vec3d(double{kGapM} * (i % kRows), double{kGapM} * (i / kRows), kHeightM) - at;
        sum += to.z / std::pow(to.length(), 3);
    }
    return sum;
}

}  // namespace

void addLightCases(Cases& cases) {
    const LuminousOpening ball{OpeningShape::Sphere, kTinyM, kTinyM, kTinyM};
    cases.push_back({"light of 1 mm, 10^6 cd/m2", [ball]() -> Result<Scene> { return integratingSphere(1, ball, kTinyLumens); },
                     {sphereSensor()}, sphereTotal(kTinyLumens), sphereStraight(kTinyLumens)});
    const auto square = is(kTinyCdM2 * kTinyM * kTinyM / 4, 1e-4, "closed form L A / d^2; rounding of 1 mm in float");
    cases.push_back({"emitting square of 1 mm, 10^6 cd/m2", []() -> Result<Scene> { return tinySquare(); }, {facing({0, 0, 0}, {0, 0, 1})},
                     square, square});
    StabilityCase spot{"spot of 2 degrees at a ceiling of reflectance 1", []() -> Result<Scene> { return SpotAtCeiling::scene(); },
                       {facing({0, 0, -SpotAtCeiling::kSensorM}, {0, 0, 1})},
                       is(SpotAtCeiling::lux(), 0.01 * SpotAtCeiling::lux(), "integral over the lit disc; 1 % for the table's float angles at 1 degree"),
                       is(0, 0, "the spot shines away from the sensor")};
    spot.precision = 0.15, spot.mostPaths = 1U << 18;  // one path in a thousand meets the lit disc
    cases.push_back(spot);
    const auto sun = is(sunThroughHoleLux(), 1e-3 * sunThroughHoleLux(), "closed form L A / d^2; float rounding of the sun's directions");
    cases.push_back({"sun of 0.533 degrees through a hole of 1 cm", []() -> Result<Scene> { return sunThroughHole(); },
                     {facing({0, 0, 0}, {0, 0, 1})}, sun, sun});
    const Vec3 at(21.3F, 17.7F, 0);
    const auto many = is(manyLuminairesLux(Vec3d(at)), 1e-4 * manyLuminairesLux(Vec3d(at)), "sum of I cos / d^2");
    cases.push_back({"10,000 luminaires", []() -> Result<Scene> { return manyLuminaires(); }, {facing(at, {0, 0, 1})}, many, many});
    const auto dark = is(0, 0, "no light, no illuminance: exactly");
    cases.push_back({"room without lights", []() -> Result<Scene> {
                         SceneBuilder b;
                         return b.box({0, 0, 0}, {4, 4, 4}, b.matte(0.5F), true).checked();
                     }, {facing({2, 2, 0}, {0, 0, 1})}, dark, dark});
    cases.push_back({"empty scene", []() -> Result<Scene> { return Scene{}; }, {facing({0, 0, 0}, {0, 0, 1})}, dark, dark});
}

}  // namespace luxdeck::stability

#include "engine/io/project_aim.h"
#include "engine/io/project_colour.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luxdeck {
namespace {

void expectNear(const Vec3& got, const Vec3& expected) {
    EXPECT_LT((got - expected).length(), 1e-6F) << got << " is not " << expected;  // a few roundings of floats near 1
}

TEST(LuminaireFrame, HangsAsDocumented) {
    const auto down = luminaireFrame({0, 0, -1}, 0);
    expectNear(down.tangent, {1, 0, 0});
    expectNear(down.bitangent, {0, 1, 0});
    expectNear(down.normal, {0, 0, 1});
    const auto turned = luminaireFrame({0, 0, -2}, 90);
    expectNear(turned.tangent, {0, 1, 0});
    expectNear(turned.bitangent, {-1, 0, 0});
    const auto east = luminaireFrame({1, 0, 0}, 0);
    expectNear(east.tangent, {0, 0, 1});
    expectNear(east.bitangent, {0, 1, 0});
    const auto north = luminaireFrame({0, 5, 0}, 0);
    expectNear(north.tangent, {1, 0, 0});
    expectNear(north.bitangent, {0, 0, 1});
    const auto up = luminaireFrame({0, 0, 1}, 0);
    expectNear(up.tangent, {-1, 0, 0});
    expectNear(up.bitangent, {0, 1, 0});
    expectNear(up.normal, {0, 0, -1});
}

TEST(LuminaireFrame, IsRightHandedAndOrthonormalForAnyAim) {
    for (int i = 0; i < 2000; ++i) {
        // Points of a spiral over the sphere, and ever closer to straight up.
        const double z = 1.0 - 2.0 * (i + 0.5) / 2000, turn = 2.4 * i, side = i % 2 == 0 ? std::sqrt(1 - z * z) : std::pow(0.99, i);
        const auto f = luminaireFrame({side * std::cos(turn), side * std::sin(turn), i % 2 == 0 ? z : 1.0}, 7.0 * i);
        expectNear(cross(f.tangent, f.bitangent), f.normal);
        EXPECT_NEAR(dot(f.tangent, f.bitangent), 0.0F, 1e-6F);  // float rounding
        EXPECT_NEAR(f.tangent.length(), 1.0F, 1e-6F);
    }
}

TEST(LuminaireFrame, IsContinuousAboutStraightDown) {
    for (int i = 0; i < 12; ++i) {
        const double tilt = 1e-4, turn = 30.0 * i * kDegree;
        const auto f = luminaireFrame({tilt * std::cos(turn), tilt * std::sin(turn), -1}, 0);
        EXPECT_LT((f.tangent - Vec3(1, 0, 0)).length(), 2e-4F);  // no axis turns further than the aim did
    }
}

/// IES LM-72, counter-clockwise from east: what each angle alone does, and orientation before tilt.
TEST(LuminaireFrame, TurnsByLm72) {
    const auto level = luminaireFrame(AimAngles{.orientDeg = 30});
    expectNear(level.tangent, {std::sqrt(0.75F), 0.5F, 0});
    expectNear(level.normal, {0, 0, 1});
    const auto east = luminaireFrame(AimAngles{.tiltDeg = 90});
    expectNear(-east.normal, {1, 0, 0});
    expectNear(east.tangent, {0, 0, 1});
    expectNear(east.bitangent, {0, 1, 0});
    const auto north = luminaireFrame(AimAngles{.orientDeg = 90, .tiltDeg = 90});
    expectNear(-north.normal, {0, 1, 0});
    expectNear(north.tangent, {0, 0, 1});
    expectNear(north.bitangent, {-1, 0, 0});
    expectNear(-luminaireFrame(AimAngles{.rollDeg = 90}).normal, {0, 1, 0});
    expectNear(luminaireFrame(AimAngles{.spinDeg = 90}).tangent, {0, 1, 0});
    const auto spun = luminaireFrame(AimAngles{.tiltDeg = 90, .spinDeg = 90});
    expectNear(spun.tangent, {0, 1, 0});  // C0 goes to where C90 was
    expectNear(-spun.normal, {1, 0, 0});
}

TEST(LuminaireFrame, OrientationTiltAndSpinSayWhatAimAndRotationSay) {
    for (int i = 0; i < 200; ++i) {
        const double tilt = 0.3 + 2.5 * i / 200, turn = 2.4 * i, spin = 7.0 * i;
        const Vec3d aim(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), -std::cos(tilt));
        auto angles = uprightAim(aim * 3.0);
        const auto upright = luminaireFrame(angles);
        EXPECT_GE(upright.tangent.z, 0) << "its up is up";
        EXPECT_NEAR(upright.bitangent.z, 0, 1e-6F);
        // The smallest turn keeps C0 where it was: it is the tilt about a horizontal axis with -orient spun in.
        angles.spinDeg = spin - angles.orientDeg;
        const auto same = luminaireFrame(aim, spin);
        const auto f = luminaireFrame(angles);
        expectNear(f.tangent, same.tangent);
        expectNear(f.normal, same.normal);
    }
    EXPECT_EQ(uprightAim({0, 0, -2}).orientDeg, 0);
    EXPECT_EQ(uprightAim({0, 0, -2}).tiltDeg, 0);
    EXPECT_EQ(uprightAim({0, 0, 1}).tiltDeg, 180);
}

TEST(DaylightColour, WhiteIsExactAndLuminanceIsOne) {
    EXPECT_EQ(daylightColour(6500), Rgb(1.0F));
    for (double kelvin = 1667; kelvin <= 25000; kelvin *= 1.03) {
        const auto c = daylightColour(kelvin);
        EXPECT_NEAR(luminance(c), 1.0F, 1e-6F) << kelvin;  // float rounding
        EXPECT_GE(c.min(), 0.0F) << kelvin;
    }
}

TEST(DaylightColour, TurnsFromRedToBlueWithoutSteps) {
    auto before = daylightColour(1667);
    for (double kelvin = 1670; kelvin <= 25000; kelvin += 10) {
        const auto c = daylightColour(kelvin);
        EXPECT_LE(c.r, before.r + 1e-3F) << kelvin;  // the fits' pieces meet to 1e-4 in x and y
        EXPECT_GE(c.b, before.b - 1e-3F) << kelvin;
        EXPECT_LT(std::abs(c.r - before.r), 0.02F) << kelvin;  // 10 K at 1700 K is 0.6 %, of a red near 3
        before = c;
    }
}

TEST(DaylightColour, IncandescentLightHasItsKnownChromaticity) {
    // CIE illuminant A (2856 K) has xy 0.4476, 0.4074. The fit of the locus is good to 0.001; white at 6500 K differs
    // from D65 by 0.0005; the matrix below has four digits.
    const auto c = daylightColour(2856);
    const double x = 0.4124 * c.r + 0.3576 * c.g + 0.1805 * c.b;
    const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    const double z = 0.0193 * c.r + 0.1192 * c.g + 0.9505 * c.b;
    EXPECT_NEAR(x / (x + y + z), 0.4476, 0.002);
    EXPECT_NEAR(y / (x + y + z), 0.4074, 0.002);
}

}  // namespace
}  // namespace luxdeck

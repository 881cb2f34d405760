// CandelaTable: directions of types A, B and C, interpolation, closed-form flux, refusal of bad tables.
#include "engine/scene/candela_table.h"
#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck {
namespace {

// The direction of angles (V, H), built by rotations rather than by the formulas of the class.
Vec3 directionOf(PhotometryType type, double verticalDegrees, double horizontalDegrees) {
    const double v = verticalDegrees * kDegree;
    const double h = horizontalDegrees * kDegree;
    const Vec3d aim(0, 0, -1);
    const Vec3d up(1, 0, 0);
    const Vec3d right = aim.cross(up);  // of a viewer behind the luminaire
    if (type == PhotometryType::C) {
        const Vec3d plane(std::cos(h), std::sin(h), 0);
        return Vec3(aim * std::cos(v) + plane * std::sin(v));
    }
    if (type == PhotometryType::B) {  // the plane turns up by V about `right`; H is counted in the plane
        const Vec3d inPlane = aim * std::cos(v) + up * std::sin(v);
        return Vec3(inPlane * std::cos(h) + right * std::sin(h));
    }
    const Vec3d inPlane = aim * std::cos(h) + right * std::sin(h);  // turned about `up` by H
    return Vec3(inPlane * std::cos(v) + up * std::sin(v));
}

std::vector<double> irregularAngles(RandomStream& random, double low, double high, int inner) {
    std::vector<double> angles{low, high};
    for (int i = 0; i < inner; ++i) angles.push_back(low + (high - low) * random.uniform());
    std::sort(angles.begin(), angles.end());
    return angles;
}

CandelaTable randomTable(PhotometryType type, RandomStream& random) {
    const bool c = type == PhotometryType::C;
    const double low = c ? 60 * random.uniform() : -90 + 60 * random.uniform();
    const double high = c ? 100 + 80 * random.uniform() : 30 + 60 * random.uniform();
    const auto vertical = irregularAngles(random, low, high, 7);
    const auto horizontal = c ? irregularAngles(random, 0, 360, 9) : irregularAngles(random, -85, 75, 9);
    std::vector<double> candela(vertical.size() * horizontal.size());
    for (double& value : candela) value = 1000 * random.uniform();
    return *CandelaTable::create(type, vertical, horizontal, candela);
}

// Mean over a Fibonacci lattice on the sphere, times 4 pi.
double fluxByLattice(const CandelaTable& table, double* downward = nullptr) {
    constexpr int kPoints = 1'000'000;
    const double golden = kPiD * (3 - std::sqrt(5.0));
    double sum = 0;
    double down = 0;
    for (int i = 0; i < kPoints; ++i) {
        const double z = 1 - (2 * i + 1.0) / kPoints;
        const double r = std::sqrt(1 - z * z);
        const double value = table.intensity(Vec3(Vec3d(r * std::cos(golden * i), r * std::sin(golden * i), z)));
        sum += value;
        if (z < 0) down += value;
    }
    if (downward) *downward = 4 * kPiD * down / kPoints;
    return 4 * kPiD * sum / kPoints;
}

class EveryType : public testing::TestWithParam<PhotometryType> {};
INSTANTIATE_TEST_SUITE_P(Types, EveryType, testing::Values(PhotometryType::C, PhotometryType::B, PhotometryType::A));

TEST_P(EveryType, ClosedFormFluxIsTheIntegralOfTheIntensity) {
    RandomStream random(7);
    for (int trial = 0; trial < 4; ++trial) {
        const CandelaTable table = randomTable(GetParam(), random);
        double down = 0;
        const double flux = fluxByLattice(table, &down);
        // The lattice's error on a function that jumps at a smooth border is of the order of N^-3/4 = 3e-5 of the
        // jump times the sphere; the lit part is at least a tenth of it, hence below 3e-4 of the flux.
        EXPECT_NEAR(table.lumens() / flux, 1, 5e-4);
        EXPECT_NEAR(table.lumensDown() / down, 1, 5e-4);
    }
}

TEST_P(EveryType, ReproducesItsValuesAtItsAnglesAndIsBilinearBetween) {
    RandomStream random(11);
    const CandelaTable table = randomTable(GetParam(), random);
    const auto& v = table.vertical();
    const auto& h = table.horizontal();
    const auto at = [&](std::size_t i, std::size_t j) { return table.candela()[j * v.size() + i]; };
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
        for (std::size_t j = 0; j + 1 < h.size(); ++j) {
            const double s = random.uniform();
            const double t = random.uniform();
            const double expected = (1 - s) * (1 - t) * at(i, j) + s * (1 - t) * at(i + 1, j) +
                                    (1 - s) * t * at(i, j + 1) + s * t * at(i + 1, j + 1);
            const Vec3 d = directionOf(GetParam(), v[i] + s * (v[i + 1] - v[i]), h[j] + t * (h[j + 1] - h[j]));
            // A float direction is good to 1e-7 rad / sin(polar angle) ~ 1e-4 degrees here; the narrowest cells are
            // some hundredths of a degree wide and 1000 cd high: about 1 cd.
            EXPECT_NEAR(table.intensity(d), expected, 2.0) << "V " << v[i] << " H " << h[j];
        }
    }
}

TEST_P(EveryType, LinearTableFindsTheAngleAnywhere) {
    const bool c = GetParam() == PhotometryType::C;
    const std::vector<double> vertical = c ? std::vector<double>{0, 90, 180} : std::vector<double>{-90, 0, 90};
    const std::vector<double> horizontal = c ? std::vector<double>{0, 180, 360} : std::vector<double>{-90, 0, 90};
    std::vector<double> candela;
    for (const double h : horizontal) {
        for (const double v : vertical) candela.push_back(1000 + v + 2 * h);
    }
    const auto table = CandelaTable::create(GetParam(), vertical, horizontal, candela);
    ASSERT_TRUE(table) << table.error().text();
    RandomStream random(3);
    for (int i = 0; i < 2000; ++i) {
        const double v = c ? 1 + 178 * random.uniform() : -88 + 176 * random.uniform();
        const double h = c ? 0.1 + 359.8 * random.uniform() : -88 + 176 * random.uniform();
        // Within 1 degree of a pole (sin = 0.017) a float direction fixes the angle about it to 6e-8/0.017 rad =
        // 2e-4 degrees, doubled by the slope; float values around 2000 add 2e-4.
        EXPECT_NEAR(table->intensity(directionOf(GetParam(), v, h)), 1000 + v + 2 * h, 2e-3) << v << " " << h;
    }
}

TEST(CandelaTable, AimIsDownAndUpIsTowardsX) {
    // Type B: 10 per degree of V upwards, 1 per degree of H to the right.
    const auto table = CandelaTable::create(PhotometryType::B, {-90, 90}, {-90, 90}, {10, 1810, 190, 1990});
    ASSERT_TRUE(table);
    EXPECT_NEAR(table->intensity({0, 0, -1}), 1000, 1e-3);
    EXPECT_NEAR(table->intensity({std::sqrt(0.5F), 0, -std::sqrt(0.5F)}), 1450, 1e-2);
    EXPECT_NEAR(table->intensity({0, -std::sqrt(0.5F), -std::sqrt(0.5F)}), 1045, 1e-2);
    EXPECT_EQ(table->intensity({0, 0, 1}), 0);
    EXPECT_DOUBLE_EQ(table->lumensDown(), table->lumens());
}

TEST(CandelaTable, KnownFluxes) {
    // Constant: 4 pi I. Exact in closed form, so only rounding remains.
    const auto sphere = CandelaTable::create(PhotometryType::C, {0, 180}, {0}, {100, 100});
    EXPECT_NEAR(sphere->lumens(), 400 * kPiD, 1e-9);
    EXPECT_NEAR(sphere->lumensDown(), 200 * kPiD, 1e-9);
    // Linear in v from 1 at the nadir to 0 at 90: 2 pi integral (1 - 2v/pi) sin v = 2 pi (1 - 2/pi).
    const auto linear = CandelaTable::create(PhotometryType::C, {0, 90}, {0, 180, 360}, {1, 0, 1, 0, 1, 0});
    EXPECT_NEAR(linear->lumens(), 2 * kPiD * (1 - 2 / kPiD), 1e-12);
    // Constant over the half sphere of types A and B: 2 pi I.
    for (const auto type : {PhotometryType::A, PhotometryType::B}) {
        EXPECT_NEAR(CandelaTable::create(type, {-90, 90}, {-90, 90}, {1, 1, 1, 1})->lumens(), 2 * kPiD, 1e-12);
    }
}

TEST(CandelaTable, EdgesOfTheRange) {
    const auto table = CandelaTable::create(PhotometryType::C, {0, 30, 90}, {0}, {300, 200, 100});
    EXPECT_FLOAT_EQ(table->intensity({0, 0, -1}), 300);
    EXPECT_FLOAT_EQ(table->intensity({1, 0, 0}), 100);  // the horizontal itself still belongs to it
    EXPECT_EQ(table->intensity({std::cos(0.01F), 0, std::sin(0.01F)}), 0);
    EXPECT_EQ(table->maxIntensity(), 300);
    EXPECT_EQ(CandelaTable().intensity({0, 0, -1}), 0);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(table->intensity({nan, nan, nan}) > 300);  // no read outside the table either
}

TEST(CandelaTable, SeamAt360IsContinuous) {
    const auto table = CandelaTable::create(PhotometryType::C, {0, 90}, {0, 120, 240, 360}, {9, 1, 9, 5, 9, 7, 9, 1});
    // 1e-4 degrees either side of C0, slope at most 6 cd in 120 degrees.
    EXPECT_NEAR(table->intensity({1, 2e-6F, 0}), table->intensity({1, -2e-6F, 0}), 1e-4);
    EXPECT_NEAR(table->intensity({0, 1, 0}), 1 + 4 * 0.75, 1e-4);  // C90
    EXPECT_NEAR(table->intensity({0, -1, 0}), 7 - 6 * 0.25, 1e-4);  // C270
}

TEST(CandelaTable, RefusesWhatIsNoTable) {
    const auto refusal = [](PhotometryType type, std::vector<double> v, std::vector<double> h, std::vector<double> c) {
        const auto table = CandelaTable::create(type, std::move(v), std::move(h), std::move(c));
        return table ? std::string("accepted") : table.error().message;
    };
    using enum PhotometryType;
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(C, {}, {0}, {}), "0 vertical angle(s), expected at least 2");
    EXPECT_EQ(refusal(C, {0, 90}, {}, {}), "0 horizontal angles from 0 to 0, expected the single 0 or 0..360");
    EXPECT_EQ(refusal(C, {0, 90}, {0, 90}, {1, 1, 1, 1}),
              "2 horizontal angles from 0 to 90, expected the single 0 or 0..360");
    EXPECT_EQ(refusal(B, {0, 90}, {0}, {1, 1}), "1 horizontal angle(s) in type A or B, expected at least 2");
    EXPECT_EQ(refusal(C, {0, 190}, {0}, {1, 1}), "vertical angle 1 is 190, expected 0..180 degrees");
    EXPECT_EQ(refusal(C, {0, nan}, {0}, {1, 1}), "vertical angle 1 is nan, expected 0..180 degrees");
    EXPECT_EQ(refusal(C, {0, 50, 50}, {0}, {1, 1, 1}), "vertical angle 2 is 50, expected more than the one before, 50");
    EXPECT_EQ(refusal(C, {0, 90}, {0}, {1, 1, 1}), "3 candela values, expected 1 x 2");
    EXPECT_EQ(refusal(C, {0, 90}, {0}, {1, -2}), "candela value 1 of plane 0 is -2, expected finite and >= 0");
    EXPECT_EQ(refusal(C, {0, 90}, {0, 360}, {1, 1, 1, inf}),
              "candela value 1 of plane 1 is inf, expected finite and >= 0");
}

}  // namespace
}  // namespace luxdeck

// What is measured on photometric files, against distributions whose angles and asymmetry are known in closed form.
#include "analysis/photometry/photometric_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace luxdeck {
namespace {

/// A type C table every degree of gamma and 15 degrees of C.
Photometry sampled(const std::function<double(double gamma, double plane)>& candela) {
    std::vector<double> vertical, horizontal, values;
    for (int g = 0; g <= 180; ++g) vertical.push_back(g);
    for (int c = 0; c <= 360; c += 15) {
        horizontal.push_back(c);
        for (const double g : vertical) values.push_back(candela(g * kDegree, c * kDegree));
    }
    Photometry p;
    auto table = CandelaTable::create(PhotometryType::C, vertical, horizontal, values);
    EXPECT_TRUE(table) << table.error().text();
    p.table = *std::move(table);
    return p;
}

double lambert(double gamma) { return 1000 * std::max(0.0, std::cos(gamma)); }

TEST(PhotometricFacts, LambertianLuminaire) {
    auto p = sampled([](double g, double) { return lambert(g); });
    p.watts = 31.4159265;
    p.lumensDeclared = 1000 * kPiD;
    const auto facts = measure(p);
    // Chords of a cosine at 1 degree are low by (1 degree)^2 / 8 = 3.8e-5 of it at most; its slope at 60 degrees is
    // 0.87 a radian, so the crossing moves by less than 0.003 degrees; steps of 0.1 degree are linear in between.
    ASSERT_TRUE(facts.c0.beamDegrees && facts.c0.fieldDegrees && facts.c90.beamDegrees);
    EXPECT_NEAR(*facts.c0.beamDegrees, 120, 0.02);
    EXPECT_NEAR(*facts.c90.beamDegrees, 120, 0.02);
    EXPECT_NEAR(*facts.c0.fieldDegrees, 2 * std::acos(0.1) / kDegree, 0.02);
    EXPECT_NEAR(*facts.declaredRatio, 1, 1e-4);  // the same chords
    EXPECT_NEAR(*facts.efficacy, 100, 0.01);
    EXPECT_EQ(facts.lumensUp, 0);
    EXPECT_EQ(facts.measured, PhotometrySymmetry::Axial);
    EXPECT_LT(facts.deviation.axial, 1e-5);  // single precision
    EXPECT_DOUBLE_EQ(facts.peak.candela, 1000);
    EXPECT_DOUBLE_EQ(facts.peak.gammaDegrees, 0);
}

TEST(PhotometricFacts, UplightIsMeasuredAboutTheZenith) {
    const auto facts = measure(sampled([](double g, double) { return lambert(kPiD - g); }));
    ASSERT_TRUE(facts.c0.beamDegrees);
    EXPECT_NEAR(*facts.c0.beamDegrees, 120, 0.02);  // as above
    EXPECT_DOUBLE_EQ(facts.peak.gammaDegrees, 180);
    EXPECT_NEAR(facts.lumensDown, 0, 1e-9);
}

TEST(PhotometricFacts, SymmetryAsMeasured) {
    const auto about0 = measure(sampled([](double g, double c) { return lambert(g) * (1 + 0.5 * std::cos(c)); }));
    EXPECT_EQ(about0.measured, PhotometrySymmetry::Bilateral0to180);
    // 1000 * (1.5 - 0.5) beside the nadir, over the maximum of 1500; on the axis all planes are one direction, and at
    // the next angle, 1 degree, the cosine is 1.5e-4 lower.
    EXPECT_NEAR(about0.deviation.about90, 1000.0 / 1500, 2e-4);
    const auto about90 = measure(sampled([](double g, double c) { return lambert(g) * (1 + 0.5 * std::sin(c)); }));
    EXPECT_EQ(about90.measured, PhotometrySymmetry::Bilateral90to270);
    const auto both = measure(sampled([](double g, double c) { return lambert(g) * (1 + 0.5 * std::cos(2 * c)); }));
    EXPECT_EQ(both.measured, PhotometrySymmetry::Quadrant);
    const auto none = measure(sampled([](double g, double c) { return lambert(g) * (1 + 0.3 * std::cos(c) + 0.3 * std::sin(c)); }));
    EXPECT_EQ(none.measured, PhotometrySymmetry::None);
}

TEST(PhotometricFacts, BatwingsDipAndLightAllRound) {
    const auto batwing = measure(sampled([](double g, double) { return g < kPiD / 2 ? 1000 * std::sin(2 * g) : 0; }));
    ASSERT_TRUE(batwing.c0.beamDegrees);
    EXPECT_NEAR(*batwing.c0.beamDegrees, 150, 0.05);  // sin 2 gamma = 1/2 at 75 degrees; chords as above, four times as curved
    EXPECT_NEAR(batwing.peak.gammaDegrees, 45, 1e-9);
    const auto bulb = measure(sampled([](double, double) { return 80.0; }));
    EXPECT_FALSE(bulb.c0.beamDegrees);
    EXPECT_NEAR(bulb.lumensUp, bulb.lumensDown, 1e-6 * bulb.lumens);
}

}  // namespace
}  // namespace luxdeck

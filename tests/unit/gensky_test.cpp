#include "engine/io/gensky.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace luxdeck::test {
namespace {

using testing::HasSubstr;

Result<GeneratedDaylight> run(const std::string& line) {
    std::istringstream in(line);
    std::string program, word;
    in >> program;
    std::vector<std::string> words;
    while (in >> word) words.push_back(word);
    return generateDaylight(program, words);
}

GeneratedDaylight made(const std::string& line) {
    auto result = run(line);
    EXPECT_TRUE(result) << result.error().text();
    return result ? *std::move(result) : GeneratedDaylight{};
}

/// Radiance's own number for a direction [W/sr/m^2].
double skyfunc(const GeneratedDaylight& d, const Vec3& direction) { return d.sky.radiance(direction).g / 179; }

TEST(Gensky, OvercastOfAnIrradiance) {
    // -B 100: zenith 100 / (0.777778 pi) = 40.926, printed 4.09e+01; ground 0.2 * 40.926 * 0.777778 = 6.366, 6.37e+00.
    const auto d = made("gensky 3 21 12 -c -B 100 -a 40.7 -o 74 -m 75");
    EXPECT_NEAR(skyfunc(d, {0, 0, 1}), 40.9, 1e-4);    // the ground's share at the zenith is 2.01^-20
    EXPECT_NEAR(skyfunc(d, {0, 0, -1}), 6.37, 1e-4);
    // At the horizon both weigh nearly alike: 1.01^10 and its inverse.
    const double above = std::pow(1.01, 10);
    EXPECT_NEAR(skyfunc(d, {1, 0, 0}), (above * 40.9 / 3 + 6.37 / above) / (above + 1 / above), 1e-4);
    EXPECT_TRUE(d.sky.suns.empty());
}

TEST(Gensky, ClearSkyByAngles) {
    // Altitude 30, azimuth 0 (south). Zenith (1.376 * 2.45 - 1.81) tan 30 + 0.38 = 1.28136 kcd/m^2, / 203 -> 6.3121, printed
    // 6.31e+00. F2 = 0.274 (0.91 + 10 e^(-pi) + 0.45 / 4) = 0.398562, printed 3.99e-01.
    const auto d = made("gensky -ang 30 0 +s");
    const double zs = 60 * kDegree, gradation = 1 - std::exp(-0.32);
    const double expected = 6.31 * (0.91 + 10 * std::exp(-3 * zs) + 0.45 * 0.25) * gradation / 0.399;
    EXPECT_NEAR(skyfunc(d, {0, 0, 1}), expected, 1e-4 * expected);  // float; the ground's share 1e-6
    // The sun: 1.5e9 / 208 (1.147 - 0.147 / 0.5) = 6.1514e6, printed 6.15e+06, a disc of half a degree.
    ASSERT_EQ(d.sky.suns.size(), 1U);
    EXPECT_NEAR(d.sky.suns[0].radiance.g / 179, 6.15e6, 1);
    EXPECT_NEAR(d.sky.suns[0].halfAngleRad, 0.25 * kDegree, 1e-12);
    EXPECT_NEAR(d.sky.suns[0].direction.y, -std::cos(30 * kDegree), 1e-6);
    // Without a sun drawn the ground is lit by it all the same.
    const auto without = made("gensky -ang 30 0 -s");
    EXPECT_TRUE(without.sky.suns.empty());
    EXPECT_EQ(*without.sky.groundCdM2, *d.sky.groundCdM2);
}

TEST(Gensky, OptionsMeanWhatTheySay) {
    EXPECT_EQ(made("gensky -ang 30 0 -u -b 10").sky.kind, SkyKind::Uniform);
    EXPECT_NEAR(skyfunc(made("gensky -ang 30 0 -u -b 10"), {0, 0, 1}), 10, 1e-4);
    EXPECT_EQ(made("gensky -ang 30 0 +i").sky.kind, SkyKind::CieIntermediate);
    EXPECT_NEAR(*made("gensky -ang 30 0 -u -b 10 -g 0.5").sky.groundCdM2 / 179, 5, 1e-9);
    EXPECT_NEAR(made("gensky -ang 30 0 +s -r 1e6").sky.suns[0].radiance.g / 179, 1e6, 1);
    EXPECT_NEAR(made("gensky -ang 30 0 +s -R 300").sky.suns[0].radiance.g / 179, 1e7, 1);  // 300 / (6e-5 / 2)
    EXPECT_EQ(made("gensky 6 21 12EST -a 40 -o 75 -m 0").sky.sunDirection, made("gensky 6 21 12:00 -a 40 -o 75 -m 75").sky.sunDirection);
    EXPECT_NEAR(made("gensky 6 21 +12 -a 40 -o 1 -m 0").sky.sunDirection.x, 0, 1e-6);  // solar noon
    EXPECT_EQ(made("gensky -ang 89 0 +s").warnings.size(), 1U);
    EXPECT_NEAR(made("gensky 6 21 12 -y 2024 -a 40 -o 75 -m 75").sky.sunDirection.z, std::sin((50 + 23.43) * kDegree), 1e-3);
}

TEST(Gensky, RefusalsNameTheOption) {
    for (const auto& [line, text] : {std::pair{"gensky 3 21", "too few"}, {"gensky 13 21 12", "month is '13', expected a number 1 .. 12"},
                                     {"gensky 3 21 25", "hour is '25'"}, {"gensky 3 21 12XYZ", "unknown time zone"},
                                     {"gensky 3 21 12 -q", "unknown option '-q'"}, {"gensky 3 21 12 -g", "-g has no value"},
                                     {"gensky 3 21 12 -t abc", "-t is 'abc'"}, {"gensky 3 21 12 s", "expected an option"},
                                     {"gendaylit 3 21 12", "expected -P, -W, -L or -G"}, {"gendaylit 3 21 12 -W 100", "-W's second value has no value"},
                                     {"gendaylit 3 21 12 -E 100", "'-E', which is not read"}}) {
        const auto result = run(line);
        ASSERT_FALSE(result) << line;
        EXPECT_THAT(result.error().message, HasSubstr(text));
    }
}

// Radiance adds Perez's negative luminances up. The signed sum over this sky, its ground and the mixing at the horizon is
// 2838.7 lx by an integration apart from ours (3000 x 1500 midpoints); what is above zero alone would give 9600.
TEST(Gendaylit, NegativeLuminancesAreBlackAndTheIlluminanceRadiances) {
    const auto d = made("gendaylit -ang 45 0 -W 90 18 -s");
    double lux = 0;
    constexpr int kRings = 200, kSteps = 400;
    for (int i = 0; i < kRings; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double r2 = (i + 0.5) / kRings, r = std::sqrt(r2), azimuth = 2 * kPiD * (j + 0.5) / kSteps;
            const Vec3 up(Vec3d(r * std::cos(azimuth), r * std::sin(azimuth), std::sqrt(1 - r2)));
            const double value = d.sky.radiance(up).g;
            ASSERT_GE(value, 0);
            lux += value * kPiD / (kRings * kSteps);
        }
    EXPECT_NEAR(lux, 2838.7, 0.003 * 2838.7);  // four printed digits, and the midpoints at the black parts' edges
    EXPECT_EQ(d.warnings.size(), 1U);
}

TEST(Gendaylit, ABlackSkyIsASky) {
    for (const char* line : {"gendaylit -ang 45 0 -W 0 0", "gendaylit 12 21 2 -a 47 -o -13 -m -15 -W 0 0",
                             "gendaylit 12 21 2 -a 47 -o -13 -m -15 -W 100 50", "gendaylit -ang -5 0 -G 100 50"}) {
        const auto d = made(line);
        EXPECT_EQ(skyfunc(d, {0, 0, 1}), 0) << line;
        EXPECT_EQ(skyfunc(d, {0, 0, -1}), 0) << line;
        EXPECT_TRUE(d.sky.suns.empty()) << line;
        EXPECT_EQ(d.warnings.size(), 1U) << line;
    }
}

TEST(Gendaylit, GivesAboutItsIlluminances) {
    const auto d = made("gendaylit -ang 40 20 -L 40000 15000");
    // Normalised by 145 directions of equal weight, which is off the integral by some percent.
    EXPECT_NEAR(d.sky.horizontalLux(), 15000, 0.05 * 15000);
    ASSERT_EQ(d.sky.suns.size(), 1U);
    EXPECT_NEAR(d.sky.suns[0].normalIrradiance().g, 40000, 2e-3 * 40000);  // four digits are printed
    EXPECT_TRUE(made("gendaylit -ang 40 20 -W 0 100").sky.suns.empty());
    EXPECT_TRUE(made("gendaylit -ang 40 20 -L 40000 15000 -s").sky.suns.empty());
    // The same weather by its parameters: clearness 1 has no direct light.
    EXPECT_TRUE(made("gendaylit -ang 40 20 -P 1 0.2").sky.suns.empty());
    const auto normal = made("gendaylit -ang 30 0 -W 400 100"), horizontal = made("gendaylit -ang 30 0 -G 200 100");
    EXPECT_NEAR(normal.sky.zenithCdM2, horizontal.sky.zenithCdM2, 1e-6 * normal.sky.zenithCdM2);
}

}  // namespace
}  // namespace luxdeck::test

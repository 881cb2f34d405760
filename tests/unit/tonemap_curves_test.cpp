#include "engine/core/rng.h"
#include "tonemap/adaptation.h"
#include "tonemap/histogram.h"
#include "tonemap/mesopic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luxdeck::tonemap {
namespace {

TEST(Adaptation, JustNoticeableDifferencesOfThePaper) {
    const struct {
        double luminance, difference;
    } known[] = {{1e-3, 1.840e-3}, {1e-2, 5.472e-3}, {0.1, 4.027e-2}, {1, 0.3913},
                 {10, 1.0719},     {100, 5.5590},    {1e3, 55.590},   {1e4, 555.90}};
    for (const auto& k : known)  // the table has four digits
        EXPECT_NEAR(justNoticeableDifference(k.luminance), k.difference, 5e-4 * k.difference) << k.luminance;
    EXPECT_NEAR(justNoticeableDifference(0), 1.38e-3, 1e-5);
}

TEST(Adaptation, JustNoticeableDifferenceRisesButForItsPublishedSteps) {
    double last = 0;
    for (double x = -8; x < 8; x += 0.01) {
        const double d = justNoticeableDifference(std::pow(10, x));
        EXPECT_GT(d, last * 0.985) << x;  // the pieces miss each other by 1.2 % at most
        last = d;
    }
}

TEST(Adaptation, AcuityOfShaler) {
    const struct {
        double luminance, cycles;
    } known[] = {{0.001, 3.01}, {0.01, 5.31}, {0.1, 11.75}, {1, 31.53}, {10, 43.86}, {100, 47.51}, {1000, 49.08}};
    for (const auto& k : known) EXPECT_NEAR(visualAcuity(k.luminance), k.cycles, 0.006) << k.luminance;  // two decimals
    EXPECT_GT(visualAcuity(0), 1);
}

TEST(Mesopic, NoColourInTheDarkAllOfItInTheLight) {
    const Rgb dark = withNightColours(Rgb(2e-3F, 1e-3F, 5e-3F));
    EXPECT_TRUE(dark.isGrey());
    const Rgb light(20, 3, 40);
    EXPECT_EQ(withNightColours(light), light);
    for (const float level :
         {1e-4F, 1e-2F, 1.0F, 5.0F, 100.0F})  // float arithmetic on a blend: a few units in the last place
        EXPECT_NEAR(withNightColours(Rgb(level)).g, level, 1e-6 * level);
}

TEST(Mesopic, RodsSeeBlueBrighterThanRed) {
    EXPECT_GT(scotopicLuminance(Rgb(0, 0, 1)) / luminance(Rgb(0, 0, 1)), 1.5);
    EXPECT_LT(scotopicLuminance(Rgb(1, 0, 0)) / luminance(Rgb(1, 0, 0)), 0.5);
    EXPECT_EQ(scotopicLuminance(Rgb()), 0);
}

/// A dark room with a window: two crowds of luminances five decades apart, and some between.
std::vector<double> roomWithWindow() {
    RandomStream random(1);
    std::vector<double> out;
    for (int i = 0; i < 3000; ++i) {
        const double x = random.normal();
        out.push_back(i % 4 == 0 ? std::exp(8 + 0.5 * x) : i % 7 == 0 ? std::exp(3 + 2 * x) : std::exp(-1.5 + 0.7 * x));
    }
    return out;
}

const DisplayModel kDisplay;

double logSlope(const ToneCurve& curve, double world) {
    constexpr double kStep = 1e-4;
    return (std::log(curve.displayLuminance(world * std::exp(kStep))) -
            std::log(curve.displayLuminance(world * std::exp(-kStep)))) /
           (2 * kStep);
}

class Ceilings : public ::testing::TestWithParam<Ceiling> {};

TEST_P(Ceilings, TheSlopeStaysBelow) {
    // The last pass cuts at most the tolerance of the original counts from what its ceilings were computed
    // with, so the slope exceeds them by total before over total after: 1 / (1 - tolerance / kept). The human
    // ceiling moves with the curve too, whose display luminance that pass shifts by at most as much of the
    // display's log range (4.6); its own slope against log luminance is below 1.
    const double tolerance = 0.001;
    const auto adjusted = adjustHistogram(logHistogram(roomWithWindow()), kDisplay, GetParam(), tolerance);
    ASSERT_TRUE(adjusted.useful);
    EXPECT_GT(adjusted.keptFraction, 0.1);
    const double slack = (1 / (1 - tolerance / adjusted.keptFraction)) * (1 + 4.7 * tolerance / adjusted.keptFraction);
    const auto curve = ToneCurve::fromHistogram(adjusted.histogram, kDisplay);
    for (std::size_t bin = 0; bin < adjusted.histogram.counts.size(); ++bin) {
        const double world = std::exp(adjusted.histogram.centre(bin));
        EXPECT_LE(logSlope(curve, world), slack * ceilingSlope(GetParam(), world, curve.displayLuminance(world)) + 1e-9)
            << bin;
    }
}

TEST_P(Ceilings, EqualisationAloneWouldBreakThem) {
    const auto histogram = logHistogram(roomWithWindow());
    const auto naive = ToneCurve::fromHistogram(histogram, kDisplay);
    bool broken = false;
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
        const double world = std::exp(histogram.centre(bin));
        broken |= logSlope(naive, world) > 1.1 * ceilingSlope(GetParam(), world, naive.displayLuminance(world));
    }
    EXPECT_TRUE(broken);
}

TEST_P(Ceilings, TheCurveIsMonotoneWithinTheDisplay) {
    const auto curve = toneCurve(roomWithWindow(), kDisplay, GetParam(), nullptr);
    double last = 0;
    for (double x = -20; x < 20; x += 0.01) {
        const double shown = curve.displayLuminance(std::exp(x));
        EXPECT_GE(shown, last);
        EXPECT_GE(shown, kDisplay.minCdM2 * (1 - 1e-12));
        EXPECT_LE(shown, kDisplay.maxCdM2 * (1 + 1e-12));
        last = shown;
    }
}

TEST_P(Ceilings, DuplicatedSamplesChangeNothing) {
    const auto once = roomWithWindow();
    auto twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    const auto a = toneCurve(once, kDisplay, GetParam(), nullptr), b = toneCurve(twice, kDisplay, GetParam(), nullptr);
    for (double x = -5; x < 10; x += 0.1)  // sums of twice the counts round differently
        EXPECT_NEAR(a.displayLuminance(std::exp(x)), b.displayLuminance(std::exp(x)),
                    1e-9 * a.displayLuminance(std::exp(x)));
}

TEST_P(Ceilings, AScaleThatFitsTheDisplayIsLinear) {
    std::vector<double> gentle;
    for (int i = 0; i < 500; ++i) gentle.push_back(200 + i);
    const auto curve = toneCurve(gentle, kDisplay, GetParam(), nullptr);
    ASSERT_TRUE(curve.isLinear());
    EXPECT_LE(curve.factor() * 699, kDisplay.maxCdM2 * (1 + 1e-12));
    // Mapped again it is linear still.
    std::vector<double> shown;
    for (const double l : gentle) shown.push_back(curve.displayLuminance(l));
    EXPECT_TRUE(toneCurve(shown, kDisplay, GetParam(), nullptr).isLinear());
}

INSTANTIATE_TEST_SUITE_P(Both, Ceilings, ::testing::Values(Ceiling::Linear, Ceiling::Human));

TEST(Curve, CameraIgnoresTheUnitOfLight) {
    const auto samples = roomWithWindow();
    std::vector<double> scaled;
    for (const double l : samples) scaled.push_back(16 * l);
    const auto a = toneCurve(samples, kDisplay, Ceiling::Linear, nullptr),
               b = toneCurve(scaled, kDisplay, Ceiling::Linear, nullptr);
    for (double x = -5; x < 10;
         x += 0.1)  // a sample on a bin's border may change bins: 1 of 3000 samples over a log range of 4.6
        EXPECT_NEAR(std::log(a.displayLuminance(std::exp(x))), std::log(b.displayLuminance(16 * std::exp(x))),
                    4 * 4.6 / 3000);
}

TEST(Curve, ADimSceneLooksDimToTheEyeOnly) {
    auto samples = roomWithWindow();
    for (double& l : samples) l *= 1e-3;
    const auto human = toneCurve(samples, kDisplay, Ceiling::Human, nullptr),
               camera = toneCurve(samples, kDisplay, Ceiling::Linear, nullptr);
    const double typical = 1e-3 * std::exp(-1.5);
    EXPECT_LT(human.displayLuminance(typical * 2) / human.displayLuminance(typical),
              camera.displayLuminance(typical * 2) / camera.displayLuminance(typical));
}

TEST(Curve, SamplesWithoutRangeOrLightDoNoHarm) {
    for (const auto& samples : {std::vector<double>{}, std::vector<double>{0, 0}, std::vector<double>{5},
                                std::vector<double>(10, 1e-9), std::vector<double>{1e-12, 1e12}})
        for (const auto ceiling : {Ceiling::Linear, Ceiling::Human}) {
            const auto curve = toneCurve(samples, kDisplay, ceiling, nullptr);
            for (const double l : {0.0, 1e-9, 1.0, 1e9}) {
                EXPECT_GE(curve.displayLuminance(l), kDisplay.minCdM2 * (1 - 1e-12));
                EXPECT_LE(curve.displayLuminance(l), kDisplay.maxCdM2 * (1 + 1e-12));
            }
        }
}

}  // namespace
}  // namespace luxdeck::tonemap

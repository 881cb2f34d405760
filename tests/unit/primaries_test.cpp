#include "engine/core/primaries.h"

#include <gtest/gtest.h>

namespace luxdeck {
namespace {

TEST(Primaries, KnownWeights) {
    EXPECT_EQ(luminanceWeights(kRec709Chromaticities), kRec709);
    const auto radiance = luminanceWeights(kRadianceChromaticities);
    // Source: Radiance color.h, whose white is 0.3333 rather than 1/3: 1e-4 relative, half of it in the weights.
    EXPECT_NEAR(radiance.r, 0.265074126, 5e-5);
    EXPECT_NEAR(radiance.g, 0.670114631, 5e-5);
    EXPECT_NEAR(radiance.b, 0.064811243, 5e-5);
    EXPECT_EQ(chromaticitiesOf(radiance), kRadianceChromaticities);
    EXPECT_EQ(chromaticitiesOf({0.265, 0.670, 0.065}), kRadianceChromaticities);
    EXPECT_EQ(chromaticitiesOf(kRec709), kRec709Chromaticities);
}

TEST(Primaries, ConversionKeepsWhiteAndLuminance) {
    const auto m = rgbToRgb(kRadianceChromaticities, kRec709Chromaticities);
    const auto from = luminanceWeights(kRadianceChromaticities);
    const Rgb white = transformed(Rgb(1.0F), m);
    // Rec.709's weights are rounded to four digits by its standard: 5e-5 at most each.
    EXPECT_NEAR(white.r, 1, 1e-6);
    EXPECT_NEAR(white.g, 1, 1e-6);
    EXPECT_NEAR(white.b, 1, 1e-6);
    for (const Rgb& c : {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(0.2F, 0.9F, 0.4F)})
        EXPECT_NEAR(luminance(transformed(c, m)), luminance(c, from), 2e-4);
}

TEST(Primaries, UnusableOnesAreSeen) {
    EXPECT_TRUE(isUsable(kRec709Chromaticities));
    EXPECT_FALSE(isUsable({0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3}));
    EXPECT_FALSE(isUsable({0.64, 0.33, 0.3, 0.6, 0.15, 0.0, 0.31, 0.33}));
}

}  // namespace
}  // namespace luxdeck

#include "engine/transport/surface/glass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace luxdeck {
namespace {

float cosineOf(double degrees) { return static_cast<float>(std::cos(degrees * std::numbers::pi / 180)); }

// A clear slab, all interreflections, unpolarised: independent values to four digits, half a unit of the last.
TEST(Glass, ClearSlabHasItsKnownTransmittance) {
    const double values[][2] = {{0, 0.9183}, {30, 0.9160}, {45, 0.9025}, {60, 0.8435}, {75, 0.6148}, {80, 0.4560}};
    for (const auto& [angle, t] : values) EXPECT_NEAR(paneLight(Rgb(1.0F), 1.52F, cosineOf(angle)).transmitted.g, t, 6e-5) << angle;
    EXPECT_NEAR(paneLight(Rgb(0.9183F), 1.52F, cosineOf(60)).transmitted.g, 0.8435, 2e-4) << "clear, as its own value at normal incidence says";
}

// By amplitudes summed one reflection after the other, in double, absorption by Beer's law along the slanted way.
TEST(Glass, AgreesWithTheSumOverInterreflections) {
    for (const double total : {0.3, 0.6, 0.9})
        for (const double n : {1.3, 1.52, 1.9})
            for (const double angle : {0.0, 20.0, 50.0, 70.0, 85.0}) {
                const double c1 = std::cos(angle * std::numbers::pi / 180), c2 = std::sqrt(1 - (1 - c1 * c1) / (n * n));
                const double r0 = std::pow((n - 1) / (n + 1), 2);
                double low = 0, high = 1;  // internal transmittance by bisection
                for (int i = 0; i < 60; ++i) {
                    const double t = (low + high) / 2;
                    ((1 - r0) * (1 - r0) * t / (1 - r0 * r0 * t * t) < total ? low : high) = t;
                }
                double transmitted = 0, reflected = 0;
                for (const double r : {std::pow((c1 - n * c2) / (c1 + n * c2), 2), std::pow((n * c1 - c2) / (n * c1 + c2), 2)}) {
                    const double t = std::pow(low, 1 / c2);
                    double inside = (1 - r) * t;
                    reflected += r / 2;
                    for (int bounce = 0; bounce < 500; ++bounce) {
                        (bounce % 2 == 0 ? transmitted : reflected) += inside * (1 - r) / 2;
                        inside *= r * t;
                    }
                }
                const auto light = paneLight(Rgb(static_cast<float>(total)), static_cast<float>(n), static_cast<float>(c1));
                // Float rounding, and the cancellation of the quadratic for t: 1e-7 / r0.
                EXPECT_NEAR(light.transmitted.r, transmitted, 2e-5) << total << " n " << n << " at " << angle;
                EXPECT_NEAR(light.reflected.b, reflected, 2e-5) << total << " n " << n << " at " << angle;
            }
}

TEST(Glass, GivesTheTransmittanceAskedForAndNeverMoreEnergyThanItGets) {
    for (const float t : {0.0F, 1e-6F, 0.1F, 0.5F, 0.85F, 0.9F, 1.0F})
        for (const float n : {1.0F, 1.01F, 1.52F, 4.0F}) {
            const float r0 = (n - 1) * (n - 1) / ((n + 1) * (n + 1)), most = (1 - r0) / (1 + r0);
            // Weakly reflecting glass cancels in the quadratic for the internal transmittance.
            EXPECT_NEAR(paneLight(Rgb(t), n, 1).transmitted.g, std::min(t, most), n == 1.01F ? 5e-3 : 1e-4) << t << " n " << n;
            for (const float c : {0.0F, 1e-6F, 0.01F, 0.3F, 0.7F, 1.0F}) {
                const auto light = paneLight(Rgb(t), n, c);
                EXPECT_TRUE(light.transmitted.g >= 0 && light.reflected.g >= 0) << t << " n " << n << " cosine " << c;
                EXPECT_LE(light.transmitted.g + light.reflected.g, 1 + 1e-6F) << t << " n " << n << " cosine " << c;  // float rounding
            }
        }
}

TEST(Glass, ChannelsAreIndependent) {
    const auto tinted = paneLight({0.8F, 0.5F, 0.2F}, 1.52F, 0.6F);
    EXPECT_EQ(tinted.transmitted.r, paneLight(Rgb(0.8F), 1.52F, 0.6F).transmitted.g);
    EXPECT_EQ(tinted.reflected.b, paneLight(Rgb(0.2F), 1.52F, 0.6F).reflected.g);
}

}  // namespace
}  // namespace luxdeck

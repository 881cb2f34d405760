#include "engine/scene/sky_models.h"

#include <algorithm>
#include <array>
#include <cmath>

// Perez, Seals & Michalsky 1993, "All-weather model for sky luminance distribution", with its erratum; the efficacies
// are those of Perez et al. 1990.
namespace luxdeck {

namespace {

constexpr double kSolarConstantWm2 = 1367;
constexpr double kKappa = 1.041;
constexpr double kLeastClearness = 1, kMostClearness = 12.0099;
constexpr double kLeastBrightness = 0.01, kMostBrightness = 0.6;

/// Lower bounds of the bins of clearness.
constexpr std::array<double, 8> kBins{1.000, 1.065, 1.230, 1.500, 1.950, 2.800, 4.500, 6.200};

using Row = std::array<double, 4>;
/// a, b, c, d, e of the luminance distribution, four numbers each, by bin.
constexpr std::array<std::array<Row, 5>, 8> kShapes{{
    {{{1.3525, -0.2576, -0.269, -1.4366}, {-0.767, 0.0007, 1.2734, -0.1233}, {2.8, 0.6004, 1.2375, 1}, {1.8734, 0.6297, 0.9738, 0.2809}, {0.0356, -0.1246, -0.5718, 0.9938}}},
    {{{-1.2219, -0.773, 1.4148, 1.1016}, {-0.2054, 0.0367, -3.9128, 0.9156}, {6.975, 0.1774, 6.4477, -0.1239}, {-1.5798, -0.5081, -1.7812, 0.108}, {0.2624, 0.0672, -0.219, -0.4285}}},
    {{{-1.1, -0.2515, 0.8952, 0.0156}, {0.2782, -0.1812, -4.5, 1.1766}, {24.7219, -13.0812, -37.7, 34.8438}, {-5, 1.5218, 3.9229, -2.6204}, {-0.0156, 0.1597, 0.4199, -0.5562}}},
    {{{-0.5484, -0.6654, -0.2672, 0.7117}, {0.7234, -0.6219, -5.6812, 2.6297}, {33.3389, -18.3, -62.25, 52.0781}, {-3.5, 0.0016, 1.1477, 0.1062}, {0.4659, -0.3296, -0.0876, -0.0329}}},
    {{{-0.6, -0.3566, -2.5, 2.325}, {0.2937, 0.0496, -5.6812, 1.8415}, {21, -4.7656, -21.5906, 7.2492}, {-3.5, -0.1554, 1.4062, 0.3988}, {0.0032, 0.0766, -0.0656, -0.1294}}},
    {{{-1.0156, -0.367, 1.0078, 1.4051}, {0.2875, -0.5328, -3.85, 3.375}, {14, -0.9999, -7.1406, 7.5469}, {-3.4, -0.1078, -1.075, 1.5702}, {-0.0672, 0.4016, 0.3017, -0.4844}}},
    {{{-1, 0.0211, 0.5025, -0.5119}, {-0.3, 0.1922, 0.7023, -1.6317}, {19, -5, 1.2438, -1.9094}, {-4, 0.025, 0.3844, 0.2656}, {1.0468, -0.3788, -2.4517, 1.4656}}},
    {{{-1.05, 0.0289, 0.426, 0.359}, {-0.325, 0.1156, 0.7781, 0.0025}, {31.0625, -14.5, -46.1148, 55.375}, {-7.2312, 0.405, 13.35, 0.6234}, {1.5, -0.6426, 1.8564, 0.5636}}}}};

constexpr std::array<Row, 8> kDiffuseEfficacy{{{97.24, -0.46, 12.00, -8.91}, {107.22, 1.15, 0.59, -3.95}, {104.97, 2.96, -5.53, -8.77}, {102.39, 5.59, -13.95, -13.90}, {100.71, 5.94, -22.75, -23.74}, {106.42, 3.83, -36.15, -28.83}, {141.88, 1.90, -53.24, -14.03}, {152.23, 0.35, -45.27, -7.98}}};
constexpr std::array<Row, 8> kDirectEfficacy{{{57.20, -4.55, -2.98, 117.12}, {98.99, -3.46, -1.21, 12.38}, {109.83, -4.90, -1.71, -8.81}, {110.34, -5.84, -1.99, -4.56}, {106.36, -3.97, -1.75, -6.16}, {107.19, -1.25, -1.51, -26.73}, {105.75, 0.77, -1.26, -34.44}, {101.18, 1.58, -1.10, -8.29}}};

std::size_t binOf(double clearness) {
    std::size_t bin = 0;
    while (bin + 1 < kBins.size() && clearness >= kBins[bin + 1]) ++bin;
    return bin;
}

double airMass(double zenithRad) {
    const double degrees = zenithRad / kDegree;
    if (degrees >= 93.8) return 40;  // the formula's pole; the sun is well below the horizon
    return 1 / (std::cos(zenithRad) + 0.15 * std::pow(93.885 - degrees, -1.253));
}

double extraterrestrialWm2(double dayOfYear) {
    const double g = 2 * kPiD * (dayOfYear - 1) / 365;
    return kSolarConstantWm2 * (1.00011 + 0.034221 * std::cos(g) + 0.00128 * std::sin(g) + 0.000719 * std::cos(2 * g) +
                                0.000077 * std::sin(2 * g));
}

double zenithCubed(double zenithRad) { return kKappa * zenithRad * zenithRad * zenithRad; }

}  // namespace

PerezParameters perezParameters(const PerezWeather& w) {
    const double z3 = zenithCubed(w.sunZenithRad);
    const double clearness = ((w.diffuseHorizontalWm2 + w.directNormalWm2) / w.diffuseHorizontalWm2 + z3) / (1 + z3);
    const double brightness = w.diffuseHorizontalWm2 * airMass(w.sunZenithRad) / extraterrestrialWm2(w.dayOfYear);
    return {std::clamp(clearness, kLeastClearness, kMostClearness), std::clamp(brightness, kLeastBrightness, kMostBrightness)};
}

PerezWeather perezWeather(const PerezParameters& p, double sunZenithRad, double dayOfYear) {
    PerezWeather w;
    w.sunZenithRad = sunZenithRad, w.dayOfYear = dayOfYear;
    w.diffuseHorizontalWm2 = p.brightness / airMass(sunZenithRad) * extraterrestrialWm2(dayOfYear);
    w.directNormalWm2 = w.diffuseHorizontalWm2 * (p.clearness - 1) * (1 + zenithCubed(sunZenithRad));
    return w;
}

PerezEfficacy perezEfficacy(const PerezParameters& p, double sunZenithRad, double dewPointC) {
    const double waterCm = std::exp(0.07 * dewPointC - 0.075);
    const auto bin = binOf(p.clearness);
    const auto& f = kDiffuseEfficacy[bin];
    const auto& n = kDirectEfficacy[bin];
    return {std::max(0.0, f[0] + f[1] * waterCm + f[2] * std::cos(sunZenithRad) + f[3] * std::log(p.brightness)),
            std::max(0.0, n[0] + n[1] * waterCm + n[2] * std::exp(5.73 * sunZenithRad - 5) + n[3] * p.brightness)};
}

SkyShape perezShape(const PerezParameters& p, double sunZenithRad) {
    const double clearness = std::clamp(p.clearness, kLeastClearness, kMostClearness);
    // The model's authors: below it the distribution goes negative in these bins.
    const double delta = clearness > 1.065 && clearness < 2.8 ? std::max(p.brightness, 0.2) : p.brightness;
    const auto bin = binOf(clearness);
    const auto& x = kShapes[bin];
    const double z = sunZenithRad;
    const auto linear = [&](const Row& r) { return r[0] + r[1] * z + delta * (r[2] + r[3] * z); };
    SkyShape shape{.a = linear(x[0]), .b = linear(x[1]), .k = 1, .c = linear(x[2]), .d = linear(x[3]), .e = linear(x[4]), .leastCosine = 0.01};
    if (bin == 0) {  // the overcast bin's c and d have forms of their own
        shape.c = std::exp(std::pow(delta * (x[2][0] + x[2][1] * z), x[2][2])) - x[2][3];
        shape.d = -std::exp(delta * (x[3][0] + x[3][1] * z)) + x[3][2] + delta * x[3][3];
    }
    return shape;
}

}  // namespace luxdeck

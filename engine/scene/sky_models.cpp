#include "engine/scene/sky_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace luxdeck {

namespace {

Sky turnedTo(SkyKind kind, const Vec3& sunDirection) {
    Sky sky;
    sky.kind = kind;
    sky.zenithCdM2 = 1;
    sky.sunDirection = sunDirection;
    return sky;
}

/// a, b, c, d, e of the types 1 .. 15. Source: CIE S 011/E:2003.
constexpr std::array<std::array<double, 5>, 15> kGeneralSkies{{
    {4.0, -0.70, 0, -1.0, 0},     {4.0, -0.70, 2, -1.5, 0.15},  {1.1, -0.80, 0, -1.0, 0},
    {1.1, -0.80, 2, -1.5, 0.15},  {0, -1.0, 0, -1.0, 0},        {0, -1.0, 2, -1.5, 0.15},
    {0, -1.0, 5, -2.5, 0.30},     {0, -1.0, 10, -3.0, 0.45},    {-1, -0.55, 2, -1.5, 0.15},
    {-1, -0.55, 5, -2.5, 0.30},   {-1, -0.55, 10, -3.0, 0.45},  {-1, -0.32, 10, -3.0, 0.45},
    {-1, -0.32, 16, -3.0, 0.30},  {-1, -0.15, 16, -3.0, 0.30},  {-1, -0.15, 24, -2.8, 0.15}}};

class LuminancePattern : public Pattern {
public:
    LuminancePattern(const Sky& sky, const Matrix4d& turn, double efficacy)
        : sky_(sky), back_(turn.inverse()), efficacy_(efficacy) {
        sky_.suns.clear();
        if (!sky_.groundCdM2) sky_.groundCdM2 = sky_.groundReflectance * sky_.horizontalLux() / kPiD;
        identity_ = fmt::format("sky {} / {} turned", sky_.identity(), efficacy);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) identity_ += fmt::format(" {}", back_[i][j]);
    }

    [[nodiscard]] Rgb value(const PatternPoint& at) const override {
        Vec3d local(0, 0, 0);
        back_.multDirMatrix(Vec3d(at.direction), local);
        return sky_.radiance(Vec3(local.normalized())) * static_cast<float>(1 / efficacy_);
    }
    [[nodiscard]] std::string identity() const override { return identity_; }

private:
    Sky sky_;
    Matrix4d back_;
    double efficacy_;
    std::string identity_;
};

}  // namespace

Sky cieClearSky(const Vec3& sunDirection) {
    auto sky = turnedTo(SkyKind::GradationIndicatrix, sunDirection);
    sky.shape = {.a = -1, .b = -0.32, .k = 0.91, .c = 10, .d = -3, .e = 0.45};
    return sky;
}

Sky cieIntermediateSky(const Vec3& sunDirection) { return turnedTo(SkyKind::CieIntermediate, sunDirection); }

Sky cieGeneralSky(int type, const Vec3& sunDirection) {
    const auto& [a, b, c, d, e] = kGeneralSkies.at(static_cast<std::size_t>(type - 1));
    auto sky = turnedTo(SkyKind::GradationIndicatrix, sunDirection);
    sky.shape = {.a = a, .b = b, .k = 1 - c * std::exp(d * kPiD / 2), .c = c, .d = d, .e = e};
    return sky;
}

Sky perezSky(const PerezParameters& parameters, const Vec3& sunDirection) {
    auto sky = turnedTo(SkyKind::GradationIndicatrix, sunDirection);
    sky.shape = perezShape(parameters, std::acos(std::clamp(static_cast<double>(sunDirection.z), 0.0, 1.0)));
    return sky;
}

Sky scaledToHorizontal(Sky sky, double lux, const LuminanceWeights& weights) {
    sky.zenithCdM2 *= lux / sky.horizontalLux();
    double total = lux;
    for (const auto& sun : sky.suns)
        total += luminance(sun.normalIrradiance(), weights) * std::max(0.0F, sun.direction.z);
    sky.groundCdM2 = sky.groundReflectance * total / kPiD;
    return sky;
}

std::shared_ptr<const Pattern> skyPattern(const Sky& sky, const Matrix4d& turn, double efficacy) {
    return std::make_shared<LuminancePattern>(sky, turn, efficacy);
}

}  // namespace luxdeck

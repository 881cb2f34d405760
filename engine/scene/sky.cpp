#include "engine/scene/sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// The angle between two unit vectors, exact where their cosine is not.
double angleBetween(const Vec3& a, const Vec3& b) {
    const Vec3d p(a), q(b);
    return std::atan2(p.cross(q).length(), p.dot(q));
}

double gradation(const SkyShape& s, double cosine) {
    if (s.plainHorizon && cosine <= 0.01) return 1;
    if (cosine <= 0 && s.leastCosine <= 0) return 1;  // b < 0: nothing is left of the exponential
    return 1 + s.a * std::exp(s.b / std::max(cosine, s.leastCosine));
}

double indicatrix(const SkyShape& s, double angle) {
    const double cosine = std::cos(angle);
    return s.k + s.c * std::exp(s.d * angle) + s.e * cosine * cosine;
}

/// Nakamura's distribution as Radiance has it, over its value at the zenith.
double intermediate(double zenithAngle, double sunAngle, double sunAltitude) {
    const double sunZenith = kPiD / 2 - sunAltitude;
    const double level = (1.35 * std::sin(5.631 - 3.59 * zenithAngle) + 3.12) * std::sin(4.396 - 2.6 * sunZenith) + 6.37 - zenithAngle;
    const double fall = std::exp(-0.563 * sunAngle * ((2.629 - zenithAngle) * (1.562 - sunZenith) + 0.812));
    const double atZenith = (2.739 + 0.9891 * std::sin(0.3119 + 2.6 * sunAltitude)) *
                            std::exp(-sunZenith * (0.4441 + 1.48 * sunAltitude));
    return level / 2.326 * fall / atZenith;
}

}  // namespace

bool SkyDome::covers(const Vec3& towards) const {
    return angleBetween(towards, direction) <= halfAngleRad * (1 + 1e-7);  // a seam between two belongs to both
}

double Sky::skyLuminance(const Vec3& direction) const {
    const double cosine = std::clamp(static_cast<double>(direction.z), -1.0, 1.0);
    switch (kind) {
        case SkyKind::None: return 0;
        case SkyKind::Uniform: return zenithCdM2;
        case SkyKind::CieOvercast: return zenithCdM2 * (1 + 2 * cosine) / 3;
        case SkyKind::CieIntermediate:
            return zenithCdM2 * intermediate(std::acos(cosine), angleBetween(direction, sunDirection),
                                             std::asin(std::clamp(static_cast<double>(sunDirection.z), -1.0, 1.0)));
        case SkyKind::GradationIndicatrix: {
            const double sunZenith = std::acos(std::clamp(static_cast<double>(sunDirection.z), -1.0, 1.0));
            const double atZenith = std::max(gradation(shape, 1) * indicatrix(shape, sunZenith), kLeastShape);
            // Perez's fit goes below zero for odd weather.
            return zenithCdM2 * std::max(0.0, gradation(shape, cosine) * indicatrix(shape, angleBetween(direction, sunDirection))) / atZenith;
        }
    }
    return 0;
}

double Sky::horizontalLux() const {
    if (kind == SkyKind::None) return 0;
    if (kind == SkyKind::Uniform) return kPiD * zenithCdM2;
    if (kind == SkyKind::CieOvercast) return 7 * kPiD / 9 * zenithCdM2;  // integral of (1 + 2 sin g) / 3 times cos
    // Midpoints of equal projected solid angle; symmetric about the sun's azimuth.
    constexpr int kRings = 160, kSteps = 160;
    const double sunAzimuth = std::atan2(static_cast<double>(sunDirection.y), static_cast<double>(sunDirection.x));
    double sum = 0;
    for (int i = 0; i < kRings; ++i) {
        const double r2 = (i + 0.5) / kRings, r = std::sqrt(r2);
        for (int j = 0; j < kSteps; ++j) {
            const double azimuth = sunAzimuth + kPiD * (j + 0.5) / kSteps;
            sum += skyLuminance(Vec3(Vec3d(r * std::cos(azimuth), r * std::sin(azimuth), std::sqrt(1 - r2))));
        }
    }
    return kPiD * sum / (kRings * kSteps);
}

Rgb Sky::radiance(const Vec3& direction) const {
    for (const auto& dome : domes) {
        if (!dome.covers(direction)) continue;
        if (!dome.pattern) return dome.radiance;
        PatternPoint at;
        at.direction = direction, at.normal = -direction;
        return dome.radiance * dome.pattern->value(at);
    }
    if (kind == SkyKind::None) return Rgb{};
    const auto ground = [&] { return groundCdM2 ? *groundCdM2 : groundReflectance * horizontalLux() / kPiD; };
    if (blendsAtHorizon) {
        const double above = std::pow(direction.z + 1.01, 10), below = 1 / above;
        return colour * static_cast<float>((above * skyLuminance(direction) + below * ground()) / (above + below));
    }
    return colour * static_cast<float>(direction.z < 0 ? ground() : skyLuminance(direction));
}

bool Sky::coloured() const {
    return !colour.isGrey() ||
           std::any_of(domes.begin(), domes.end(), [](const SkyDome& d) { return d.pattern || !d.radiance.isGrey(); }) ||
           std::any_of(suns.begin(), suns.end(), [](const Sun& s) { return !s.radiance.isGrey(); });
}

Rgb Sky::sunRadiance(const Vec3& direction) const {
    Rgb sum;
    for (const auto& sun : suns)
        if (sun.covers(direction)) sum += sun.radiance;
    return sum;
}

std::string Sky::identity() const {
    const auto rgb = [](const Rgb& c) { return fmt::format("{} {} {}", c.r, c.g, c.b); };
    const auto vec = [](const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
    auto text = fmt::format("{} {} {} {} {} {} ", static_cast<int>(kind), zenithCdM2, groundReflectance, rgb(colour),
                            vec(sunDirection), groundCdM2.value_or(-1));
    text += fmt::format("{} {} {} {} {} {} {} {} {}", shape.a, shape.b, shape.k, shape.c, shape.d, shape.e,
                        shape.leastCosine, shape.plainHorizon, blendsAtHorizon);
    for (const auto& d : domes)
        text += fmt::format("; dome {} {} {} {}", vec(d.direction), d.halfAngleRad, rgb(d.radiance),
                            d.pattern ? d.pattern->identity() : "");
    for (const auto& s : suns) text += fmt::format("; sun {} {} {}", vec(s.direction), s.halfAngleRad, rgb(s.radiance));
    return text;
}

}  // namespace luxdeck

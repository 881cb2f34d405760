#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/scene/pattern.h"
#include "engine/scene/sun.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

enum class SkyKind {
    None,
    Uniform,
    CieOvercast,          ///< Moon & Spencer: (1 + 2 sin g) / 3 of the zenith's luminance
    CieIntermediate,      ///< Nakamura's, in the form of Radiance's gensky
    GradationIndicatrix   ///< CIE clear, the 15 CIE general skies and Perez's: all of one form
};

/// The factors of a sky whose luminance is (1 + a e^(b / cos z)) (k + c e^(d x) + e cos^2 x): z the angle to the
/// zenith, x to the sun. The CIE general sky has k = 1 - c e^(d pi / 2), Perez's k = 1.
struct SkyShape {
    double a = 0, b = -1;
    double k = 1, c = 0, d = -1, e = 0;
    double leastCosine = 0;      ///< of z in the gradation: Perez's in Radiance stops at 0.01
    bool plainHorizon = false;   ///< the gradation is 1 below a cosine of 0.01: gensky's clear sky
};

/// What the shape counts as at the zenith where it is less: Perez's fit may vanish there.
inline constexpr double kLeastShape = 1e-3;

/// A part of the surroundings with its own light: Radiance's source of a glow.
struct SkyDome {
    Vec3 direction{0, 0, 1};     ///< of its middle, unit
    double halfAngleRad = kPiD / 2;
    Rgb radiance{1.0F};          ///< times the pattern [cd/m^2]
    std::shared_ptr<const Pattern> pattern;  ///< by direction; none: constant

    [[nodiscard]] bool covers(const Vec3& towards) const;
};

/// What is seen where there is no surface. Luminances are those of the sky alone; below the horizon lies a
/// diffuse ground lit by it.
struct Sky {
    Sky() = default;
    Sky(SkyKind skyKind, double zenith, double ground = 0.2, const Rgb& tint = Rgb(1.0F))
        : kind(skyKind), zenithCdM2(zenith), groundReflectance(ground), colour(tint) {}

    SkyKind kind = SkyKind::None;
    double zenithCdM2 = 0;         ///< luminance at the zenith [cd/m^2]; of a GradationIndicatrix: times the shape at the zenith
    double groundReflectance = 0.2;
    Rgb colour{1.0F};              ///< luminance 1

    Vec3 sunDirection{0, 0, 1};    ///< that the distribution turns about, unit; the sun itself is in `suns`
    SkyShape shape;                ///< of a GradationIndicatrix
    std::optional<double> groundCdM2;  ///< luminance below the horizon; none: what the sky alone gives to the ground
    bool blendsAtHorizon = false;  ///< sky and ground mix there as in Radiance's skybright.cal
    std::vector<SkyDome> domes;    ///< in front of all that; of two that overlap the first is seen
    std::vector<Sun> suns;         ///< not part of radiance()

    [[nodiscard]] bool present() const { return (kind != SkyKind::None && zenithCdM2 > 0) || !domes.empty(); }
    /// Whether anything of it may not be grey.
    [[nodiscard]] bool coloured() const;
    /// Radiance from a unit direction, suns left out [cd/m^2]; NaN where a dome's pattern has no value.
    [[nodiscard]] Rgb radiance(const Vec3& direction) const;
    /// Radiance of the suns in a unit direction [cd/m^2].
    [[nodiscard]] Rgb sunRadiance(const Vec3& direction) const;
    /// Unobstructed horizontal illuminance of the sky without suns and domes [lx]: pi Lz (uniform), 7 pi Lz / 9
    /// (CIE overcast); else by quadrature, to 1e-5, which takes a millisecond.
    [[nodiscard]] double horizontalLux() const;
    /// Text that is equal exactly when the skies are.
    [[nodiscard]] std::string identity() const;

private:
    [[nodiscard]] double skyLuminance(const Vec3& direction) const;
};

}  // namespace luxdeck

#include "engine/io/gensky.h"

#include "engine/io/gensky_options.h"
#include "engine/scene/sky_models.h"
#include "engine/scene/sun_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace luxdeck {

namespace {

using namespace gensky;

constexpr double kEfficacy = 179;                 // of everything in a Radiance scene [lm/W]
constexpr double kSkyEfficacy = 203, kSunEfficacy = 208;  // of daylight, where gensky goes from luminance to radiance
constexpr double kGenskySunSr = 6e-5;             // gensky's solid angle of the sun, its disc being 0.5 degrees wide

/// A value as printf's "%.*e" leaves it: the scene file is what Radiance computes with.
double printed(double value, int digits) { return std::strtod(fmt::format("{:.{}e}", value, digits).c_str(), nullptr); }

/// Horizontal over zenith illuminance, times F2: gensky's polynomials.
double normalisation(bool intermediate, double altitude) {
    constexpr std::array<std::array<double, 5>, 2> kTerms{{{2.766521, 0.547665, -0.369832, 0.009237, 0.059229},
                                                           {3.5556, -2.7152, -1.3081, 1.0660, 0.60227}}};
    const double x = (altitude - kPiD / 4) / (kPiD / 4);
    double sum = 0;
    for (int i = 4; i >= 0; --i) sum = sum * x + kTerms[intermediate ? 1 : 0][static_cast<std::size_t>(i)];
    return sum;
}

double clearFactor(double altitude) {
    const double s = std::sin(altitude);
    return 0.274 * (0.91 + 10 * std::exp(-3 * (kPiD / 2 - altitude)) + 0.45 * s * s);
}

double intermediateFactor(double altitude) {
    return (2.739 + 0.9891 * std::sin(0.3119 + 2.6 * altitude)) * std::exp(-(kPiD / 2 - altitude) * (0.4441 + 1.48 * altitude));
}

/// The sun's place, its altitude kept from the zenith as the programs do where the sky turns about it.
SolarAngles placeOf(const Options& o, bool turns, std::vector<std::string>& warnings) {
    auto angles = o.angles ? *o.angles : solarAngles(o);
    if (turns && angles.altitudeRad > 87 * kDegree) {
        warnings.push_back("the sun is too close to the zenith for the sky's model: its altitude is reduced to 87 degrees");
        angles.altitudeRad = 87 * kDegree;
    }
    if (!o.angles && !o.solarTime && std::abs(o.meridianRad - o.longitudeRad) > 45 * kDegree)
        warnings.push_back(fmt::format("{:.1f} hours lie between the standard meridian and the longitude", std::abs(o.longitudeRad - o.meridianRad) * 12 / kPiD));
    return angles;
}

Sky blended(Sky sky, double zenith, double ground) {
    sky.zenithCdM2 = kEfficacy * zenith;
    sky.groundCdM2 = kEfficacy * ground;
    sky.blendsAtHorizon = true;
    return sky;
}

GeneratedDaylight classicSky(const Options& o) {
    GeneratedDaylight out;
    const bool turns = o.kind == Kind::Clear || o.kind == Kind::Intermediate, intermediate = o.kind == Kind::Intermediate;
    const auto angles = placeOf(o, turns, out.warnings);
    const Vec3 sun = sunDirection(angles);
    const double altitude = angles.altitudeRad, sine = std::sin(altitude);
    const double factor = intermediate ? intermediateFactor(altitude) : clearFactor(altitude);
    const double norm = o.kind == Kind::Uniform ? 1.0 : o.kind == Kind::Overcast ? 0.777778 : normalisation(intermediate, altitude) / factor / kPiD;

    double zenith = 8.6 * sine + 0.123;
    if (turns) {
        const double clear = (1.376 * o.turbidity - 1.81) * std::tan(altitude) + 0.38;
        zenith = intermediate ? (clear + zenith) / 2 : clear;
    }
    zenith = std::max(zenith, 0.0) * 1000 / kSkyEfficacy;
    if (o.zenithRadiance) zenith = *o.zenithRadiance;
    if (o.horizontalIrradiance) zenith = *o.horizontalIrradiance / (norm * kPiD);

    double solar = 1.5e9 / kSunEfficacy * (1.147 - 0.147 / std::max(sine, 0.16)) * (intermediate ? 0.15 : 1.0);
    if (o.solarRadiance) solar = *o.solarRadiance;
    if (o.solarIrradiance) solar = *o.solarIrradiance / (kGenskySunSr * sine);
    const bool shines = turns && sine > 0 && solar > 0;
    const double ground = o.groundReflectance * (zenith * norm + (shines ? kGenskySunSr / kPiD * solar * sine : 0));

    Sky sky;
    sky.kind = o.kind == Kind::Uniform ? SkyKind::Uniform : SkyKind::CieOvercast;
    if (turns) sky = intermediate ? cieIntermediateSky(sun) : cieClearSky(sun);
    double scale = printed(zenith, 2);
    if (turns) {
        // Radiance divides by the factor as printed; our models by what they are at the zenith.
        const double s = std::sin(altitude);
        const double exact = intermediate ? factor : -std::expm1(-0.32) * (0.91 + 10 * std::exp(-3 * (kPiD / 2 - altitude)) + 0.45 * s * s);
        scale *= exact / printed(factor, 2);
    }
    sky.shape.plainHorizon = o.kind == Kind::Clear;
    out.sky = blended(std::move(sky), scale, printed(ground, 2));
    if (shines && o.sun)
        out.sky.suns.push_back({sun, 0.25 * kDegree, Rgb(static_cast<float>(kEfficacy * printed(solar, 2)))});
    return out;
}

/// gendaylit's integral of luminance times cosine: the 145 directions of Tregenza's sky, all of equal weight.
double tregenzaIntegral(const SkyShape& shape, double sunZenith) {
    constexpr std::array<int, 8> kPatches{30, 30, 24, 24, 18, 12, 6, 1};
    double sum = 0;
    for (std::size_t row = 0; row < kPatches.size(); ++row) {
        const double zenith = (84 - 12 * static_cast<double>(row)) * kDegree;
        for (int i = 0; i < kPatches[row]; ++i) {
            const double azimuth = 2 * kPiD * i / kPatches[row];
            const double cosine = std::cos(sunZenith) * std::cos(zenith) + std::sin(sunZenith) * std::sin(zenith) * std::cos(azimuth);
            const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)), c = std::cos(angle);
            sum += (1 + shape.a * std::exp(shape.b / std::cos(zenith))) * (1 + shape.c * std::exp(shape.d * angle) + shape.e * c * c) * std::cos(zenith);
        }
    }
    return sum * 2 * kPiD / 145;  // since 18 November 2020; 144 before
}

/// What a shape whose fit goes below zero gives to the ground, and what its part above zero alone would, with Radiance's
/// mixing at the horizon; `ground` in units of the shape.
struct SkySums {
    double withNegative = 0, positive = 0;
    bool negative = false;
};

SkySums sumsOf(const SkyShape& shape, double sunZenith, double ground) {
    // Midpoints of equal projected solid angle over the half beside the sun's azimuth.
    constexpr int kRings = 300, kSteps = 300;
    SkySums sums;
    for (int i = 0; i < kRings; ++i) {
        const double up = std::sqrt(1 - (i + 0.5) / kRings), across = std::sqrt(1 - up * up);
        const double above = std::pow(up + 1.01, 10), share = above / (above + 1 / above);
        const double gradation = 1 + shape.a * std::exp(shape.b / std::max(up, shape.leastCosine));
        for (int j = 0; j < kSteps; ++j) {
            const double c = std::cos(sunZenith) * up + std::sin(sunZenith) * across * std::cos(kPiD * (j + 0.5) / kSteps);
            const double angle = std::acos(std::clamp(c, -1.0, 1.0));
            const double value = gradation * (1 + shape.c * std::exp(shape.d * angle) + shape.e * c * c);
            sums.negative = sums.negative || value < 0;
            sums.withNegative += share * value + (1 - share) * ground;
            sums.positive += share * std::max(value, 0.0) + (1 - share) * std::max(ground, 0.0);
        }
    }
    return sums;
}

/// Luxes asked for have no irradiances yet: efficacies depend on what they give, a few rounds settle it.
PerezParameters parametersOfLux(const Options& o, PerezWeather& weather) {
    weather.directNormalWm2 = o.direct * 1367 / 127500;
    weather.diffuseHorizontalWm2 = o.diffuse * 1367 / 127500;
    auto parameters = perezParameters(weather);
    for (int round = 0; round < 5; ++round) {
        const auto efficacy = perezEfficacy(parameters, weather.sunZenithRad, weather.dewPointC);
        if (!(efficacy.diffuse > 0)) break;
        weather.diffuseHorizontalWm2 = o.diffuse / efficacy.diffuse;
        weather.directNormalWm2 = efficacy.direct > 0 ? o.direct / efficacy.direct : 0;
        parameters = perezParameters(weather);
    }
    return parameters;
}

/// gendaylit's sky of a night, of no light and of weather that has no sky: black, and a sky all the same.
GeneratedDaylight blackSky(GeneratedDaylight out, const std::string& why) {
    out.warnings.push_back("gendaylit: " + why + ": the sky is black");
    out.sky = blended(Sky(SkyKind::Uniform, 0), 0, 0);
    return out;
}

Result<GeneratedDaylight> perezDaylight(const Options& o) {
    GeneratedDaylight out;
    const auto angles = placeOf(o, true, out.warnings);
    if (angles.altitudeRad <= 0 && (!o.angles || o.input == PerezInput::Horizontal))
        return blackSky(std::move(out), "the sun is below the horizon");
    if (o.input != PerezInput::Parameters && o.direct + o.diffuse == 0)
        return blackSky(std::move(out), "neither direct nor diffuse light is given");
    const Vec3 sun = sunDirection(angles);
    const double zenith = kPiD / 2 - angles.altitudeRad, sine = std::sin(angles.altitudeRad);
    PerezWeather weather;
    weather.sunZenithRad = zenith;
    weather.dayOfYear = o.angles ? 0 : dayOfYear(o.month, o.day);  // gendaylit's day where it knows none
    PerezParameters parameters{o.direct, o.diffuse};
    if (o.input == PerezInput::Parameters) {
        weather = perezWeather(parameters, zenith, weather.dayOfYear);
    } else if (o.input == PerezInput::Lux) {
        parameters = parametersOfLux(o, weather);
    } else {
        weather.directNormalWm2 = o.input == PerezInput::Horizontal ? o.direct / sine : o.direct;
        weather.diffuseHorizontalWm2 = o.diffuse;
        if (weather.directNormalWm2 > 1367)
            return Error{ErrorCode::InvalidArgument, fmt::format("gendaylit: direct normal irradiance is {:.6g} W/m^2, expected at most 1367", weather.directNormalWm2), ""};
        parameters = perezParameters(weather);
    }
    const auto efficacy = perezEfficacy(parameters, zenith, weather.dewPointC);
    const bool lux = o.input == PerezInput::Lux;
    const double diffuseLux = lux ? o.diffuse : weather.diffuseHorizontalWm2 * efficacy.diffuse;
    const double directLux = lux ? o.direct : weather.directNormalWm2 * efficacy.direct;
    const double unit = o.output == 1 ? 1.0 : o.output == 2 ? 1.0 : 1 / kEfficacy;  // of what the scene file's numbers are
    const double diffuse = (o.output == 1 ? weather.diffuseHorizontalWm2 : diffuseLux) * unit;
    const double direct = (o.output == 1 ? weather.directNormalWm2 : directLux) * unit;

    Sky sky = perezSky(parameters, sun);
    const auto& shape = sky.shape;
    const double scale = printed(diffuse / tregenzaIntegral(shape, zenith), 3), c = std::cos(zenith);
    const double atZenith = (1 + shape.a * std::exp(shape.b)) * (1 + shape.c * std::exp(shape.d * zenith) + shape.e * c * c);
    const double altitude = angles.altitudeRad;
    const bool overcast = parameters.clearness <= 1, clear = parameters.clearness >= 6;
    const double norm = overcast ? 0.777778 : normalisation(!clear, altitude) / (clear ? clearFactor(altitude) : intermediateFactor(altitude)) / kPiD;
    const double solar = printed(direct / (2 * kPiD * (1 - std::cos(kSunHalfAngle))), 3);
    const bool shines = o.sun && !overcast && sine > 0 && solar > 0;
    const double ground = o.groundReflectance * (scale * atZenith * norm + (shines ? 6.8e-5 / kPiD * solar * sine : 0));
    const auto sums = scale != 0 ? sumsOf(shape, zenith, ground / scale) : SkySums{};
    double kept = 1;
    if (sums.negative) {
        // Radiance adds the negative light up; light is not negative: what is above zero gives the same illuminance.
        if (!(scale * sums.withNegative > 0)) return blackSky(std::move(out), "Perez's formula sums to less than nothing");
        kept = sums.withNegative / sums.positive;
        out.warnings.push_back("gendaylit: Perez's formula is negative in parts of this sky: these are black, the others scaled to Radiance's illuminance");
    }
    out.sky = blended(std::move(sky), kept * scale * std::max(atZenith, kLeastShape), std::max(0.0, kept * printed(ground, 3)));
    if (shines) out.sky.suns.push_back({sun, kSunHalfAngle, Rgb(static_cast<float>(kEfficacy * solar))});
    return out;
}

}  // namespace

Result<GeneratedDaylight> generateDaylight(const std::string& program, std::span<const std::string> words) {
    const auto options = readOptions(program, words);
    if (!options) return options.error();
    if (program == "gendaylit") return perezDaylight(*options);
    return classicSky(*options);
}

}  // namespace luxdeck

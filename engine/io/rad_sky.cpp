#include "engine/io/rad_sky.h"

#include "engine/io/gensky.h"
#include "engine/io/rad_material.h"
#include "engine/scene/sky_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::rad {

namespace {

/// An even source of at most this is a sun, which light is sampled from by itself; a larger one is a part of the sky.
constexpr double kMostSunDeg = 12;

Vec3d row(const Matrix4d& m, int i) { return {m[i][0], m[i][1], m[i][2]}; }

/// The rotation in a matrix of rotation, mirroring, one scale and a shift. A mirror stays: a sky can be mirrored too.
Matrix4d rotationOf(const Matrix4d& m) {
    Matrix4d turn;
    for (int i = 0; i < 3; ++i) {
        const Vec3d r = row(m, i).normalized();
        for (int j = 0; j < 3; ++j) turn[i][j] = r[j];
    }
    return turn;
}

}  // namespace

std::shared_ptr<const GeneratedSky> turned(const GeneratedSky& sky, const Xform& xform) {
    return std::make_shared<const GeneratedSky>(GeneratedSky{sky.sky, sky.turn * rotationOf(xform.matrix)});
}

std::shared_ptr<const Pattern> patternOf(const GeneratedSky& sky, const Matrix4d& toScene) {
    return skyPattern(sky.sky, sky.turn * rotationOf(toScene), kLumensPerWatt);
}

Result<Primitives> generateSky(const std::string& program, std::span<const std::string> words, const Place& place, WarningList& warnings) {
    auto made = generateDaylight(program, words);
    if (!made) return place.error(made.error().code, made.error().text());
    for (const auto& text : made->warnings) warnings.add(fmt::format("{}: {}", place.text(), text));
    Primitives out;
    for (const auto& sun : made->sky.suns) {
        const Rgb radiance = sun.radiance * static_cast<float>(1 / kLumensPerWatt);
        out.push_back({"void", "light", "solar", {}, {radiance.r, radiance.g, radiance.b}, {}, place, nullptr});
        out.push_back({"solar", "source", "sun", {}, {sun.direction.x, sun.direction.y, sun.direction.z, 2 * sun.halfAngleRad / kDegree}, {}, place, nullptr});
    }
    made->sky.suns.clear();
    out.push_back({"void", "brightfunc", "skyfunc", {}, {}, {}, place, std::make_shared<const GeneratedSky>(GeneratedSky{std::move(made->sky), {}})});
    return out;
}

Result<void> placeSource(const SourceLight& light, Sky& sky) {
    const auto& p = light.source;
    const auto& n = p.numbers;
    Vec3d direction(0, 0, 0);
    light.toScene.multDirMatrix(Vec3d(n[0], n[1], n[2]), direction);
    if (!(direction.length() > 0)) return p.place.error(ErrorCode::Parse, fmt::format("source {} has the direction 0 0 0, expected another", p.name));
    if (!(n[3] > 0 && n[3] <= 360)) return p.place.error(ErrorCode::Parse, fmt::format("source {} has an angle of {} degrees, expected more than 0 and at most 360", p.name, n[3]));
    const Vec3 towards(direction.normalized());
    const double halfAngle = n[3] / 2 * kDegree;
    if (!light.pattern && n[3] <= kMostSunDeg) {
        Sun sun;
        sun.direction = towards;
        sun.halfAngleRad = halfAngle;
        sun.radiance = light.radiance;
        sky.suns.push_back(sun);
    } else {
        sky.domes.push_back({towards, halfAngle, light.radiance, light.pattern});
    }
    return {};
}

}  // namespace luxdeck::rad

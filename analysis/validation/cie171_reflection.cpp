#include "analysis/validation/cie171_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace luxdeck::cie171 {

namespace {

constexpr double kReflectance = 0.5, kSunLux = 1e5;

/// The sun alone: its light is the same all over a patch, and of its reflection nothing but the patch's comes back.
Sky sunAlone(const Vec3d& direction) {
    Sky sky;
    sky.suns.push_back(Sun::ofNormalLux(Vec3(direction), kSunLux));
    return sky;
}

/// What comes from a lit diffuse patch, over what falls on it and its reflectance: the configuration factor.
Cie171Quantity reflected(const Place& place, double patchLux, double factor, std::string note = "") {
    auto q = single(place, "-", 1 / (patchLux * kReflectance), {factor, 0, std::move(note)});
    q.reflectedAlone = true;
    return q;
}

void addPatch(Cases& cases, double side, std::initializer_list<Place> places) {
    const Patch patch{{-side / 2, -side / 2, 0}, {side, 0, 0}, {0, side, 0}};
    const Vec3d sun = Vec3d(-0.3, -0.2, 1).normalized();
    Cie171Case one{"5.6", "light reflection over diffuse surfaces", fmt::format("patch of {:g} m", side), false, {}, {}};
    one.scene = [=]() -> Result<Scene> {
        SceneBuilder b;
        addQuad(b, patch, b.matte(static_cast<float>(kReflectance)));
        return b.sky(sunAlone(sun)).checked();
    };
    for (const auto& place : places)
        one.quantities.push_back(reflected(place, kSunLux * sun.z, configurationFactor(patch.corners(), place.at, place.normal)));
    cases.push_back(std::move(one));
}

void addPatches(Cases& cases) {
    const Vec3d down{0, 0, -1}, back{-1, 0, 0};
    addPatch(cases, 0.5, {{"ceiling, 1 m above", {0, 0, 1}, down}, {"wall at 0.5 m, 0.4 m high", {0.5, 0, 0.4}, back}, {"ceiling, 1 m above, 0.6 m aside", {0.6, 0, 1}, down}});
    addPatch(cases, 4, {{"ceiling, 3 m above", {0, 0, 3}, down}, {"ceiling, 3 m above, corner", {1.8, 1.8, 3}, down},
                       {"wall at its edge, 1 m high", {2, 0, 1}, back}, {"wall at its edge, 2.5 m high", {2, 1.5, 2.5}, back}});
    addPatch(cases, 500, {{"ceiling, 3 m above", {0, 0, 3}, down}, {"wall at its edge, 2 m high", {250, 0, 2}, back}, {"wall at its edge, 40 m high", {250, 0, 40}, back}});
}

/// A lit patch of wall behind a black panel parallel to it: what is seen of it is a rectangle less the panel's shadow from
/// the point, another rectangle. The sun stands so high that the panel's own shadow falls below the patch.
void addObstruction(Cases& cases) {
    const Patch lit{{0, -2, 0}, {0, 4, 0}, {0, 0, 3}};
    const Vec3d sun = Vec3d(0.5, 0.1, 1).normalized();
    const double panelX = 1.5, y0 = -0.8, y1 = 0.6, z0 = 0.4, z1 = 1.6;
    Cie171Case one{"5.7", "diffuse reflection with internal obstruction", "wall 4 x 3 m, panel 1.4 x 1.2 m before it", false, {}, {}};
    one.scene = [=]() -> Result<Scene> {
        SceneBuilder b;
        addQuad(b, lit, b.matte(static_cast<float>(kReflectance)));
        addQuad(b, {{panelX, y0, z0}, {0, y1 - y0, 0}, {0, 0, z1 - z0}}, b.matte(0));
        return b.sky(sunAlone(sun)).checked();
    };
    for (const auto& place : {Place{"floor, 3 m from the wall", {3, 0, 0}, {0, 0, 1}}, Place{"floor, 4 m, aside", {4, 1, 0}, {0, 0, 1}},
                              Place{"opposite wall, 4 m, 1 m high", {4, 0, 1}, {-1, 0, 0}}, Place{"opposite wall, 4 m, 2 m high", {4, -1, 2}, {-1, 0, 0}},
                              Place{"ceiling, 3 m from the wall", {3, 0, 3}, {0, 0, -1}}}) {
        const double k = place.at.x / (place.at.x - panelX);
        const auto y = [&](double at) { return std::clamp(place.at.y + k * (at - place.at.y), -2.0, 2.0); };
        const auto z = [&](double at) { return std::clamp(place.at.z + k * (at - place.at.z), 0.0, 3.0); };
        const Patch hidden{{0, y(y0), z(z0)}, {0, y(y1) - y(y0), 0}, {0, 0, z(z1) - z(z0)}};
        const double whole = configurationFactor(lit.corners(), place.at, place.normal);
        const double unseen = configurationFactor(hidden.corners(), place.at, place.normal);
        one.quantities.push_back(reflected(place, kSunLux * sun.x, whole - unseen, fmt::format("unobstructed {:.4f}", whole)));
    }
    cases.push_back(std::move(one));
}

/// Mean over a closed room: lumens / (A (1 - rho)) by energy alone. A lamp in the middle of a cube: all faces are alike,
/// and the four quarters of each.
void addCube(Cases& cases, double rho) {
    constexpr double kLumens = 10000, kSide = 4;
    Cie171Case one{"5.8", "internal reflected component", fmt::format("cube of 4 m, reflectance {:g}", rho), rho == 0, {}, {}};
    one.scene = [=]() -> Result<Scene> {
        SceneBuilder b;
        const auto side = static_cast<float>(kSide);
        return b.box({0, 0, 0}, {side, side, side}, b.matte(static_cast<float>(rho)), true, 1).isotropic(Vec3(side / 2), kLumens).checked();
    };
    Cie171Quantity mean{"mean over the walls", "lx", {}, {}, false, {kLumens / (6 * kSide * kSide * (1 - rho)), 0, ""}};
    integrateOver({{0, 0, 0}, {kSide / 2, 0, 0}, {0, kSide / 2, 0}}, {0, 0, 1}, 6, mean);
    for (auto& weight : mean.weights) weight /= kSide * kSide / 4;
    one.quantities.push_back(std::move(mean));
    cases.push_back(std::move(one));
}

}  // namespace

void addReflectionCases(Cases& cases) {
    addPatches(cases);
    addObstruction(cases);
    for (const double rho : {0.0, 0.2, 0.5, 0.8, 0.9, 0.95}) addCube(cases, rho);
}

}  // namespace luxdeck::cie171

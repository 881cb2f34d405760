#include "analysis/validation/cie171_cases.h"
#include "engine/scene/opening.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <utility>

namespace luxdeck::cie171 {

namespace {

constexpr double kLampM = 3;          // height
constexpr double kLuminance = 1000;   // of area sources [cd/m^2]

/// Linear in both angles [deg], so that interpolating a table of it is exact.
double candela(double v, double h) { return (1000 - 5 * v) * (1 + (180 - std::abs(180 - h)) / 360); }

Result<Scene> pointLamp() {
    std::vector<double> vertical, horizontal, values;
    for (int v = 0; v <= 180; v += 10) vertical.push_back(v);
    for (int h = 0; h <= 360; h += 30) {
        horizontal.push_back(h);
        for (const double v : vertical) values.push_back(candela(v, h));
    }
    auto table = CandelaTable::create(PhotometryType::C, std::move(vertical), std::move(horizontal), std::move(values));
    if (!table) return table.error();
    SceneBuilder b;
    return b.luminaire({0, 0, static_cast<float>(kLampM)}, *std::move(table), {}).checked();
}

/// I(C, gamma) cos / d^2.
double fromPoint(const Place& place) {
    const Vec3d way = Vec3d(0, 0, kLampM) - place.at;
    const double v = std::acos(way.z / way.length()) / kDegree;
    double h = std::atan2(-way.y, -way.x) / kDegree;
    if (h < 0) h += 360;
    return candela(v, h) * way.dot(place.normal) / std::pow(way.length(), 3);
}

void addPointSource(Cases& cases) {
    Cie171Case one{"5.2", "point light sources", "I(C, g) of a table, lamp 3 m high", true, pointLamp, {}};
    for (const auto& place : {Place{"floor, 0.5 m towards C180", {-0.5, 0, 0}, {0, 0, 1}}, Place{"floor, 1 m towards C0", {1, 0, 0}, {0, 0, 1}},
                              Place{"floor, 2 m towards C90", {0, 2, 0}, {0, 0, 1}}, Place{"floor, C217, 3.6 m", {-2.9, -2.2, 0}, {0, 0, 1}},
                              Place{"floor, 5 m towards C315", {3.5, -3.5, 0}, {0, 0, 1}}, Place{"wall at 2 m, 1 m high", {2, 0, 1}, {-1, 0, 0}},
                              Place{"wall at 2 m, 2.5 m high, aside", {2, 1, 2.5}, {-1, 0, 0}}, Place{"wall at 4 m, 0.5 m high", {0, 4, 0.5}, {0, -1, 0}}})
        one.quantities.push_back(single(place, "lx", 1, {fromPoint(place), 0, ""}));
    cases.push_back(std::move(one));
}

void addArea(Cases& cases, const std::string& configuration, const Patch& source, bool luminaire, std::initializer_list<Place> places) {
    Cie171Case one{"5.3", "area light sources", configuration, true, {}, {}};
    one.scene = [=]() -> Result<Scene> {
        SceneBuilder b;
        if (!luminaire) {
            addQuad(b, source, b.glowing(static_cast<float>(kLuminance), 0));
            return b.checked();
        }
        const Vec3d centre = source.corner + (source.u + source.v) / 2;
        return b.lambertian(Vec3(centre) + Vec3(0, 0, kFlushM), kLuminance * source.area(), {OpeningShape::Rectangle, source.u.length(), source.v.length(), 0}).checked();
    };
    for (const auto& place : places)
        one.quantities.push_back(single(place, "lx", 1, {kPiD * kLuminance * configurationFactor(source.corners(), place.at, place.normal), 0, ""}));
    cases.push_back(std::move(one));
}

void addAreaSources(Cases& cases) {
    const Place below{"floor, below", {0, 0, 0}, {0, 0, 1}}, aside{"floor, 2 m aside", {2, 0.5, 0}, {0, 0, 1}};
    const Place wall{"wall at 2.5 m, 1 m high", {2.5, 0, 1}, {-1, 0, 0}};
    addArea(cases, "luminaire 2 x 1 m, 3 m high", {{-1, -0.5, 3}, {2, 0, 0}, {0, 1, 0}}, true, {below, aside, wall});
    addArea(cases, "glowing ceiling part 1 x 1 m", {{-0.5, -0.5, 3}, {0, 1, 0}, {1, 0, 0}}, false, {below, aside, wall});
    addArea(cases, "glowing wall part 2 x 2 m", {{0, -1, 0.5}, {0, 2, 0}, {0, 0, 2}}, false,
            {{"floor at 1.5 m", {1.5, 0, 0}, {0, 0, 1}}, {"plane 1.2 m high, cut by it", {1.5, 0.3, 1.2}, {0, 0, 1}}, {"opposite wall, 3 m", {3, 0.5, 1}, {-1, 0, 0}}});
}

}  // namespace

void addGlassCases(Cases& cases) {
    constexpr double kDistanceM = 4, kCandela = 1600;
    const ReferenceGlass glass(kGlassTransmittance, kGlassIor);
    for (int degrees = 0; degrees <= 80; degrees += 10) {
        const double angle = degrees * kDegree, cosine = std::cos(angle), bare = kCandela * cosine / (kDistanceM * kDistanceM);
        const auto scene = [=]() -> Result<Scene> {
            SceneBuilder b;
            b.quad({-50, -50, 0.2F}, {100, 0, 0}, {0, 100, 0}, b.material(clearGlass()));
            return b.isotropic(Vec3(Vec3d(kDistanceM * std::sin(angle), 0, kDistanceM * cosine)), 4 * kPiD * kCandela).checked();
        };
        Cie171Case one{"5.5", "directional transmittance of clear glass", fmt::format("{} degrees", degrees), true, scene, {}};
        Cie171Reference reference{glass.transmittance(cosine), 0, fmt::format("Mitalas {:.4f}", mitalas(kGlassTransmittance, cosine))};
        one.quantities.push_back(single({"behind the pane", {0, 0, 0}, {0, 0, 1}}, "-", 1 / bare, std::move(reference)));
        cases.push_back(std::move(one));
    }
}

void addLampCases(Cases& cases) {
    addPointSource(cases);
    addAreaSources(cases);
}

}  // namespace luxdeck::cie171

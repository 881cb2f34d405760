#include "analysis/validation/cie171_cases.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace luxdeck::cie171 {

namespace {

using Luminance = std::function<double(const Vec3d&)>;

/// Of all skies that have one.
const Vec3d& sunDirection() {
    static const Vec3d direction{-std::cos(50 * kDegree) * std::cos(30 * kDegree), std::cos(50 * kDegree) * std::sin(30 * kDegree), std::sin(50 * kDegree)};
    return direction;
}

/// Light by direction times what a pane in the opening passes of it.
Luminance through(bool glazed, const Vec3d& facing, Luminance luminance) {
    if (!glazed) return luminance;
    const ReferenceGlass glass(kGlassTransmittance, kGlassIor);
    return [=](const Vec3d& w) { return luminance(w) * glass.transmittance(std::abs(w.dot(facing))); };
}

/// In percent of the horizontal illuminance outside.
Cie171Reference percent(const Cie171Reference& inside, const Cie171Reference& outside) {
    const double value = 100 * inside.value / outside.value;
    return {value, value * (inside.error / std::max(inside.value, 1e-12) + outside.error / outside.value), ""};
}

/// tau_1 and tau_2 of the rectangle: integrals of cos and cos^2 over what is seen of it. Source: LIGHTING-FACTS F.5 (Arvo
/// 1995, axial moments).
struct Moments {
    double first = 0, second = 0;
};
Moments moments(const Patch& opening, const Vec3d& at) {
    const Vec3d up{0, 0, 1};
    const auto corners = opening.corners();
    const auto r = [&](std::size_t i) { return (corners[i % 4] - at).normalized(); };
    const auto triangle = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) { return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a)); };
    double sum = std::abs(triangle(r(0), r(1), r(2)) + triangle(r(0), r(2), r(3)));  // solid angle [sr]
    Vec3d middle(0, 0, 0);
    for (std::size_t i = 0; i < 4; ++i) middle += r(i);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3d a = r(i), c = a.cross(r(i + 1));
        const double angle = std::atan2(c.length(), a.dot(r(i + 1)));
        const Vec3d outward = c.normalized() * (c.dot(middle) > 0 ? -1.0 : 1.0);
        const Vec3d b = (r(i + 1) - a * std::cos(angle)) / std::sin(angle);
        sum -= up.dot(outward) * (up.dot(a) * std::sin(angle) + up.dot(b) * (1 - std::cos(angle)));
    }
    return {kPiD * configurationFactor(corners, at, up), sum / 3};
}

/// In closed form for the two skies that have one, where no pane dims.
Cie171Reference skylightAt(const Patch& opening, const Place& place, const ReferenceSky& sky, bool glazed) {
    if (!glazed && (sky.type == 0 || sky.type == 16)) {
        const auto m = moments(opening, place.at);
        return {sky.type == 0 ? m.first : (m.first + 2 * m.second) / 3, 0, ""};
    }
    return throughOpening(opening, place.at, place.normal, through(glazed, {0, 0, 1}, [=](const Vec3d& w) { return sky.luminance(w); }));
}

void addRoof(Cases& cases, double side, const ReferenceSky& sky, bool glazed) {
    const Vec3d low(-2, -2, 0), high(2, 2, 3);
    const Patch roof = faceOf(low, high, Face::Ceiling);
    const double gap = (4 - side) / 8;
    const Hole hole{gap, 1 - gap, gap, 1 - gap};
    const auto outside = sky.horizontal();
    const bool closedForm = sky.type == 0 || sky.type == 16;
    Cie171Case one{glazed ? "5.10" : "5.9", glazed ? "SC, roof opening with glass" : "SC, roof opening", side > 1 ? "4 x 4 m, " : "1 x 1 m, ", closedForm && !glazed, {}, {}};
    one.configuration += nameOf(sky);
    one.scene = [=]() -> Result<Scene> {
        SceneBuilder b;
        const auto black = b.matte(0);
        addWall(b, roof, hole, black);
        addOtherFaces(b, low, high, Face::Ceiling, black);
        if (glazed) addQuad(b, holeIn(roof, hole), b.material(clearGlass()));
        return b.sky(engineSky(sky, 0)).checked();
    };
    for (const auto& place : {Place{"floor, middle", {0, 0, 0.001}, {0, 0, 1}}, Place{"floor, 1.5 m aside both ways", {1.5, -1.5, 0.001}, {0, 0, 1}}})
        one.quantities.push_back(single(place, "%", 100 / (outside.value * kZenithCdM2), percent(skylightAt(holeIn(roof, hole), place, sky, glazed), outside)));
    cases.push_back(std::move(one));
}

/// The facade is the plane x = 0, the room beyond it towards +x; masks are continuous, which is to say that their ends
/// are seen from none of the places.
struct Facade {
    std::string number, subject;
    bool glazed = false;
    double overhangM = 0;   // depth of a black-topped slab above the window; its underside is lit by the ground
    double oppositeM = 0;   // distance of a wall opposite
};

constexpr double kGround = 0.3, kMask = 0.4;                        // reflectances
constexpr double kSill = 1, kHead = 2.5, kHalfWidth = 1;            // of the window [m]
constexpr double kMaskHeight = 2.6, kOppositeTop = 4, kReach = 60;  // [m]

/// What is seen through the window: the mask in its own part of it, sky and ground in the rest.
Cie171Reference windowAt(const Facade& f, const Place& p, const ReferenceSky& sky, double groundL, double maskL) {
    double low = kSill, high = kHead;  // the part without mask
    if (f.overhangM > 0) high = std::clamp(p.at.z + (kMaskHeight - p.at.z) * p.at.x / (p.at.x + f.overhangM), kSill, kHead);
    if (f.oppositeM > 0) low = std::clamp(p.at.z + (kOppositeTop - p.at.z) * p.at.x / (p.at.x + f.oppositeM), kSill, kHead);
    const double horizon = std::clamp(p.at.z, low, high);
    const auto band = [&](double from, double to, const Luminance& luminance) {
        const Patch part{{0, -kHalfWidth, from}, {0, 2 * kHalfWidth, 0}, {0, 0, to - from}};
        return throughOpening(part, p.at, p.normal, through(f.glazed, {1, 0, 0}, luminance));
    };
    Cie171Reference sum;
    for (const auto& part : {band(low, horizon, [=](const Vec3d&) { return groundL; }), band(horizon, high, [=](const Vec3d& w) { return sky.luminance(w); }),
                             band(kSill, low, [=](const Vec3d&) { return maskL; }), band(high, kHead, [=](const Vec3d&) { return maskL; })})
        sum.value += part.value, sum.error += part.error;
    return sum;
}

/// A mask glows with the even luminance that the standard gives it, so that the reference is exact: the underside of a slab
/// sees the ground alone, a wall opposite sees half of the sky (as if even) and half of the ground.
double maskLuminance(const Facade& f, double outside, double groundL) {
    if (f.overhangM > 0) return kMask * groundL;
    return f.oppositeM > 0 ? kMask * (outside / 2 + kPiD * groundL / 2) / kPiD : 0;
}

Result<Scene> facadeScene(const Facade& f, const ReferenceSky& sky, double maskL) {
    SceneBuilder b;
    const auto black = b.matte(0);
    const Vec3d low(0, -2, 0), high(6, 2, 3);
    const Patch wall = faceOf(low, high, Face::West);
    const Hole hole{0.5 - kHalfWidth / 4, 0.5 + kHalfWidth / 4, kSill / 3, kHead / 3};
    addWall(b, wall, hole, black);
    addOtherFaces(b, low, high, Face::West, black);
    if (f.glazed) addQuad(b, holeIn(wall, hole), b.material(clearGlass()));
    const auto glow = b.glowing(static_cast<float>(maskL * kZenithCdM2), 0);
    if (f.overhangM > 0) addQuad(b, {{-f.overhangM, -kReach, kMaskHeight}, {0, 2 * kReach, 0}, {f.overhangM, 0, 0}}, glow);
    if (f.oppositeM > 0) addQuad(b, {{-f.oppositeM, -kReach, -kReach}, {0, 2 * kReach, 0}, {0, 0, kReach + kOppositeTop}}, glow);
    return b.sky(engineSky(sky, kGround)).checked();
}

void addFacade(Cases& cases, const Facade& f, const ReferenceSky& sky) {
    const auto outside = sky.horizontal();
    const double groundL = kGround * outside.value / kPiD, maskL = maskLuminance(f, outside.value, groundL);
    Cie171Case one{f.number, f.subject, nameOf(sky), false, [=] { return facadeScene(f, sky, maskL); }, {}};
    for (const auto& place : {Place{"desk height, 1 m inside", {1, 0, 0.8}, {0, 0, 1}}, Place{"desk height, 3 m inside", {3, 0.5, 0.8}, {0, 0, 1}},
                              Place{"back wall, 1.7 m high", {5.99, 0, 1.7}, {-1, 0, 0}}, Place{"ceiling, 2 m inside", {2, 0, 2.99}, {0, 0, -1}}})
        one.quantities.push_back(single(place, "%", 100 / (outside.value * kZenithCdM2), percent(windowAt(f, place, sky, groundL, maskL), outside)));
    std::erase_if(one.quantities, [](const auto& q) { return q.reference.value <= 0; });
    cases.push_back(std::move(one));
}

}  // namespace

void addRoofCases(Cases& cases) {
    for (const double side : {1.0, 4.0})
        for (int type = 0; type <= 16; ++type) addRoof(cases, side, {type, sunDirection()}, false);
    for (const double side : {1.0, 4.0})
        for (const int type : {0, 1, 5, 12, 16}) addRoof(cases, side, {type, sunDirection()}, true);
}

void addFacadeCases(Cases& cases) {
    for (const auto& f : {Facade{"5.11", "SC + ERC, window opening"}, Facade{"5.12", "SC + ERC, window with glass", true},
                          Facade{"5.13", "SC + ERC, continuous horizontal mask", false, 1.5, 0}, Facade{"5.14", "SC + ERC, continuous vertical mask", false, 0, 6}})
        for (const int type : {1, 5, 12, 16}) addFacade(cases, f, {type, sunDirection()});
}

}  // namespace luxdeck::cie171

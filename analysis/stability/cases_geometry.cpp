#include "analysis/stability/cases.h"

#include <array>

namespace luxdeck::stability {

namespace {

/// A black hall of 50 m with a lamp 10 m up and a plate of 1 mm, 5 mm above the floor, exactly between lamp and origin.
Scene hallWithClip() {
    SceneBuilder b;
    const auto black = b.matte(0);
    const float mm = 0.001F;
    b.box({-25, -25, 0}, {25, 25, 12}, black, true).quad({-mm / 2, -mm / 2, 5 * mm}, {mm, 0, 0}, {0, mm, 0}, black);
    return b.isotropic({0, 0, 10}, 4 * kPiD * 1e5).build();
}

/// Two rooms of 4 x 4 x 3 m that share one wall of triangles; the lamp is in the first.
Scene dividedRoom() {
    SceneBuilder b;
    const auto white = b.matte(0.8F);
    b.box({0, 0, 0}, {8, 4, 3}, white, true).quad({4, 0, 0}, {0, 4, 0}, {0, 0, 3}, white);
    return b.isotropic({2, 2, 1.5F}, 10000).build();
}

/// Mean illuminance of the lit room: lm / (A (1 - rho)), A = 80 m^2.
constexpr double kLitRoomLux = 10000 / (80 * 0.2);

/// On the dark side: on the wall itself, a millimetre from its edges, and away from it.
std::vector<SensorQuery> darkSide() {
    return {facing({4, 2, 1.5F}, {1, 0, 0}),       facing({4, 0.001F, 0.001F}, {1, 0, 0}), facing({4.001F, 2, 0}, {0, 0, 1}),
            facing({4.001F, 0.001F, 0}, {0, 0, 1}), facing({4.001F, 2, 3}, {0, 0, -1}),     facing({6, 2, 1}, {-1, 0, 0})};
}

/// A furnace whose floor is a fan of slivers, with triangles of no area between them.
Result<Scene> sliverFurnace() {
    SceneBuilder b;
    const auto glow = b.glowing(static_cast<float>(kFurnaceCdM2), 0.5F);
    b.quad({0, 0, 4}, {0, 4, 0}, {4, 0, 0}, glow).quad({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, glow).quad({0, 4, 0}, {4, 0, 0}, {0, 0, 4}, glow);
    b.quad({0, 0, 0}, {0, 4, 0}, {0, 0, 4}, glow).quad({4, 0, 0}, {0, 0, 4}, {0, 4, 0}, glow);
    Mesh fan;
    fan.name = "slivers", fan.material = glow;
    constexpr std::uint32_t kSlivers = 4000;
    fan.positions.emplace_back(0, 0, 0);
    for (std::uint32_t i = 0; i <= kSlivers; ++i) {
        const float along = 8 * static_cast<float>(i) / kSlivers;
        fan.positions.emplace_back(along < 4 ? 4 : 8 - along, along < 4 ? along : 4, 0);
    }
    for (std::uint32_t i = 1; i <= kSlivers; ++i) {
        fan.triangles.push_back({0, i, i + 1});
        fan.triangles.push_back({i, i, i + 1});  // a line
    }
    fan.triangles.push_back({0, 0, 0});  // a point
    fan.triangles.push_back({1, kSlivers / 4, kSlivers / 2});  // on one line
    return b.mesh(std::move(fan)).checked();
}

/// Everything twice in the same place, as a file may have it.
Result<Scene> twice(Scene scene) {
    const auto count = scene.meshes.size();
    for (std::size_t i = 0; i < count; ++i) scene.meshes.push_back(Mesh(scene.meshes[i]));
    if (const auto ok = validate(scene); !ok) return ok.error();
    return scene;
}

/// Where floats are 1/16 m apart, lights of 4 x 4 m are sampled at points that lie up to 1/32 m off, and shadow rays
/// from them meet the walls beside: up to 4 / 32 / 4 of the light of each is lost. It is what re-basing is for.
Criterion coarse(Criterion c) {
    c.slackLux = *c.lux / 32;
    c.why += "; 1/32 for points that are rounded to 1/16 m";
    return c;
}

/// The furnace where a survey's grid has it, re-based as readers do.
Scene surveyed() {
    SceneBuilder b;
    Scene scene = furnace(b, 0.5F).build();
    scene.origin = {1'000'000, 6'000'000, 500};
    return scene;
}

}  // namespace

void addGeometryCases(Cases& cases) {
    const double free = 1e5 / 100;
    const std::string scale = "scale 50,000:1, ";
    // From 2 mm beside the plate's middle the lamp is seen past it: at 5 mm height the plate hides 0.5 mm.
    const auto lit = is(free, 1e-4 * free, "closed form I / d^2"), hidden = is(0, 0, "the plate hides the point lamp");
    cases.push_back({scale + "behind a plate of 1 mm", []() -> Result<Scene> { return hallWithClip(); }, {facing({0, 0, 0}, {0, 0, 1})}, hidden, hidden});
    cases.push_back({scale + "2 mm beside it", []() -> Result<Scene> { return hallWithClip(); }, {facing({0.002F, 0, 0}, {0, 0, 1})}, lit, lit});

    cases.push_back({"coordinates at 10^6 m, not re-based", []() -> Result<Scene> {
                         SceneBuilder b;
                         return furnace(b, 0.5F, {1e6F, 1e6F, 0}).checked();
                     }, {facing({1e6F + 2, 1e6F + 2, 0}, {0, 0, 1})}, coarse(furnaceTotal(0.5)), coarse(furnaceStraight())});
    cases.push_back({"coordinates at 10^6 m, re-based", []() -> Result<Scene> { return surveyed(); },
                     {facing(surveyed().toRebased({1'000'001, 6'000'001, 500}), {0, 0, 1})}, furnaceTotal(0.5), furnaceStraight()});

    const auto dark = is(0, 1e-6 * kLitRoomLux, "dark behind an opaque wall: at most a millionth of the lit room's mean");
    cases.push_back({"wall without thickness: the dark side", []() -> Result<Scene> { return dividedRoom(); }, darkSide(), dark, dark});

    cases.push_back({"slivers and triangles without area", sliverFurnace, {facing({1, 1.3F, 0}, {0, 0, 1})}, furnaceTotal(0.5), furnaceStraight()});
    cases.back().precision = 0.05;  // few paths meet a sliver and count for much: the interval follows their skewness (decision 12)
    cases.push_back({"coplanar faces, matte", [] { return twice(integratingSphere(1)); }, {sphereSensor()}, sphereTotal(), sphereStraight()});
    cases.push_back({"coplanar faces, emitting", [] {
                         SceneBuilder b;
                         return twice(furnace(b, 0.5F).build());
                     }, {facing({1, 1.3F, 0}, {0, 0, 1})}, furnaceTotal(0.5), furnaceStraight()});

    cases.push_back({"stored in millimetres", []() -> Result<Scene> { return integratingSphere(0.001); }, {sphereSensor()}, sphereTotal(), sphereStraight()});
    cases.push_back({"stored in kilometres", []() -> Result<Scene> { return integratingSphere(1000); }, {sphereSensor()}, sphereTotal(), sphereStraight()});
}

}  // namespace luxdeck::stability

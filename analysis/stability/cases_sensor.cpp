#include "analysis/stability/cases.h"

namespace luxdeck::stability {

namespace {

Result<Scene> plainFurnace() {
    SceneBuilder b;
    return furnace(b, 0.5F).checked();
}

/// A closed box stands in a lit room.
Result<Scene> solidInRoom() {
    SceneBuilder b;
    const auto matte = b.matte(0.5F);
    return b.box({0, 0, 0}, {4, 4, 4}, matte, true).box({1, 1, 1}, {2, 2, 2}, matte, false, 3).isotropic({3, 3, 3}, 1000).checked();
}

}  // namespace

void addSensorCases(Cases& cases) {
    const auto add = [&](const char* name, const SensorQuery& sensor) {
        cases.push_back({name, plainFurnace, {sensor}, furnaceTotal(0.5), furnaceStraight()});
    };
    add("sensor exactly on a surface", facing({1.7F, 1.3F, 0}, {0, 0, 1}));
    add("sensor exactly on an edge, facing between", facing({0, 2, 0}, {1, 0, 1}));
    add("sensor exactly in a corner, facing out of it", facing({0, 0, 0}, {1, 1, 1}));
    // In the plane of the wall half of the directions begin: they may count as within the room or as beyond it.
    const auto halfOrWhole = [](Criterion c) {
        c.slackLux = *c.lux / 4, c.lux = 0.75 * *c.lux;
        c.why += ", or half of it: the wall's plane may count to either side";
        return c;
    };
    cases.push_back({"sensor exactly on an edge, facing up", plainFurnace, {facing({0, 2, 0}, {0, 0, 1})}, halfOrWhole(furnaceTotal(0.5)), halfOrWhole(furnaceStraight())});
    const auto dark = is(0, 0, "no light in a closed solid: exactly");
    cases.push_back({"sensor inside a solid", solidInRoom, {facing({1.5F, 1.5F, 1.5F}, {0, 0, 1})}, dark, dark});
}

}  // namespace luxdeck::stability

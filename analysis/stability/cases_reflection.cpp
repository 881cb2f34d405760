#include "analysis/stability/cases.h"

#include <fmt/format.h>

namespace luxdeck::stability {

namespace {

/// Lamp in the middle of a cube of side 4 m.
Scene cube(float reflectance) {
    SceneBuilder b;
    return b.box({0, 0, 0}, {4, 4, 4}, b.matte(reflectance), true).isotropic({2, 2, 2}, 10000).build();
}

/// Mirrors that lose nothing on four sides, black at both ends: every path gets out, after many reflections.
Scene mirrorTunnel() {
    SceneBuilder b;
    Material mirror;
    mirror.name = "perfect mirror", mirror.kind = MaterialKind::Mirror, mirror.specular = Rgb(1.0F);
    const auto m = b.material(mirror), glow = b.glowing(static_cast<float>(kFurnaceCdM2), 0);
    b.quad({0, 0, 0}, {20, 0, 0}, {0, 0.1F, 0}, m).quad({0, 0, 0.1F}, {0, 0.1F, 0}, {20, 0, 0}, m);
    b.quad({0, 0, 0}, {0, 0, 0.1F}, {20, 0, 0}, m).quad({0, 0.1F, 0}, {20, 0, 0}, {0, 0, 0.1F}, m);
    b.quad({0, 0, 0}, {0, 0.1F, 0}, {0, 0, 0.1F}, glow).quad({20, 0, 0}, {0, 0, 0.1F}, {0, 0.1F, 0}, glow);
    return b.build();
}

}  // namespace

void addReflectionCases(Cases& cases) {
    for (const float reflectance : {0.5F, 0.9F, 0.99F, 0.999F}) {
        StabilityCase c;
        c.name = fmt::format("furnace, reflectance {}", reflectance);
        c.scene = [reflectance]() -> Result<Scene> {
            SceneBuilder b;
            return furnace(b, reflectance).checked();
        };
        c.sensors = {facing({1, 1.3F, 0}, {0, 0, 1})};
        c.exact = furnaceTotal(reflectance), c.straight = furnaceStraight();
        // A path takes 1 / (1 - rho) reflections: fewer of them where each is long.
        if (reflectance > 0.98F) c.precision = 0.1, c.mostPaths = reflectance > 0.995F ? 2048 : 8192;
        cases.push_back(c);
    }
    const double atFloor = 10000 / (4 * kPiD) / 4;
    cases.push_back({"closed room, reflectance 1", []() -> Result<Scene> { return cube(1); }, {facing({2, 2, 0}, {0, 0, 1})},
                     isRefused("never lost"), is(atFloor, 1e-4 * atFloor, "closed form I / d^2")});
    cases.push_back({"tunnel of perfect mirrors", []() -> Result<Scene> { return mirrorTunnel(); }, {facing({10, 0.05F, 0.05F}, {1, 0, 0})},
                     is(kPiD * kFurnaceCdM2, 5e-4 * kPiD * kFurnaceCdM2, "closed form pi L: mirrors lose nothing; float's rounding at some 200 of them"),
                     isSane("light straight from the tunnel's end alone")});
}

}  // namespace luxdeck::stability

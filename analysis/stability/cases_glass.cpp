#include "analysis/stability/cases.h"

#include <cmath>

namespace luxdeck::stability {

namespace {

constexpr double kCandela = 1000, kLampM = 4;
constexpr float kTransmittance = 0.8F, kIor = 1.52F;

Material glass(float transmittance) {
    Material m;
    m.name = "glass", m.kind = MaterialKind::ThinGlass, m.transmittance = Rgb(transmittance), m.ior = kIor;
    return m;
}

/// What two bare surfaces let through straight on: (1 - R) / (1 + R).
float clear() {
    const float r = (kIor - 1) * (kIor - 1) / ((kIor + 1) * (kIor + 1));
    return (1 - r) / (1 + r);
}

/// The same at an angle, unpolarised: each polarisation by its own reflectance. Source: Fresnel.
double clearAt(double angle) {
    const double cosine = std::cos(angle), inside = std::sqrt(1 - std::pow(std::sin(angle) / kIor, 2));
    const double s = std::pow((cosine - kIor * inside) / (cosine + kIor * inside), 2);
    const double p = std::pow((kIor * cosine - inside) / (kIor * cosine + inside), 2);
    return ((1 - s) / (1 + s) + (1 - p) / (1 + p)) / 2;
}

/// The ray from lamp to sensor meets this many panes exactly on the diagonal that their triangles share.
Scene panesOnTheirDiagonals(int count) {
    SceneBuilder b;
    const auto pane = b.material(glass(kTransmittance));
    for (int i = 0; i < count; ++i) b.quad({-1, -1, 1 + static_cast<float>(i)}, {2, 0, 0}, {0, 2, 0}, pane);
    return b.isotropic({0, 0, static_cast<float>(kLampM)}, 4 * kPiD * kCandela).build();
}

/// Two panes that cross in an X, this far from where the ray from lamp to sensor meets both.
Scene crossedPanes(float besideM) {
    SceneBuilder b;
    const auto pane = b.material(glass(clear()));
    b.quad({-1, -1, 1}, {2, 0, 2}, {0, 2, 0}, pane).quad({-1, -1, 3}, {2, 0, -2}, {0, 2, 0}, pane);
    return b.isotropic({besideM, 0, static_cast<float>(kLampM)}, 4 * kPiD * kCandela).build();
}

/// A furnace with a glass ball in a ball of water, which absorb nothing.
Result<Scene> ballInBall() {
    SceneBuilder b;
    Material water, ball;
    water.name = "water", water.kind = MaterialKind::Dielectric, water.ior = 1.33F, water.transmittance = Rgb(1.0F);
    ball = water, ball.name = "glass", ball.ior = kIor;
    furnace(b, 0.5F);
    return b.sphere({2, 2, 2}, 1, b.material(water), false, 32).sphere({2, 2, 2}, 0.5F, b.material(ball), false, 32).checked();
}

}  // namespace

void addGlassCases(Cases& cases) {
    const std::vector<SensorQuery> below{facing({0, 0, 0}, {0, 0, 1})};
    const double bare = kCandela / (kLampM * kLampM);
    const auto through = [&](double transmittance, const char* why) { return is(bare * transmittance, 1e-4 * bare, why); };
    const auto one = through(kTransmittance, "I T / d^2: the shared edge counts once"), two = through(double{kTransmittance} * kTransmittance, "I T^2 / d^2");
    // What panes throw back and forth of a point lamp is found by no algorithm (their cards say so) and not in the value.
    cases.push_back({"pane met on its diagonal", []() -> Result<Scene> { return panesOnTheirDiagonals(1); }, below, one, one});
    cases.push_back({"two panes met on their diagonals", []() -> Result<Scene> { return panesOnTheirDiagonals(2); }, below, two, two});
    const double both = std::pow(clearAt(kPiD / 4), 2), single = clearAt(kPiD / 4);
    const auto crossed = through(both, "I T(45)^2 / d^2: both panes count");
    cases.push_back({"crossed panes, 1 mm beside their crossing", []() -> Result<Scene> { return crossedPanes(0.001F); }, {facing({0.001F, 0, 0}, {0, 0, 1})}, crossed, crossed});
    // Two panes at one point are met as one: a ray in a plane of measure zero, and it must not stick there.
    auto on = through((both + single) / 2, "I T(45)^2 / d^2 or I T(45) / d^2: one point counts as one pane or two");
    on.slackLux += bare * (single - both) / 2;
    cases.push_back({"crossed panes, exactly on their crossing", []() -> Result<Scene> { return crossedPanes(0); }, below, on, on});

    const auto partly = isSane("light that solids throw back is left out");
    cases.push_back({"glass ball in a ball of water, seen from outside", ballInBall, {facing({2, 2, 0}, {0, 0, 1})}, furnaceTotal(0.5), partly});
    auto inside = furnaceTotal(0.5);
    inside.lux = *inside.lux * kIor * kIor, inside.slackLux *= double{kIor} * kIor, inside.why = "closed form n^2 pi L / (1 - rho)";
    cases.push_back({"sensor in glass in water", ballInBall, {facing({2.1F, 2.05F, 1.9F}, {0.3F, 0.1F, 1})}, inside, partly});
}

}  // namespace luxdeck::stability

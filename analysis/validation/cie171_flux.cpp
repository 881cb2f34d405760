#include "analysis/validation/cie171_cases.h"

#include <utility>

namespace luxdeck::cie171 {

namespace {

const Vec3d kUp{0, 0, 1}, kSouth{0, -1, 0}, kNorth{0, 1, 0}, kEast{1, 0, 0}, kWest{-1, 0, 0};
constexpr int kGauss = 5;
const Vec3d kLow{-2, -2, 0}, kHigh{2, 2, 3};  // of the room

/// Through a roof opening all light of the sky comes in: flux = E_h A.
void addRoof(Cases& cases, const ReferenceSky& sky) {
    const Patch roof = faceOf(kLow, kHigh, Face::Ceiling);
    const Hole hole{0.375, 0.625, 0.375, 0.625};
    Cie171Case one{"5.4", "luminous flux conservation", "roof opening 1 x 1 m, " + nameOf(sky), true, {}, {}};
    one.scene = [=]() -> Result<Scene> {
        SceneBuilder b;
        const auto black = b.matte(0);
        addWall(b, roof, hole, black);
        addOtherFaces(b, kLow, kHigh, Face::Ceiling, black);
        return b.sky(engineSky(sky, 0)).checked();
    };
    Cie171Quantity flux{"sum of E A inside", "lm", {}, {}, false, {sky.horizontal().value * kZenithCdM2 * holeIn(roof, hole).area(), 0, ""}};
    integrateOver(faceOf(kLow, kHigh, Face::Floor), kUp, kGauss, flux);
    integrateOver(faceOf(kLow, kHigh, Face::South), kNorth, kGauss, flux);
    integrateOver(faceOf(kLow, kHigh, Face::North), kSouth, kGauss, flux);
    integrateOver(faceOf(kLow, kHigh, Face::West), kEast, kGauss, flux);
    integrateOver(faceOf(kLow, kHigh, Face::East), kWest, kGauss, flux);
    one.quantities.push_back(std::move(flux));
    cases.push_back(std::move(one));
}

/// Through a window from 1 to 2 m above the floor: flux = E_v A. Surfaces are parted where the horizon comes into the
/// window, so that what is integrated is smooth; nothing goes above the window's head, the ground being black.
void addWindow(Cases& cases) {
    const Patch wall = faceOf(kLow, kHigh, Face::West);
    const Hole hole{0.25, 0.75, 1.0 / 3, 2.0 / 3};
    const ReferenceSky sky{16};
    Cie171Case one{"5.4", "luminous flux conservation", "window 2 x 1 m, " + nameOf(sky) + ", black ground", true, {}, {}};
    one.scene = [=]() -> Result<Scene> {
        SceneBuilder b;
        const auto black = b.matte(0);
        addWall(b, wall, hole, black);
        addOtherFaces(b, kLow, kHigh, Face::West, black);
        return b.sky(engineSky(sky, 0)).checked();
    };
    const double vertical = (kPiD / 6 + 4.0 / 9) * kZenithCdM2;  // of the overcast sky, in closed form
    Cie171Quantity flux{"sum of E A inside", "lm", {}, {}, false, {vertical * holeIn(wall, hole).area(), 0, ""}};
    integrateOver(faceOf(kLow, kHigh, Face::Floor), kUp, kGauss, flux);
    for (const double z : {0.0, 1.0}) {
        const Vec3d low(-2, -2, z), high(2, 2, z + 1);
        integrateOver(faceOf(low, high, Face::South), kNorth, kGauss, flux);
        integrateOver(faceOf(low, high, Face::North), kSouth, kGauss, flux);
        integrateOver(faceOf(low, high, Face::East), kWest, kGauss, flux);
    }
    one.quantities.push_back(std::move(flux));
    cases.push_back(std::move(one));
}

}  // namespace

void addFluxCases(Cases& cases) {
    addRoof(cases, {0});
    addRoof(cases, {16});
    addWindow(cases);
}

}  // namespace luxdeck::cie171

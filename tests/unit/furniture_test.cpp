// Furniture lit from the volume of the room without it, against the furnished room solved by path tracing.
#include "analysis/furniture/taken_light.h"

#include "analysis/furniture/detail_levels.h"
#include "engine/core/parallel.h"
#include "engine/volume/volume_build.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

/// A room of 6 x 4 x 2.8 m, grey, one lamp over (1.5, 2).
SceneBuilder room() {
    SceneBuilder b;
    const auto grey = b.matte(0.5F);
    b.box({0, 0, 0}, {6, 4, 2.8F}, grey, true);
    b.lambertian({1.5F, 2, 2.6F}, 800, {});
    return b;
}

/// A table of 1.2 x 0.6 m, 0.75 m high: a board of 4 cm on two panels. Closed boxes, normals outwards, one object.
Mesh table(std::uint32_t material, const Vec3& foot) {
    Mesh mesh;
    mesh.name = "table", mesh.material = material;
    const auto box = [&](Vec3 low, Vec3 high) {
        low += foot, high += foot;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int i = 0; i < 8; ++i) mesh.positions.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z);
        const std::array<std::array<std::uint32_t, 4>, 6> faces{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& f : faces) mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]}), mesh.triangles.push_back({first + f[0], first + f[2], first + f[3]});
    };
    box({-0.6F, -0.3F, 0.71F}, {0.6F, 0.3F, 0.75F});
    box({-0.58F, -0.28F, 0}, {-0.54F, 0.28F, 0.71F});
    box({0.54F, -0.28F, 0}, {0.58F, 0.28F, 0.71F});
    return mesh;
}

Scene furnished(const Vec3& foot = {3, 2, 0}) {
    auto b = room();
    const auto wood = b.matte(0.4F, "wood");
    b.mesh(table(wood, foot));
    auto scene = b.build();
    scene.objects.back().movable = true;
    return scene;
}

struct Stage {
    Scene whole = furnished();
    Lit empty{withoutObject(whole, "table").value()};
    MovableObject object = makeMovableObject(whole, "table").value();
    IrradianceVolume volume;
    std::unique_ptr<FurnitureLighting> lighting;

    Stage() {
        VolumeSettings settings;
        settings.firstLevel = {7, 5, 5}, settings.secondLevel = 3, settings.side = 9, settings.samplesPerBin = 8;
        const Progress progress;
        volume = buildVolume(empty.transport(), *empty.estimator("path"), settings, {}, progress).value();
        lighting = FurnitureLighting::create(object, volume, empty.raycaster.get()).value();
    }
};
Stage& stage() {
    static Stage s;
    return s;
}

Pose movedTo(double x, double y) { return {{x - 3, y - 2, 0}, 0}; }

TEST(MovableObject, KnowsItsWorkingSurface) {
    const auto& o = stage().object;
    EXPECT_NEAR(o.workingSurfaceM2, 1.2 * 0.6, 1e-5);  // the board's top, not the feet's
    for (std::size_t v = 0; v < o.positions.size(); ++v)
        if (o.workingAreaM2[v] > 0) {
            EXPECT_NEAR(o.positions[v].z, 0.75F, 1e-5F);
        }
    for (const auto& t : o.triangles)
        for (int i = 0; i < 3; ++i) EXPECT_LE((o.positions[t[i]] - o.positions[t[(i + 1) % 3]]).length(), 0.1F + 1e-5F);
}

TEST(MovableObject, HasLevelsThatStandForAllOfIt) {
    const auto& o = stage().object;
    ASSERT_GE(o.levels.size(), 3U);
    for (std::size_t i = 1; i < o.levels.size(); ++i) {
        EXPECT_LT(o.levels[i].shown.size(), o.levels[i - 1].shown.size());
        for (std::size_t v = 0; v < o.positions.size(); ++v) {
            const auto by = o.levels[i].shown[o.levels[i].standsFor[v]];
            EXPECT_GT(dot(o.normals[v], o.normals[by]), 0.9F);  // all normals are along axes
        }
    }
}

// Invariant: what is not finite is refused by name and number, and an unknown name lists what is movable.
TEST(MovableObject, RefusesWhatItCannotLight) {
    auto scene = stage().whole;
    const auto missing = makeMovableObject(scene, "desk");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message, HasSubstr("movable are \"table\""));
    scene.meshes.back().positions[5].y = std::numeric_limits<float>::quiet_NaN();
    const auto bad = makeMovableObject(scene, "table");
    ASSERT_FALSE(bad);
    EXPECT_THAT(bad.error().message, HasSubstr("vertex 5 of \"table\" is not finite"));
}

TEST(MovableObject, MovesAsItsPoseSays) {
    const auto& o = stage().object;
    const auto place = o.placed({{1, 0, 0}, 90});
    const Vec3 p = place.point({0.6F, 0, 0.75F});
    EXPECT_NEAR(p.x, 4, 1e-6F);
    EXPECT_NEAR(p.y, 2.6F, 1e-6F);
    EXPECT_NEAR(p.z, 0.75F, 1e-6F);
    const Scene turned = withObjectAt(stage().empty.scene, stage().whole, "table", o, {{1, 0, 0}, 90});
    Box3 box;
    for (const auto& q : turned.meshes.back().positions) box.extendBy(q);
    EXPECT_NEAR(box.min.x, 3.7F, 1e-5F);
    EXPECT_NEAR(box.max.y, 2.6F, 1e-5F);
}

// Invariant: in a uniform field of radiance L each vertex takes pi L times the part of its hemisphere that the object leaves
// open (and, the object being black, nothing else): an L of two walls that meet leaves half of what a wall alone has at the edge.
TEST(FurnitureLighting, UniformFieldTimesTheOpenPart) {
    IrradianceVolume v;
    v.settings.side = 9;
    v.lattice = Lattice::create({{0, 0, 0}, {6, 4, 3}}, {1, 1, 1}, 2, 1).value();
    v.quality.resize(8), v.sources.resize(8), v.occupied.resize(1);
    for (auto& q : v.quality) q.samples = 2;
    v.direct.assign(8 * v.binCount(), Rgb{}), v.indirect.assign(8 * v.binCount(), Rgb(10));
    auto scene = furnished();
    for (auto& m : scene.materials) m.reflectance = Rgb(0.0F);
    const auto object = makeMovableObject(scene, "table").value();
    const auto lighting = FurnitureLighting::create(object, v, nullptr).value();
    lighting->update({{0.3, 0.2, 0}, 30});
    const auto surface = lighting->workingSurface();
    EXPECT_NEAR(surface.mean.value, 10 * kPiD, 10 * kPiD * 1e-4);
    EXPECT_NEAR(surface.minimum.value, surface.maximum.value, 1e-2);
    for (std::size_t i = 0; i < object.positions.size(); ++i) {
        const auto* row = lighting->selfShade().row(static_cast<std::uint32_t>(i));
        EXPECT_NEAR(lighting->lux()[i].g, 10 * kPiD * (row == nullptr ? 1 : 1 - row->hiddenPart), 10 * kPiD * 1e-3);
    }
    EXPECT_GT(lighting->selfShade().shadedVertices(), object.positions.size() / 10);
    EXPECT_LT(lighting->selfShade().shadedVertices(), object.positions.size());
}

// The volume's answers at vertices against `path` in the room that holds the table: under the lamp, off it and in the dark
// corner. On the working surface nothing is hidden: there the stated interval, and 5 % for what the table changes in the
// room's light (its 3 % of the floor area at reflectances of 0.4 and 0.5), hold. Over all vertices the feet, which stand on
// the floor, and the inner sides, which see the table's own shadow, are too bright: first order knows no shadow on the room.
// Measured 0.15 to 0.29 of the mean; the bound says that it stays in proportion.
TEST(FurnitureLighting, AgreesWithTheFullSolution) {
    auto& s = stage();
    const Progress progress;
    for (const auto& [x, y] : {std::pair{1.5, 2.0}, {3.0, 2.0}, {5.2, 3.4}}) {
        const auto pose = movedTo(x, y);
        s.lighting->update(pose);
        const Lit with(withObjectAt(s.empty.scene, s.whole, "table", s.object, pose));
        const auto estimator = with.estimator("path");
        const auto lit = LitScene::create(with.scene).value();
        const auto full = solveVertices(lit, *estimator, *s.lighting, 150, 512, 3, progress);
        EXPECT_LT(full.relativeRms, 0.4) << x;
        int out = 0, count = 0;
        for (std::size_t i = 0; i < full.vertices.size(); ++i) {
            const auto v = full.vertices[i];
            if (!(s.object.workingAreaM2[v] > 0)) continue;
            const double off = std::abs(luminance(s.lighting->lux()[v]) - full.lux[i].value);
            ++count, out += off > std::hypot(double{s.lighting->halfWidths()[v]}, full.lux[i].ci95) + 0.05 * full.lux[i].value ? 1 : 0;
        }
        EXPECT_LE(out, count / 10) << x;  // of 95 % intervals that are wider than needed: 10 % is far above what chance leaves
        RecordProperty("rms", std::to_string(full.relativeRms));
    }
}

TEST(FurnitureLighting, WarnsWhereThereIsTooLittleOrTooMuch) {
    auto& s = stage();
    s.lighting->update(movedTo(1.5, 2));
    const auto bright = s.lighting->workingSurface();
    s.lighting->update(movedTo(5.3, 3.6));
    const auto dark = s.lighting->workingSurface();
    ASSERT_GT(bright.mean.low(), dark.mean.high());
    const double between = (bright.mean.low() + dark.mean.high()) / 2;
    EXPECT_EQ(s.lighting->workingSurface({between, {}}).verdict, FurnitureVerdict::Under);
    EXPECT_EQ(s.lighting->workingSurface({dark.mean.value, {}}).verdict, FurnitureVerdict::Undecided);
    EXPECT_EQ(s.lighting->workingSurface({{}, dark.maximum.low() / 2}).verdict, FurnitureVerdict::Over);
    s.lighting->update(movedTo(1.5, 2));
    EXPECT_EQ(s.lighting->workingSurface({between, {}}).verdict, FurnitureVerdict::Met);
    EXPECT_EQ(s.lighting->workingSurface().verdict, FurnitureVerdict::None);
}

// Bug: of one sample a bin the variance is infinite, and 0 times infinite along the axes that a level surface does not face made its
// interval not a number, which was held for met. Invariant: what is not known is undecided.
TEST(FurnitureLighting, OneSampleABinDecidesNothing) {
    const auto& s = stage();
    VolumeSettings settings;
    settings.firstLevel = {4, 4, 3}, settings.secondLevel = 0, settings.side = 5, settings.samplesPerBin = 1;
    const auto volume = buildVolume(s.empty.transport(), *s.empty.estimator("path"), settings, {}, Progress()).value();
    const auto lighting = FurnitureLighting::create(s.object, volume, s.empty.raycaster.get()).value();
    lighting->update(movedTo(1.5, 2));
    EXPECT_EQ(lighting->workingSurface({1.0, {}}).verdict, FurnitureVerdict::Undecided);
    EXPECT_EQ(lighting->workingSurface({{}, 1e6}).verdict, FurnitureVerdict::Undecided);
}

// Invariant: a pose has one answer, whatever was asked before; coarser levels answer alike.
TEST(FurnitureLighting, SamePoseSameBits) {
    auto& s = stage();
    s.lighting->update({{0.4, -0.3, 0}, 20});
    const std::vector<Rgb> first(s.lighting->lux().begin(), s.lighting->lux().end());
    const double mean = s.lighting->workingSurface().mean.value;
    s.lighting->update(movedTo(1, 1), 2);
    s.lighting->update({{0.4, -0.3, 0}, 20}, 1);
    EXPECT_NEAR(s.lighting->workingSurface().mean.value, mean, 0.05 * mean);
    s.lighting->update({{0.4, -0.3, 0}, 20});
    EXPECT_EQ(std::memcmp(first.data(), s.lighting->lux().data(), first.size() * sizeof(Rgb)), 0);
}

TEST(FurnitureLighting, KnowsNothingInsideAWall) {
    auto& s = stage();
    s.lighting->update(movedTo(-2, 2));  // outside the room
    const auto surface = s.lighting->workingSurface({100, {}});
    EXPECT_GT(surface.unknownPart, 0.9);
    EXPECT_NE(surface.verdict, FurnitureVerdict::Met);
}

// First order against both rooms solved. Left out is light that goes from the table to the room and back again: of what
// the table takes or returns, at most the room's mean reflectance 0.5 comes back; so half the gross figures, and the noise.
TEST(TakenLight, EstimateAgreesWithTheExactDifference) {
    auto& s = stage();
    Project project;
    project.scene = s.empty.scene;
    CalculationGrid floor, plane;
    floor.name = "under", floor.origin = {2.5, 1.8, 0.05}, floor.u = {1, 0, 0}, floor.v = {0, 0.4, 0}, floor.counts = {4, 2};
    plane.name = "beside", plane.origin = {3.8, 0.5, 0.75}, plane.u = {1.5, 0, 0}, plane.v = {0, 3, 0}, plane.counts = {3, 4};
    project.grids = {floor, plane};
    s.lighting->update({});
    const auto lit = LitScene::create(project.scene).value();
    const auto estimate = estimateTaken(project, lit, *s.lighting).value();
    SolveSettings settings;
    settings.samples = 2048;
    const Progress progress;
    const auto exact = solveTaken(project, lit, withObjectAt(project.scene, s.whole, "table", s.object, {}), settings, progress).value();
    for (std::size_t g = 0; g < 2; ++g) {
        const auto& m = estimate[g].mean;
        const auto& e = exact.grids[g];
        EXPECT_NEAR(m.taken(), e.takenMean.value, 1.5 * e.takenMean.ci95 + 0.5 * (m.indirect + m.returned) + 0.05 * m.direct + 0.02 * m.empty) << estimate[g].name;
        EXPECT_NEAR(m.empty, e.emptyMean.interval.value, 0.1 * m.empty);
    }
    EXPECT_GT(estimate[0].mean.taken(), 0.5 * estimate[0].mean.empty);  // the board hides the lamp and most of the room
    EXPECT_LT(std::abs(estimate[1].mean.taken()), 0.1 * estimate[1].mean.empty);
}

TEST(TakenLight, DoesNotDependOnTheNumberOfThreads) {
    auto& s = stage();
    Project project;
    project.scene = s.empty.scene;
    CalculationGrid grid;
    grid.name = "g", grid.origin = {1, 1, 0.5}, grid.u = {4, 0, 0}, grid.v = {0, 2, 0}, grid.counts = {6, 3};
    project.grids = {grid};
    s.lighting->update({});
    const auto lit = LitScene::create(project.scene).value();
    const auto all = estimateTaken(project, lit, *s.lighting).value();
    const ThreadLimit one(1);
    const auto alone = estimateTaken(project, lit, *s.lighting).value();
    EXPECT_EQ(all[0].mean.taken(), alone[0].mean.taken());
}

}  // namespace
}  // namespace luxdeck::test

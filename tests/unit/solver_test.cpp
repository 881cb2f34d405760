#include "analysis/grids/solver.h"

#include "engine/core/parallel.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace luxdeck::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double kUnknown = std::numeric_limits<double>::infinity();

Project projectOf(Scene scene, double limit = 1) {
    Project project;
    project.info.name = "Test";
    project.scene = std::move(scene);
    CalculationGrid grid;
    grid.name = "Desk", grid.where = "project.toml:3";
    grid.origin = {0.5, 0.5, 0.8}, grid.u = {3, 0, 0}, grid.v = {0, 2.5, 0}, grid.counts = {{4, 3}};
    Requirement r;
    r.meanLux = limit, r.uniformity = 0.1;
    grid.requirements = {r};
    CalculationGrid faces = grid;
    faces.name = "Faces", faces.kind = GridKind::Cylindrical, faces.counts = {{2, 2}}, faces.requirements.clear();
    project.grids = {grid, faces};
    return project;
}

Result<SolveResult> trySolve(const Project& project, const SolveSettings& settings, const Progress& progress) {
    auto lit = LitScene::create(project.scene);
    if (!lit) return lit.error();
    return solve(project, *lit, settings, progress);
}

SolveResult solved(const Project& project, const SolveSettings& settings) {
    const Progress progress;
    auto result = trySolve(project, settings, progress);
    EXPECT_TRUE(result) << result.error().text();
    return result ? *std::move(result) : SolveResult{};
}

SolveSettings samples(std::uint32_t count) {
    SolveSettings s;
    s.samples = count;
    return s;
}

/// All numbers of a result that must not depend on threads, in one row.
std::vector<double> numbersOf(const SolveResult& result) {
    std::vector<double> out;
    const auto add = [&](const Interval& i) { out.push_back(i.value), out.push_back(i.ci95); };
    for (const auto& grid : result.grids) {
        add(grid.mean.interval), add(grid.minimum.interval), add(grid.uniformity.interval);
        for (const auto& p : grid.points) add(p.total), add(p.direct), add(p.indirect);
    }
    out.push_back(static_cast<double>(result.rays));
    out.push_back(result.truncatedFraction);
    return out;
}

TEST(Solve, IsTheSameToTheBitAtAnyNumberOfThreads) {
    const auto project = projectOf(furnishedRoom());
    SolveSettings toTarget;
    toTarget.targetError = 0.1;
    for (const auto& settings : {samples(2000), toTarget}) {
        std::vector<double> first;
        for (const int threads : {1, 2, 7}) {
            const ThreadLimit limit(threads);
            const auto result = solved(project, settings);
            EXPECT_EQ(result.threads, threads);
            if (first.empty()) first = numbersOf(result);
            EXPECT_EQ(numbersOf(result), first) << threads << " threads";
        }
    }
}

// Points and rays in one run, as `sense` asks for them.
TEST(SamplingRun, IsTheSameToTheBitAtAnyNumberOfThreads) {
    const Lit lit(furnishedRoom());
    const auto estimator = lit.estimator("path");
    std::vector<double> first;
    for (const int threads : {1, 2, 7}) {
        const ThreadLimit limit(threads);
        std::vector<Target> targets(5);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            targets[i].stream = i;
            targets[i].sensor = facing({1 + 0.5F * static_cast<float>(i), 2, 0.8F}, {0, 0, 1});
            targets[i].radiance = i % 2 == 1;
            targets[i].ray = {{1, 1, 1.5F}, 0, Vec3(1, 0.1F * static_cast<float>(i), -0.1F).normalized(), kInfinity};
        }
        SamplingRun run(*estimator, lit.scene.weights, targets, 9);
        const Progress progress;
        ProgressState state;
        EXPECT_TRUE(run.round({100, 0, 70, 8, 300}, progress, state, std::nullopt));
        EXPECT_TRUE(run.round({8, 64, 0, 65, 1}, progress, state, std::nullopt));
        std::vector<double> sums;
        for (const auto& s : run.sums()) {
            sums.insert(sums.end(), s.direct.begin(), s.direct.end());
            sums.insert(sums.end(), s.indirect.begin(), s.indirect.end());
            sums.insert(sums.end(), s.rgb.begin(), s.rgb.end());
            sums.push_back(s.perReplicate);
        }
        if (first.empty()) first = sums;
        EXPECT_EQ(sums, first) << threads << " threads";
    }
}

TEST(Solve, PartsMakeTheWholeExactly) {
    const auto result = solved(projectOf(furnishedRoom()), samples(1000));
    ASSERT_EQ(result.grids.size(), 2U);
    for (const auto& grid : result.grids)
        for (const auto& p : grid.points) {
            EXPECT_EQ(p.total.value, p.direct.value + p.indirect.value);
            EXPECT_GT(p.direct.value, 0);
            EXPECT_GT(p.indirect.value, 0);
            EXPECT_EQ(p.samples, 1024U) << "1000, made whole for 32 replicates";
        }
    EXPECT_EQ(result.samples, 16U * 1024);
}

TEST(Solve, ReachesItsTargetAndPredictsIt) {
    SolveSettings settings;
    settings.targetError = 0.05;
    const auto result = solved(projectOf(cubeRoom(0.5F, 10000)), settings);
    EXPECT_TRUE(result.complete && result.targetReached);
    EXPECT_GT(result.predictedSeconds, 0);
    EXPECT_EQ(result.targetError, 0.05);
    for (const auto& grid : result.grids) {
        EXPECT_LE(grid.mean.interval.relative(), 0.05);
        EXPECT_LE(grid.uniformity.interval.relative(), 0.05);
        for (const auto& p : grid.points) EXPECT_LE(p.total.relative(), 0.05);
    }
    EXPECT_EQ(result.grids[0].mean.verdict, Verdict::Met);
    EXPECT_EQ(result.grids[1].mean.verdict, Verdict::None);
    ASSERT_FALSE(result.trace.empty());
    EXPECT_LE(result.trace.back().relativeError, 0.05);
    for (std::size_t i = 1; i < result.trace.size(); ++i) {
        EXPECT_GE(result.trace[i].seconds, result.trace[i - 1].seconds);
        EXPECT_GT(result.trace[i].samples, result.trace[i - 1].samples);
    }
    EXPECT_EQ(result.rejectedSamples, 0U);
}

TEST(Solve, TheTruthLiesInItsInterval) {
    // An isotropic lamp in the middle of a black cube: E = I cos / d^2 at each point.
    const auto project = projectOf(cubeRoom(0, 10000));
    const auto result = solved(project, samples(64));
    for (const auto& p : result.grids[0].points) {
        const Vec3d to = Vec3d(2, 2, 2) - p.position;
        const double expected = 10000 / (4 * kPiD) * to.z / std::pow(to.length(), 3);
        EXPECT_NEAR(p.total.value, expected, p.total.ci95 + 1e-5 * expected);  // no noise here: float rounding
        EXPECT_EQ(p.indirect.value, 0);
    }
}

TEST(Solve, CancelledBeforeItsFirstRoundItKnowsNothing) {
    Progress progress;
    progress.cancel();
    for (const auto& settings : {SolveSettings{}, samples(100)}) {
        const auto result = trySolve(projectOf(cubeRoom(0.5F, 1000)), settings, progress);
        ASSERT_TRUE(result) << result.error().text();
        EXPECT_FALSE(result->complete);
        for (const auto& grid : result->grids) {
            EXPECT_EQ(grid.mean.interval.ci95, kUnknown);
            EXPECT_EQ(grid.minimum.interval.ci95, kUnknown);
            EXPECT_NE(grid.mean.verdict, Verdict::Met);
            EXPECT_NE(grid.mean.verdict, Verdict::NotMet) << "nothing is known, so nothing is judged";
            for (const auto& p : grid.points) {
                EXPECT_EQ(p.samples, 0U);
                EXPECT_EQ(p.total.ci95, kUnknown);
            }
        }
    }
}

TEST(Solve, EndsAtItsDeadlineWithWhatItHas) {
    SolveSettings settings;
    settings.targetError = 1e-7;
    settings.timeSeconds = 0.3;
    const auto result = solved(projectOf(furnishedRoom()), settings);
    EXPECT_TRUE(result.complete) << "the time asked for was used: not an interruption";
    EXPECT_FALSE(result.targetReached);
    EXPECT_GT(result.predictedSeconds, 0.3);
    SolveSettings none;
    none.targetError = 0;
    none.timeSeconds = 0.1;
    EXPECT_TRUE(solved(projectOf(furnishedRoom()), none).targetReached) << "no target was asked for";
}

// Nothing to hit, or nothing that gives light: exactly 0 lx, known without doubt.
TEST(Solve, DarknessIsExact) {
    SceneBuilder room, off;
    room.box({0, 0, 0}, {4, 4, 4}, room.matte(0.5F), true);
    off.isotropic({2, 2, 2}, 0);
    SolveSettings settings;
    settings.targetError = 0.01;
    for (const Scene& scene : {room.build(), off.build(), Scene{}}) {
        const auto result = solved(projectOf(scene, 500), settings);
        EXPECT_TRUE(result.complete && result.targetReached);
        for (const auto& p : result.grids[0].points) {
            EXPECT_EQ(p.total.value, 0);
            EXPECT_EQ(p.total.ci95, 0);
        }
        EXPECT_EQ(result.grids[0].mean.interval.ci95, 0);
        EXPECT_EQ(result.grids[0].mean.verdict, Verdict::NotMet);
    }
}

TEST(Solve, BadSensorsAreCountedNotAveraged) {
    auto project = projectOf(cubeRoom(0.5F, 1000));
    CalculationGrid bad;
    bad.name = "bad";
    bad.points = {{{{std::nan(""), 1, 1}, {0, 0, 1}}}, {{{1, 1, 1}, {0, 0, 1}}}};
    project.grids = {bad};
    const auto result = solved(project, samples(320));
    EXPECT_EQ(result.rejectedSamples, 320U);
    EXPECT_TRUE(std::isinf(result.grids[0].points[0].total.ci95)) << "withheld";
    EXPECT_TRUE(std::isfinite(result.grids[0].points[1].total.ci95));
    EXPECT_GT(result.grids[0].points[1].total.value, 0);
    EXPECT_EQ(result.withheldPoints, 1U);
    EXPECT_FALSE(result.complete);
    EXPECT_TRUE(std::isinf(result.grids[0].mean.interval.ci95));
    EXPECT_THAT(result.warnings, Contains(HasSubstr("320 of 640 samples")));
    EXPECT_THAT(result.warnings, Contains(HasSubstr("1 of 2 points are withheld")));
}

TEST(Solve, TellsWhichPointsLieInsideASolid) {
    SceneBuilder b;
    b.box({0, 0, 0}, {4, 4, 4}, b.matte(0.5F), true, 2).box({0.4F, 0.4F, 0.2F}, {1.5F, 1.5F, 1.5F}, b.matte(0.5F), false);
    b.isotropic({2, 2, 3}, 1000);
    const auto result = solved(projectOf(b.build()), samples(64));
    EXPECT_TRUE(result.grids[0].points[0].insideSolid);
    EXPECT_FALSE(result.grids[0].points[11].insideSolid);
    ASSERT_FALSE(result.warnings.empty());
    EXPECT_THAT(result.warnings[0], HasSubstr("grid \"Desk\": "));
}

TEST(Solve, RefusesWhatItCannotDo) {
    const Progress progress;
    auto project = projectOf(cubeRoom(0.5F, 1000));
    SolveSettings settings;
    settings.targetError = 0;
    EXPECT_THAT(trySolve(project, settings, progress).error().message, HasSubstr("never end"));
    settings = {};
    settings.algorithm = "magic";
    EXPECT_THAT(trySolve(project, settings, progress).error().message, HasSubstr("no algorithm \"magic\", expected one of: path"));
    settings.algorithm = "ambient", settings.algorithmSettings.ambientLux = -1;
    EXPECT_THAT(trySolve(project, settings, progress).error().message, HasSubstr("ambient is -1 lx"));
    project.grids[0].borderM = 9;
    EXPECT_EQ(trySolve(project, {}, progress).error().where, "project.toml:3");
    project.grids.clear();
    EXPECT_THAT(trySolve(project, {}, progress).error().message, HasSubstr("no calculation grid"));
}

}  // namespace
}  // namespace luxdeck::test

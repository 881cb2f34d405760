// Light kept apart by luminaire: the parts make the whole, and any dimming of them is what a solve of its own finds.
#include "analysis/grids/layers.h"

#include "analysis/grids/solver.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::test {
namespace {

/// A furnished room with three luminaires "A", "A" and "B", and one point grid.
Project room(double dimmingA = 1, double dimmingB = 0.8) {
    Project project;
    project.scene = furnishedRoom();
    for (std::size_t i = 0; i < project.scene.luminaires.size(); ++i) {
        auto& l = project.scene.luminaires[i];
        l.name = std::string(i < 2 ? "A" : "B");
        l.dimming = i < 2 ? dimmingA : dimmingB;
    }
    project.scene.hash = sceneHash(project.scene);
    CalculationGrid grid;
    grid.name = "plane", grid.origin = {0.5, 0.5, 0.85}, grid.u = {5, 0, 0}, grid.v = {0, 3, 0};
    grid.counts = {{4, 3}};
    project.grids.push_back(grid);
    return project;
}

SolveResult solved(const Project& project, bool byLuminaire, std::uint64_t seed = 1, std::uint32_t samples = 4096) {
    const auto lit = LitScene::create(project.scene);
    SolveSettings settings;
    settings.seed = seed, settings.samples = samples, settings.byLuminaire = byLuminaire;
    auto result = solve(project, *lit, settings, Progress{});
    EXPECT_TRUE(result) << result.error().text();
    return *std::move(result);
}

// The same paths: a sample's float sums of up to some hundred contributions are off by 1e-5 at most.
TEST(Layers, AtTheDimmingsAsSolvedTheyAreTheSolve) {
    const auto project = room();
    const auto plain = solved(project, false), split = solved(project, true);
    ASSERT_TRUE(split.layers);
    EXPECT_FALSE(plain.layers);
    const auto again = recombine(project, *split.layers, {});
    ASSERT_TRUE(again) << again.error().text();
    for (std::size_t i = 0; i < plain.grids[0].points.size(); ++i) {
        const auto &a = plain.grids[0].points[i], &b = split.grids[0].points[i], &c = again->grids[0].points[i];
        EXPECT_EQ(a.total.value, b.total.value) << "keeping layers changes no bit";
        EXPECT_EQ(a.total.ci95, b.total.ci95);
        EXPECT_NEAR(c.total.value, a.total.value, 1e-5 * a.total.value);
        EXPECT_NEAR(c.direct.value, a.direct.value, 1e-5 * a.total.value);
        EXPECT_NEAR(c.total.ci95, a.total.ci95, 1e-4 * a.total.value);
        double sum = 0;
        for (std::size_t layer = 0; layer < split.layers->layers.size(); ++layer) sum += split.layers->value(i, layer).value;
        EXPECT_NEAR(sum, a.total.value, 1e-5 * a.total.value);
    }
    EXPECT_NEAR(again->grids[0].mean.interval.value, plain.grids[0].mean.interval.value, 1e-5 * plain.grids[0].mean.interval.value);
}

// Twelve points and Ēm: 2 combined 95 % half-widths are 4 standard errors, false alarm below 1e-3; with this seed none.
TEST(Layers, AnotherDimmingIsWhatASolveOfItsOwnFinds) {
    const auto layers = solved(room(), true);
    const auto dimmed = recombine(room(), *layers.layers, {{"A", 0.25}, {"B", 1.0}});
    ASSERT_TRUE(dimmed) << dimmed.error().text();
    const auto own = solved(room(0.25, 1.0), false, 7);
    for (std::size_t i = 0; i < own.grids[0].points.size(); ++i) {
        const auto &a = dimmed->grids[0].points[i].total, &b = own.grids[0].points[i].total;
        EXPECT_NEAR(a.value, b.value, 2 * std::hypot(a.ci95, b.ci95)) << "point " << i;
        EXPECT_LE(a.ci95, 0.2 * a.value) << "a useful test; 0 inside furniture";
    }
    const auto &a = dimmed->grids[0].mean.interval, &b = own.grids[0].mean.interval;
    EXPECT_NEAR(a.value, b.value, 2 * std::hypot(a.ci95, b.ci95));
}

TEST(Layers, OffIsDarkAndNamesMayEndInAStar) {
    const auto project = room();
    const auto layers = solved(project, true, 1, 256);
    const auto off = recombine(project, *layers.layers, {{"A*", 0.0}, {"B", 0.0}});
    ASSERT_TRUE(off);
    for (const auto& point : off->grids[0].points) EXPECT_EQ(point.total.value, 0);
}

TEST(Layers, WhatCannotBeIsRefused) {
    const auto project = room();
    const auto layers = solved(project, true, 1, 64);
    const auto text = [&](const std::map<std::string, double>& dimmings) { return recombine(project, *layers.layers, dimmings).error().text(); };
    EXPECT_NE(text({{"C", 0.5}}).find("no layer \"C\""), std::string::npos);
    EXPECT_NE(text({{"A", 1.5}}).find("dimming of \"A\" is 1.5, expected 0 .. 1"), std::string::npos);
    EXPECT_NE(text({{"A", NAN}}).find("expected 0 .. 1"), std::string::npos);
    EXPECT_NE(recombine(room(0.5), *layers.layers, {}).error().text().find("solve again"), std::string::npos);
    const auto lit = LitScene::create(project.scene);
    SolveSettings settings;
    settings.algorithm = "ambient", settings.samples = 64, settings.byLuminaire = true;
    EXPECT_NE(solve(project, *lit, settings, Progress{}).error().text().find("path or direct"), std::string::npos);
}

// Nine digits: 5e-10 of each mean.
TEST(Layers, TheFileKeepsThem) {
    const auto project = room();
    const auto layers = solved(project, true, 1, 256);
    const auto text = layersJson(*layers.layers);
    const auto read = readLayersJson(text, "layers.json");
    ASSERT_TRUE(read) << read.error().text();
    const auto before = recombine(project, *layers.layers, {{"A", 0.5}}), after = recombine(project, *read, {{"A", 0.5}});
    ASSERT_TRUE(after) << after.error().text();
    for (std::size_t i = 0; i < before->grids[0].points.size(); ++i) {
        const auto &a = before->grids[0].points[i].total, &b = after->grids[0].points[i].total;
        EXPECT_NEAR(a.value, b.value, 1e-9 * a.value);
        EXPECT_NEAR(a.ci95, b.ci95, 1e-8 * a.value);
    }
    EXPECT_LT(text.size(), project.grids[0].counts->at(0) * project.grids[0].counts->at(1) * 2 * 900.0) << "two layers are lit";
    for (const std::string& bad : {std::string("{}"), std::string("["), text.substr(0, text.size() / 2), std::string("{\"schema\":\"other\"}")})
        EXPECT_NE(readLayersJson(bad, "layers.json").error().text().find("layers.json"), std::string::npos);
}

}  // namespace
}  // namespace luxdeck::test

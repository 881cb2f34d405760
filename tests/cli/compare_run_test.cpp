// What a comparison says of itself while it runs, and what an interruption leaves.
#include "analysis/compare/compare.h"
#include "analysis/compare/compare_output.h"
#include "engine/algorithms/lit_project.h"
#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

class CompareRun : public ::testing::Test {
protected:
    void SetUp() override {
        scratch.writeRoom();
        auto made = loadLit(std::vector<std::filesystem::path>{scratch.path("project.toml")});
        ASSERT_TRUE(made) << made.error().text();
        lit = *std::move(made);
        settings.algorithms = {"direct", "path"};
        settings.samples = 64, settings.rungs = 2, settings.repetitions = 3;
        settings.referenceError = 0.05, settings.pictureReferenceError = 0.5, settings.pictureHeight = 12;
        settings.views = {lit->project.views.front().name};
    }

    Scratch scratch;
    std::unique_ptr<LitProject> lit;
    CompareSettings settings;
};

TEST_F(CompareRun, TellsOfEveryReferenceAndRunWithItsValues) {
    std::size_t references = 0, runs = 0;
    std::vector<ErrorMap> last;
    const auto result = compare(lit->project, lit->lit, settings, Progress(), [&](const Comparison& soFar, const ComparedValues& values) {
        EXPECT_FALSE(soFar.complete);
        ++(values.algorithm.empty() ? references : runs);
        EXPECT_EQ(soFar.reference.size(), references);
        EXPECT_EQ(soFar.runs.size(), runs);
        const auto& described = soFar.reference[values.subject == "grids" ? 0 : 1];
        EXPECT_EQ(values.values.size(), described.values);
        EXPECT_EQ(values.columns, described.width);
        if (values.algorithm.empty()) return;
        EXPECT_EQ(soFar.runs.back().algorithm, values.algorithm);
        EXPECT_EQ(soFar.runs.back().rung, values.rung);
        // The mean of the map's errors is near the signed mean that is told of the run: of all its repetitions, by the same scale.
        double sum = 0, count = 0;
        for (const auto& map : values.maps)
            for (const double e : map.errors) sum += e, ++count;
        EXPECT_EQ(count, static_cast<double>(described.values));
        EXPECT_NEAR(sum / count, soFar.runs.back().meanError, 1e-9 + 1e-6 * std::abs(soFar.runs.back().meanError));
        if (values.rung == 1 && values.algorithm == "path") last.insert(last.end(), values.maps.begin(), values.maps.end());
    });
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->complete);
    EXPECT_EQ(references, 2U);
    EXPECT_EQ(runs, 2U * 2 * 2);
    // The largest runs' maps are those of the result.
    std::vector<ErrorMap> kept;
    for (const auto& map : result->maps)
        if (map.algorithm == "path") kept.push_back(map);
    ASSERT_EQ(kept.size(), last.size());
    for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].errors, last[i].errors);
}

TEST_F(CompareRun, WatchingChangesNothing) {
    const auto plain = compare(lit->project, lit->lit, settings, Progress());
    const auto watched = compare(lit->project, lit->lit, settings, Progress(), [](const Comparison&, const ComparedValues&) {});
    ASSERT_TRUE(plain && watched);
    EXPECT_EQ(errorsCsv(*plain), errorsCsv(*watched));
}

// Bug: stopped while the second subject's reference was in its first round, a comparison told "interrupted before there was a
// reference" and kept nothing. Invariant: what was finished is kept. The first subject's reference had been finished, and it
// would have been kept in its file too, for the next comparison.
TEST_F(CompareRun, StoppedInTheSecondReferenceItKeepsTheFirst) {
    Progress* stop = nullptr;
    const std::string second = "reference of " + settings.views.front();
    Progress progress([&](const ProgressState& state) {
        if (state.stage.rfind(second, 0) == 0) stop->cancel();
    });
    stop = &progress;
    settings.referenceFile = scratch.path("reference.json");
    const auto result = compare(lit->project, lit->lit, settings, progress);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_FALSE(result->complete);
    ASSERT_EQ(result->reference.size(), 1U);
    EXPECT_EQ(result->reference.front().subject, "grids");
    EXPECT_TRUE(scratch.has("reference.json"));
    const auto again = readCompareJson(compareJson(*result), "c");
    EXPECT_TRUE(again);
}

}  // namespace
}  // namespace luxdeck::test

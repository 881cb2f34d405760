// A comparison of a session: run after run, looked at, stopped, saved; and volumes by each algorithm.
#include "tests/gui/open_session.h"

#include "analysis/compare/compare_output.h"
#include "engine/core/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace luxdeck::gui {
namespace {

using test::OpenSession;
using test::OwnFolder;
using testing::HasSubstr;
using testing::IsEmpty;

class ComparingTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors();
        settings.algorithms = {"direct", "path"};
        settings.samples = 64, settings.rungs = 2, settings.repetitions = 3;
        settings.referenceError = 0.3, settings.pictureReferenceError = 0.9, settings.pictureHeight = 16;
        settings.views = {open.session.project()->project.views.front().name};
    }
    Comparing& comparing() { return open.session.comparing; }

    OwnFolder folder;
    OpenSession open;
    CompareSettings settings;
};

TEST_F(ComparingTest, CurvesFillInAndTheEndIsWhatTheCommandLineFinds) {
    std::size_t before = 0, steps = 0;
    open.session.observe([&](Change change) {
        if (change != Change::Comparison || !comparing().result() || comparing().result()->runs.size() <= before) return;
        before = comparing().result()->runs.size();
        ++steps;
    });
    comparing().start(settings);
    ASSERT_TRUE(open.untilIdle());
    ASSERT_NE(comparing().result(), nullptr) << open.errors();
    EXPECT_EQ(steps, 8U);  // one a run: 2 algorithms, 2 subjects, 2 rungs
    EXPECT_TRUE(comparing().result()->complete);
    EXPECT_TRUE(comparing().current());
    const auto& project = *open.session.project();
    const auto same = compare(project.project, project.lit, settings, Progress());
    ASSERT_TRUE(same);
    EXPECT_EQ(errorsCsv(*comparing().result()), errorsCsv(*same));
}

TEST_F(ComparingTest, ARunIsSeenBesideTheReferenceAndItsDifference) {
    comparing().start(settings);
    ASSERT_TRUE(open.untilIdle());
    comparing().look({settings.views.front(), "direct", 1});
    ASSERT_TRUE(open.untilIdle());
    ASSERT_EQ(comparing().pictures().size(), 3U) << open.errors();
    EXPECT_EQ(comparing().pictures()[2].map, tonemap::ColourMap::Balance);
    EXPECT_EQ(comparing().pictures()[2].unit, "%");
    EXPECT_EQ(comparing().pictures()[2].range.low, -comparing().pictures()[2].range.high);
    EXPECT_NE(comparing().pictures()[0].image.rgb, comparing().pictures()[1].image.rgb);
    comparing().look({"grids", "path", 0});
    ASSERT_TRUE(open.untilIdle());
    EXPECT_EQ(comparing().pictures().size(), 3 * open.session.project()->project.grids.size());
    comparing().look({"grids", "path", 9});  // no such run: what was seen stays
    EXPECT_EQ(comparing().looked().rung, 0);
}

TEST_F(ComparingTest, StoppedItKeepsItsRuns) {
    settings.samples.reset();
    settings.budgetSeconds = 600, settings.rungs = 12;
    settings.referenceError = 0.9;
    settings.views.clear();
    comparing().start(settings);
    ASSERT_TRUE(open.until([&] { return comparing().result() && comparing().result()->runs.size() >= 2; })) << open.errors();
    comparing().cancel();
    ASSERT_TRUE(open.untilIdle());
    EXPECT_FALSE(comparing().result()->complete);
    EXPECT_GE(comparing().result()->runs.size(), 2U);
}

TEST_F(ComparingTest, TheEstimateIsTheSumOfTheBudgets) {
    settings.samples.reset();
    settings.budgetSeconds = 2, settings.rungs = 3, settings.repetitions = 4;
    EXPECT_DOUBLE_EQ(comparing().expectedSeconds(settings), 2 * 2 * 4 * (2 + 1 + 0.5));
    settings.views.clear();
    EXPECT_DOUBLE_EQ(comparing().expectedSeconds(settings), 2 * 4 * (2 + 1 + 0.5));
}

TEST_F(ComparingTest, SavesWhatTheCommandLineWrites) {
    EXPECT_FALSE(comparing().save(folder.path()));
    comparing().start(settings);
    ASSERT_TRUE(open.untilIdle());
    ASSERT_TRUE(comparing().save(folder.path()));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), IsEmpty());
    const auto text = readFile(folder.path() / "compare.json");
    ASSERT_TRUE(text);
    EXPECT_TRUE(readCompareJson(*text, "compare.json"));
    for (const char* name : {"runs.csv", "errors.csv", "error-against-time-grids.svg", "errors-grids.png"}) EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
    ASSERT_TRUE(comparing().save(folder.path() / "none"));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), HasSubstr("none"));
}

TEST_F(ComparingTest, AVolumeByEachAlgorithmStandsBesideTheReference) {
    ASSERT_TRUE(open.session.edit("Coarse volume", [](const std::string& text) -> Result<std::string> {
        auto out = text;
        const std::string what = "first_level = [7, 7, 7]\nsecond_level = 3";
        return out.replace(out.find(what), what.size(), "first_level = [2, 2, 2]\nsecond_level = 2");
    }));
    ASSERT_TRUE(open.untilIdle());
    settings.views.clear();
    comparing().start(settings);
    ASSERT_TRUE(open.untilIdle());
    comparing().buildVolumes();
    ASSERT_TRUE(open.untilIdle());
    std::vector<std::string> names;
    for (const auto& volume : open.session.volumes.all()) names.push_back(volume.name);
    EXPECT_THAT(names, testing::UnorderedElementsAre("reference", "direct", "path")) << open.errors();
    EXPECT_EQ(comparing().result()->volumes.size(), 2U * 3);
}

TEST_F(ComparingTest, WhatCannotBeComparedIsSaid) {
    settings.views.clear();
    settings.grids = false;
    comparing().start(settings);
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), HasSubstr("neither a calculation grid nor a view"));
    EXPECT_EQ(comparing().result(), nullptr);
}

}  // namespace
}  // namespace luxdeck::gui

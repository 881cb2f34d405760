// The report of a session: made of what was solved, previewed, exported as the command line writes it.
#include "tests/gui/open_session.h"

#include "engine/core/file.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace luxdeck::gui {
namespace {

using test::OpenSession;
using test::OwnFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::ordered_json;

class ReportingTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(open.open(file)) << open.errors();
        choice.solve.algorithm = "path";
        choice.solve.samples = 64;
        choice.solve.targetError = 0.02;
        choice.viewSeconds = 0.1;
    }
    Reporting& reporting() { return open.session.reporting; }
    bool make() {
        reporting().make(choice);
        return open.untilIdle() && reporting().pages() != nullptr;
    }
    std::size_t pagesWith(void (*change)(ReportChoice&)) {
        auto other = choice;
        change(other);
        EXPECT_TRUE(reporting().isQuick(other));
        reporting().make(other);
        EXPECT_TRUE(open.untilIdle());
        return reporting().pages()->count();
    }

    OwnFolder folder;
    std::filesystem::path file = folder.sample("office");
    OpenSession open;
    ReportChoice choice;
};

/// What depends on the clock: how long things took.
void removeSeconds(Json& json) {
    if (json.is_object())
        for (const char* key : {"seconds", "setupSeconds", "predictedSeconds", "created"}) json.erase(key);
    for (auto& each : json)
        if (each.is_structured()) removeSeconds(each);
}

TEST_F(ReportingTest, HoldsTheValuesOfTheCommandLine) {
    // Views are rendered by the clock, so that both are without.
    ASSERT_TRUE(open.session.edit("No views", [](const std::string& text) -> Result<std::string> {
        auto out = text;
        for (auto at = out.find("[[view]]"); at != std::string::npos; at = out.find("[[view]]", at)) {
            const auto next = out.find("\n[", at);
            out.erase(at, next == std::string::npos ? next : next + 1 - at);
        }
        return out;
    }));
    ASSERT_TRUE(open.untilIdle());
    ASSERT_TRUE(open.session.save());
    ASSERT_TRUE(make()) << open.errors();
    ASSERT_TRUE(reporting().save(folder.path() / "gui.pdf"));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), IsEmpty());
    luxdeck::test::ProcessSettings command;
    command.arguments = {LUXDECK_PROGRAM, "report", file.string(), "-o", (folder.path() / "cli.pdf").string(), "--samples", "64"};
    const auto ran = luxdeck::test::runProcess(command);
    const auto gui = readFile(folder.path() / "gui.json"), cli = readFile(folder.path() / "cli.json");
    ASSERT_TRUE(gui && cli) << ran.err;
    auto a = Json::parse(*gui), b = Json::parse(*cli);
    removeSeconds(a), removeSeconds(b);
    EXPECT_EQ(a, b);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "gui.pdf"));
}

TEST_F(ReportingTest, TakesWhatIsSolvedAlready) {
    open.session.solving.start(choice.solve);
    ASSERT_TRUE(open.untilIdle());
    choice.solve.samples = 8;
    ASSERT_TRUE(make()) << open.errors();
    EXPECT_EQ(reporting().pages()->contents().solve.samples, open.session.solving.result()->samples);
}

TEST_F(ReportingTest, WhatIsLeftOutIsGoneAndComesBackWithoutRendering) {
    choice.views = {open.session.project()->project.views.front().name};
    EXPECT_FALSE(reporting().isQuick(choice));
    ASSERT_TRUE(make()) << open.errors();
    const auto all = reporting().pages()->count();
    const auto rendered = reporting().pages()->contents().views.front().png;
    EXPECT_EQ(reporting().thumbnails().size(), all);
    EXPECT_LE(pagesWith([](ReportChoice& c) { c.grids = false; }), all - open.session.project()->project.grids.size());
    EXPECT_LT(pagesWith([](ReportChoice& c) { c.schedule = false; }), all);
    EXPECT_LT(pagesWith([](ReportChoice& c) { c.accuracy = false; }), all);
    EXPECT_LT(pagesWith([](ReportChoice& c) { c.method = false; }), all);
    pagesWith([](ReportChoice& c) { c.falseColour = false; });
    EXPECT_EQ(reporting().pages()->contents().views.size(), 1U);
    pagesWith([](ReportChoice& c) { c.views.clear(); });
    EXPECT_TRUE(reporting().pages()->contents().views.empty());
    EXPECT_EQ(pagesWith([](ReportChoice&) {}), all);
    EXPECT_EQ(reporting().pages()->contents().views.front().png, rendered);
}

TEST_F(ReportingTest, PagesAreDrawnAsSharpAsTheyAreSeen) {
    ASSERT_TRUE(make()) << open.errors();
    reporting().look(1, 3);
    reporting().look(2, 5);  // the newest counts
    ASSERT_TRUE(open.untilIdle());
    EXPECT_EQ(reporting().lookedAt(), 2U);
    EXPECT_EQ(reporting().page().width, 210 * 5);
    EXPECT_EQ(reporting().page().height, 297 * 5);
    const auto& rgb = reporting().page().rgb;
    EXPECT_LT(*std::min_element(rgb.begin(), rgb.end()), 60);  // ink
    EXPECT_EQ(rgb.front(), 255);
}

TEST_F(ReportingTest, WhereItCannotBeWrittenItSaysSoAndKeepsTheReport) {
    EXPECT_FALSE(reporting().save(folder.path() / "r.pdf"));
    ASSERT_TRUE(make()) << open.errors();
    EXPECT_FALSE(reporting().save(folder.path() / "r.txt"));
    ASSERT_TRUE(reporting().save(folder.path() / "none" / "r.pdf"));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), HasSubstr("none"));
    EXPECT_NE(reporting().pages(), nullptr);
}

TEST_F(ReportingTest, StoppedItLeavesNothingHalf) {
    choice.views = {open.session.project()->project.views.front().name};
    choice.viewSeconds = 3600;
    reporting().make(choice);
    reporting().cancel();
    ASSERT_TRUE(open.untilIdle());
    EXPECT_EQ(reporting().pages(), nullptr);
    EXPECT_THAT(open.errors(), IsEmpty());
}

}  // namespace
}  // namespace luxdeck::gui

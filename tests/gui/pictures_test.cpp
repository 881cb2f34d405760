// Pictures of a session: rendered, shown, compared with what was before, saved.
#include "tests/gui/open_session.h"

#include "engine/io/image_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>


namespace luxdeck::gui {
namespace {

using test::OpenSession;
using test::OwnFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PicturesTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors(); }

    PictureRequest request(std::uint32_t samples = 2) const {
        PictureRequest out{open.session.project()->project.views.front(), {}};
        out.view.width = 240, out.view.height = 160;
        out.settings.samples = samples;
        return out;
    }
    Pictures& pictures() { return open.session.pictures; }

    OwnFolder folder;
    OpenSession open;
};

TEST_F(PicturesTest, ARenderingIsWhatTheCommandLineRenders) {
    const auto wanted = request();
    ASSERT_TRUE(pictures().render(wanted));
    ASSERT_TRUE(open.untilIdle());
    const auto* shown = pictures().shown(0);
    ASSERT_NE(shown, nullptr) << open.errors();
    EXPECT_FALSE(shown->running);
    EXPECT_TRUE(shown->current);
    const auto& project = *open.session.project();
    const auto same = render(project.project, project.lit, wanted.view, wanted.settings, Progress());
    ASSERT_TRUE(same);
    EXPECT_EQ(shown->image->channel("G"), same->image.channel("G"));
    ASSERT_NE(pictures().developed(0), nullptr);
    const auto seen = show(same->image, {});
    ASSERT_TRUE(seen);
    EXPECT_EQ(pictures().developed(0)->image.rgb, seen->image.rgb);
    EXPECT_EQ(pictures().behind(0), shown->image);
}

TEST_F(PicturesTest, ASmallOneComesFirst) {
    auto wanted = request();
    wanted.view.width = 600, wanted.view.height = 400;
    std::vector<int> widths;
    open.session.observe([&](Change change) {
        const auto* shown = pictures().shown(0);
        if (change == Change::Pictures && shown && shown->result && (widths.empty() || widths.back() != shown->result->image.width()))
            widths.push_back(shown->result->image.width());
    });
    ASSERT_TRUE(pictures().render(wanted));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(widths, ElementsAre(testing::Lt(300), 600));
}

TEST_F(PicturesTest, StoppingKeepsWhatThereIs) {
    auto wanted = request();
    wanted.settings.samples.reset();
    wanted.settings.targetError = 0;
    wanted.settings.timeSeconds = 3600;
    ASSERT_TRUE(pictures().render(wanted));
    ASSERT_TRUE(open.until([&] { return pictures().shown(0) && pictures().shown(0)->result && pictures().shown(0)->result->samplesPerPixel > 1; }));
    pictures().cancel();
    ASSERT_TRUE(open.untilIdle());
    ASSERT_NE(pictures().shown(0), nullptr);
    EXPECT_FALSE(pictures().shown(0)->running);
    EXPECT_FALSE(pictures().shown(0)->result->complete);
    const auto file = folder.path() / "stopped.exr";
    ASSERT_TRUE(pictures().save(pictures().shown(0)->number, file));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_EQ(readExr(file)->text.at("luxdeck:complete"), "false");
}

TEST_F(PicturesTest, AnEditKeepsTheEarlierPictureBesideTheNewOne) {
    ASSERT_TRUE(pictures().render(request()));
    ASSERT_TRUE(open.untilIdle());
    const auto first = pictures().shown(0)->number;
    ASSERT_TRUE(open.session.edit("Darker carpet", [](const std::string& text) -> Result<std::string> {
        auto out = text;
        const std::string what = "reflectance = [0.190, 0.200, 0.215]";
        return out.replace(out.find(what), what.size(), "reflectance = 0.01");
    }));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_FALSE(pictures().numbered(first)->current);
    EXPECT_THAT(pictures().numbered(first)->name(), HasSubstr("earlier"));
    ASSERT_TRUE(pictures().render(request()));
    ASSERT_TRUE(open.untilIdle());
    ASSERT_EQ(pictures().all().size(), 2u);
    pictures().show(1, first);
    ASSERT_TRUE(open.untilIdle());
    ASSERT_NE(pictures().developed(1), nullptr);
    EXPECT_NE(pictures().developed(0)->image.rgb, pictures().developed(1)->image.rgb);
    open.session.undo();
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(pictures().numbered(first)->current);
}

TEST_F(PicturesTest, OfManyLooksTheLastIsSeen) {
    ASSERT_TRUE(pictures().render(request()));
    ASSERT_TRUE(open.untilIdle());
    Look look;
    look.tone.op = tonemap::Operator::Linear;
    for (const double ev : {1.0, 2.0, 3.0}) look.tone.exposureEv = ev, pictures().setLook(look);
    look.falseColour = true;
    pictures().setLook(look);
    look.falseColour = false, look.tone.exposureEv = -1;
    pictures().setLook(look);
    ASSERT_TRUE(open.untilIdle());
    const auto& seen = *pictures().developed(0);
    ASSERT_TRUE(seen.record);
    EXPECT_NEAR(seen.record->factor, 0.18 * 100 / seen.record->worldLogMeanCdM2 / 2, 1e-9 * seen.record->factor);
}

TEST_F(PicturesTest, SavesNumbersAndColours) {
    ASSERT_TRUE(pictures().render(request()));
    ASSERT_TRUE(open.untilIdle());
    const auto number = pictures().shown(0)->number;
    for (const char* name : {"a.exr", "a.hdr", "a.png"}) ASSERT_TRUE(pictures().save(number, folder.path() / name));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), IsEmpty());
    EXPECT_EQ(readExr(folder.path() / "a.exr")->channel("R"), pictures().shown(0)->image->channel("R"));
    const auto hdr = readRgbe(folder.path() / "a.hdr");
    ASSERT_TRUE(hdr);
    EXPECT_EQ(hdr->width(), 240);
    EXPECT_EQ(readPng(folder.path() / "a.png")->rgb, pictures().developed(0)->image.rgb);
    EXPECT_FALSE(pictures().save(number, folder.path() / "a.bmp"));
}

TEST_F(PicturesTest, WhereItCannotBeSavedItSaysSo) {
    ASSERT_TRUE(pictures().render(request()));
    ASSERT_TRUE(open.untilIdle());
    ASSERT_TRUE(pictures().save(pictures().shown(0)->number, folder.path() / "no such folder" / "a.exr"));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), HasSubstr("no such folder"));
    ASSERT_NE(pictures().shown(0), nullptr);
}

TEST_F(PicturesTest, ClosingWhileRenderingLeavesNothing) {
    auto wanted = request();
    wanted.settings.samples.reset();
    wanted.settings.timeSeconds = 3600, wanted.settings.targetError = 0;
    ASSERT_TRUE(pictures().render(wanted));
    ASSERT_TRUE(open.until([&] { return pictures().developed(0) != nullptr; }));
    open.session.close();
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(pictures().all().empty());
    EXPECT_EQ(pictures().developed(0), nullptr);
}

TEST_F(PicturesTest, WhatCannotBeRenderedIsRefusedAtOnce) {
    auto wanted = request();
    wanted.view.width = 0;
    EXPECT_FALSE(pictures().render(wanted));
    open.session.close();
    EXPECT_FALSE(pictures().render({}));
}

}  // namespace
}  // namespace luxdeck::gui

// Furniture in hand: its light follows, and what is left in the project is where it was shown.
#include "gui/session/furnishing.h"

#include "tests/gui/open_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace luxdeck::gui {
namespace {

using test::OpenSession;
using test::OwnFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Coarse, and so quick.
VolumeRequest coarse() {
    VolumeRequest request;
    request.settings.firstLevel = {9, 7, 4}, request.settings.secondLevel = 0;
    request.settings.side = 7, request.settings.samplesPerBin = 2, request.settings.lightSamples = 16;
    return request;
}

class FurnishingTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(open_.open(folder_.sample("office"))) << open_.errors(); }

    Furnishing& hand() { return open_.session.furnishing; }
    bool take(const std::string& object) {
        hand().begin(object, coarse());
        return open_.untilIdle() && hand().state() == Furnishing::State::Ready;
    }

    OwnFolder folder_;
    OpenSession open_;
};

TEST_F(FurnishingTest, TheVerdictChangesInADarkPlaceAndBack) {
    auto finer = coarse();
    finer.settings.firstLevel = {21, 14, 6};
    hand().begin("Meeting table", finer);
    ASSERT_TRUE(open_.untilIdle());
    ASSERT_EQ(hand().state(), Furnishing::State::Ready) << open_.errors();
    EXPECT_EQ(hand().requiredBy(), "Meeting table");
    ASSERT_TRUE(hand().requirement().meanAtLeast);
    const auto lit = hand().light();
    ASSERT_GT(lit.mean.value, 0);
    // Into the middle of the room, between the luminaires' rows, and back: a limit between the two lights decides.
    const Pose dark{Vec3d(8, 7, 0) - Vec3d(hand().pivot().x, hand().pivot().y, 0), 0};
    hand().moveTo(dark);
    const auto unlit = hand().light();
    ASSERT_LT(unlit.mean.high(), lit.mean.low());
    hand().moveTo({});
    hand().setRequirement({(unlit.mean.high() + lit.mean.low()) / 2, {}});
    EXPECT_EQ(hand().light().verdict, FurnitureVerdict::Met);
    EXPECT_THAT(hand().warning({}), IsEmpty());
    EXPECT_THAT(hand().statement({}), HasSubstr("requirement met"));

    int told = 0;
    open_.session.observe([&](Change change) { told += change == Change::Furniture ? 1 : 0; });
    hand().moveTo(dark);
    EXPECT_EQ(told, 1);
    EXPECT_EQ(hand().light().verdict, FurnitureVerdict::Under);
    EXPECT_THAT(hand().warning({}), StartsWith("Meeting table: too little light: "));
    EXPECT_THAT(hand().warning({}), HasSubstr(" lx required"));
    EXPECT_THAT(hand().warning({LightUnit::Footcandle, LengthUnit::Feet}), HasSubstr(" fc required"));
    hand().moveTo({});
    EXPECT_EQ(hand().light().verdict, FurnitureVerdict::Met);
    EXPECT_EQ(hand().light().mean.value, lit.mean.value) << "the same place, the same bits";
    hand().setRequirement({{}, 0.5 * lit.maximum.value});
    EXPECT_EQ(hand().light().verdict, FurnitureVerdict::Over);
    EXPECT_THAT(hand().warning({}), HasSubstr("too much light: up to "));
}

TEST_F(FurnishingTest, CommitLeavesItInTheProjectAndUndoPutsItBack) {
    ASSERT_TRUE(take("Meeting table")) << open_.errors();
    const auto before = open_.session.project()->project.scene.hash;
    const auto pivot = hand().pivot();
    hand().moveTo({{-1, 0, 0}, 90});
    const auto shown = hand().light();
    ASSERT_TRUE(hand().commit(open_.session));
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_THAT(open_.errors(), IsEmpty());
    EXPECT_EQ(open_.session.document().undoName(), "Move Meeting table");
    EXPECT_THAT(open_.session.document().text(), HasSubstr("object = \"Meeting table\"\nmovable = true\nmove = [-1, 0, 0]\nturn_deg = 90\n"));
    EXPECT_NE(open_.session.project()->project.scene.hash, before);
    // Still in hand, in the same room: its volume was not built again, and the light is what was shown.
    ASSERT_EQ(hand().state(), Furnishing::State::Ready);
    EXPECT_EQ(open_.session.volumes.all().size(), 1U);
    EXPECT_EQ(hand().pose(), Pose{});
    EXPECT_EQ(hand().requiredBy(), "Meeting table") << "what a table is for goes with it";
    EXPECT_LT((hand().pivot() - pivot - Vec3d(-1, 0, 0)).length(), 1e-5);
    // The vertices are divided along other axes now: the same light to a few per cent.
    EXPECT_NEAR(hand().light().mean.value, shown.mean.value, 0.05 * shown.mean.value);
    open_.session.undo();
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(open_.session.project()->project.scene.hash, before);
    EXPECT_LT((hand().pivot() - pivot).length(), 1e-5);
    hand().cancel();
    EXPECT_EQ(hand().state(), Furnishing::State::Idle);
    EXPECT_EQ(hand().lighting(), nullptr);
}

TEST_F(FurnishingTest, TheRoomIsAskedOnRequest) {
    ASSERT_TRUE(take("Meeting table")) << open_.errors();
    EXPECT_EQ(open_.session.volumes.all().at(0).without, "Meeting table");
    hand().estimateRoom();
    ASSERT_TRUE(open_.untilIdle());
    ASSERT_TRUE(hand().roomChange());
    EXPECT_TRUE(hand().roomChangeCurrent());
    EXPECT_EQ(hand().roomChange()->estimated.size(), open_.session.project()->project.grids.size());
    SolveSettings settings;
    settings.samples = 16;
    hand().solveRoom(settings);
    ASSERT_TRUE(open_.untilIdle());
    ASSERT_NE(hand().roomChange()->exact, nullptr) << open_.errors();
    EXPECT_FALSE(hand().roomChange()->estimated.empty()) << "both are of one pose";
    hand().moveTo({{0.5, 0, 0}, 0});
    EXPECT_FALSE(hand().roomChangeCurrent());
}

TEST_F(FurnishingTest, WhatIsNotThereIsSaidAndWhatIsClosedIsLeft) {
    hand().begin("No such desk", coarse());
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(hand().state(), Furnishing::State::Idle);
    EXPECT_THAT(open_.errors(), HasSubstr("no object \"No such desk\""));
    hand().begin("Meeting table");  // the whole volume: closed while it is built
    EXPECT_EQ(hand().state(), Furnishing::State::Preparing);
    open_.session.close();
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(hand().state(), Furnishing::State::Idle);
    EXPECT_TRUE(open_.session.volumes.all().empty());
}

}  // namespace
}  // namespace luxdeck::gui

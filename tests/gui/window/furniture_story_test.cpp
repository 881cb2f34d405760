// A table is dragged out of its light with its handle: the warning comes, and goes when it is brought back.
#include "analysis/report/canvas.h"
#include "tests/gui/window/hands.h"

#include <QLabel>
#include <QPushButton>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::OpenWindow;
using test::OwnFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const Vec3d kDark(8, 7, 0);  // in the plan of the office: between the luminaires' rows

class FurnitureStory : public testing::Test {
protected:
    /// The office with a coarse volume, its meeting table in hand by a click.
    void SetUp() override {
        const auto file = folder_.sample("office");
        test::replaceInFile(file, "first_level = [7, 7, 7]\nsecond_level = 3\nbins = 17", "first_level = [15, 10, 5]\nsecond_level = 1\nbins = 7");
        ASSERT_TRUE(open_.open(file));
        ASSERT_TRUE(test::clickTab(open_, "Furniture"));
        session().select({Thing::Object, test::objectNamed(session(), "Meeting table")});
        open_.click("furnitureBegin");
        ASSERT_TRUE(open_.untilIdle());
        ASSERT_EQ(hand().state(), Furnishing::State::Ready);
        open_.window->views().lookFrom(Side::Top);
        QTest::qWait(150);
        atHome_ = hand().light().mean;
    }
    Session& session() { return open_.session(); }
    Furnishing& hand() { return session().furnishing; }
    SceneView& view() { return open_.window->views().view(0); }
    std::string verdict() { return open_.find<QLabel>("furnitureVerdict")->text().toStdString(); }
    std::string look() { return open_.find<QLabel>("furnitureVerdict")->styleSheet().toStdString(); }
    QPoint pixel(const Vec3d& user) { return view().pixelOf(user - session().project()->project.scene.origin).value().toPoint(); }

    /// Presses the square between the arrows, moves the table's pivot to a place of the plan, and lets go.
    void dragTo(const Vec3d& place) {
        const auto now = hand().pivot() + Vec3d(hand().pose().moveM);
        const auto handle = view().gizmo().placeOf(Handle::Plan);
        ASSERT_TRUE(handle);
        ASSERT_EQ(view().gizmo().handleAt(*handle), Handle::Plan);
        test::dragBy(view(), handle->toPoint(), pixel(Vec3d(place.x, place.y, now.z)) - pixel(now));
        QTest::qWait(100);
    }
    /// The limit between the light at home and in the dark, by the panel's box.
    void requireBetween(const Interval& dark) {
        ASSERT_LT(dark.high(), atHome_.low());
        test::type(open_.find<QDoubleSpinBox>("furnitureRequired"), QString::number((dark.high() + atHome_.low()) / 2, 'f', 0));
    }

    OwnFolder folder_;
    OpenWindow open_;
    Interval atHome_;
};

TEST_F(FurnitureStory, TheWarningComesWhenItIsDraggedIntoTheDarkAndGoesWhenItComesBack) {
    const auto home = hand().pivot();
    dragTo(kDark);
    ASSERT_LT((hand().pivot() + Vec3d(hand().pose().moveM) - Vec3d(kDark.x, kDark.y, home.z)).length(), 0.2) << "it is where the hand brought it";
    requireBetween(hand().light().mean);
    EXPECT_THAT(verdict(), HasSubstr("too little light"));
    EXPECT_THAT(look(), HasSubstr(report::ink::kNotMet.name().toStdString()));
    dragTo(home);
    EXPECT_THAT(verdict(), HasSubstr("requirement met"));
    EXPECT_THAT(look(), HasSubstr(report::ink::kMet.name().toStdString()));
    EXPECT_THAT(verdict(), Not(HasSubstr("too little")));
    dragTo(kDark);
    EXPECT_THAT(verdict(), HasSubstr("too little light"));
    EXPECT_FALSE(session().document().modified()) << "in hand it is not left anywhere yet";
    open_.click("furnitureBack");
    EXPECT_EQ(hand().state(), Furnishing::State::Idle);
}

TEST_F(FurnitureStory, LeavingItIsOneStepThatUndoTakesBack) {
    const auto text = session().document().text();
    const auto home = hand().pivot();
    dragTo(home - Vec3d(1, 1, 0));
    ASSERT_FALSE(hand().pose() == Pose{});
    open_.click("furnitureLeave");
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_THAT(session().document().text(), HasSubstr("object = \"Meeting table\"\nmovable = true\nmove = ["));
    EXPECT_TRUE(open_.window->isWindowModified());
    EXPECT_LT((hand().pivot() - home + Vec3d(1, 1, 0)).length(), 0.2);
    open_.command("undo");
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(session().document().text(), text);
    EXPECT_FALSE(open_.window->isWindowModified());
    EXPECT_LT((hand().pivot() - home).length(), 1e-5);
}

}  // namespace
}  // namespace luxdeck::gui

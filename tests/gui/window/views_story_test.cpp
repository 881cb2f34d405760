// Two views side by side, a view that is kept, a room that is cut open.
#include "gui/session/scene_parts.h"
#include "tests/gui/window/hands.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QSlider>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::OpenWindow;
using test::OwnFolder;
using testing::HasSubstr;

class ViewsStory : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(open_.open(folder_.sample("office"))); }
    Session& session() { return open_.session(); }
    ViewArea& area() { return open_.window->views(); }

    OwnFolder folder_;
    OpenWindow open_;
};

TEST_F(ViewsStory, TurningOneOfTwoLinkedViewsTurnsTheOther) {
    open_.command("twoViews");
    ASSERT_EQ(area().viewCount(), 2U);
    area().lookFrom(Side::Iso);
    QTest::qWait(100);
    const auto before = area().view(1).pose();
    auto& left = area().view(0);
    test::dragBy(left, left.rect().center(), QPoint(120, 30));
    EXPECT_FALSE(left.pose() == before);
    EXPECT_EQ(area().view(1).pose(), left.pose());
    open_.command("linkedCameras");
    test::dragBy(left, left.rect().center(), QPoint(-60, 0));
    EXPECT_FALSE(area().view(1).pose() == left.pose()) << "each for itself";
    open_.command("linkedCameras");
    open_.command("oneView");
    EXPECT_EQ(area().viewCount(), 1U);
}

TEST_F(ViewsStory, TheCameraIsKeptInTheProjectByAName) {
    area().lookFrom(Side::Iso);
    auto& view = area().view(0);
    test::dragBy(view, view.rect().center(), QPoint(80, -20));
    const auto pose = view.pose();
    const auto text = session().document().text();
    const auto views = session().project()->project.views.size();
    QTimer::singleShot(300, qApp, [] {
        auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr) return;
        auto* name = dialog->findChild<QLineEdit*>();
        name->selectAll();
        QTest::keyClicks(name, "from the door");
        QTest::keyClick(name, Qt::Key_Return);
    });
    open_.command("insertView");
    ASSERT_TRUE(open_.untilIdle());
    ASSERT_EQ(session().project()->project.views.size(), views + 1);
    EXPECT_THAT(session().document().text(), HasSubstr("from the door"));
    area().lookFrom(Side::Top);
    ASSERT_FALSE(view.pose() == pose);
    area().goTo(session().project()->project.views.back());
    EXPECT_LT((view.pose().position - pose.position).length(), 0.01);
    open_.command("undo");
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(session().document().text(), text);
}

TEST_F(ViewsStory, TheSectionCutsWhatLiesBeforeIt) {
    area().lookFrom(Side::Iso);
    ASSERT_TRUE(test::clickTab(open_, "Show"));
    auto& view = area().view(0);
    const SceneParts parts(session().project()->project.scene);
    const auto sofa = test::objectNamed(session(), "Sofa");
    const auto at = view.pixelOf(Vec3d(parts.bounds(static_cast<std::uint32_t>(sofa)).center())).value().toPoint();
    ASSERT_EQ(view.pickedAt(at).what, (Selection{Thing::Object, sofa}));
    test::clickBox(open_.find<QCheckBox>("sectionOn"));
    ASSERT_TRUE(session().views().front().section.on);
    auto* slider = open_.find<QSlider>("sectionOffset");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Home);
    const bool first = view.pickedAt(at).what == Selection{Thing::Object, sofa};
    const auto picture = view.picture();
    QTest::keyClick(slider, Qt::Key_End);
    QTest::qWait(100);
    const bool last = view.pickedAt(at).what == Selection{Thing::Object, sofa};
    EXPECT_NE(first, last) << "at one end the sofa is cut away, at the other it is there";
    EXPECT_NE(view.picture(), picture);
    test::clickBox(open_.find<QCheckBox>("sectionOn"));
    EXPECT_EQ(view.pickedAt(at).what, (Selection{Thing::Object, sofa}));
}

}  // namespace
}  // namespace luxdeck::gui

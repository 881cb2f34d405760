// Everything at once, and then the window is closed; edits one after another, and back again.
#include "tests/gui/window/hands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::OpenWindow;
using test::OwnFolder;

TEST(ClosingStory, TheWindowClosesWhileItSolvesRendersAndBuilds) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    auto& jobs = open.session().place.jobs;
    test::type(open.find<QDoubleSpinBox>("solveTarget"), "0.1");
    test::type(open.find<QDoubleSpinBox>("solveTime"), "3600");
    open.click("solveButton");
    open.command("render");
    open.command("buildVolume");
    EXPECT_TRUE(jobs.running(JobKind::Solve));
    EXPECT_TRUE(jobs.running(JobKind::Render));
    EXPECT_TRUE(jobs.running(JobKind::Volume));
    QTest::qWait(500);  // amid the work
    EXPECT_TRUE(open.window->close());
    EXPECT_TRUE(open.untilIdle());
    EXPECT_EQ(open.session().project(), nullptr);
    EXPECT_EQ(open.session().solving.result(), nullptr) << "what came late is of no project";
}

TEST(ClosingStory, AnotherProjectIsOpenedWhileTheFirstIsSolved) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    open.click("solveButton");
    open.command("buildVolume");
    QTest::qWait(300);
    ASSERT_TRUE(open.open(folder.sample("gallery")));
    EXPECT_EQ(open.session().solving.result(), nullptr);
    EXPECT_TRUE(open.session().volumes.all().empty());
    EXPECT_EQ(open.find<QTableView>("gridTable")->model()->rowCount(), 0);
}

TEST(ClosingStory, EveryEditIsTakenBackAndDoneAgain) {
    const OwnFolder folder;
    OpenWindow open;
    const auto file = folder.sample("office");
    ASSERT_TRUE(open.open(file));
    auto& session = open.session();
    std::vector<std::string> texts{session.document().text()};
    const auto next = [&](const char* what) {
        ASSERT_TRUE(open.untilIdle());
        ASSERT_NE(session.document().text(), texts.back()) << what;
        texts.push_back(session.document().text());
    };
    session.select({Thing::Luminaire, 3});
    open.command("duplicate");
    next("duplicate");
    session.select({Thing::Luminaire, 0});
    open.command("switchSelected");
    next("switch off");
    open.command("insertSurface");
    next("calculation surface");
    session.select({Thing::Grid, 0});
    open.command("remove");
    next("remove");
    const auto count = texts.size();
    for (std::size_t i = count - 1; i-- > 0;) {
        open.command("undo");
        ASSERT_TRUE(open.untilIdle());
        EXPECT_EQ(session.document().text(), texts[i]);
    }
    EXPECT_FALSE(open.find<QAction>("undo")->isEnabled());
    EXPECT_FALSE(open.window->isWindowModified());
    for (std::size_t i = 1; i < count; ++i) {
        open.command("redo");
        ASSERT_TRUE(open.untilIdle());
        EXPECT_EQ(session.document().text(), texts[i]);
    }
    EXPECT_FALSE(open.find<QAction>("redo")->isEnabled());
    open.command("saveProject");
    EXPECT_EQ(test::contents(file), texts.back());
    open.command("undo");  // before what is saved
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(open.window->isWindowModified());
    EXPECT_EQ(session.place.log().end(), std::find_if(session.place.log().begin(), session.place.log().end(), [](const LogEntry& e) { return e.severity == Severity::Error; }));
}

}  // namespace
}  // namespace luxdeck::gui

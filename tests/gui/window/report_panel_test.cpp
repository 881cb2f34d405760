// The report panel under real clicks.
#include "gui/panels/page_view.h"
#include "gui/panels/report_panel.h"
#include "tests/gui/open_session.h"
#include "tests/gui/window/panel_support.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::click;
using test::found;
using test::OpenSession;
using test::OwnFolder;

TEST(ReportPanelTest, MakesAReportTurnsItsPagesAndLeavesAPartOut) {
    const OwnFolder folder;
    OpenSession open;
    ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors();
    SolveSettings quick;
    quick.samples = 64;
    open.session.solving.start(quick);
    ASSERT_TRUE(open.untilIdle());
    ReportPanel panel(open.session);
    panel.resize(1280, 800);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    test::picture(panel, "report_panel_empty");
    found<QDoubleSpinBox>(panel, "reportViewTime")->setValue(0.5);
    EXPECT_FALSE(found<QPushButton>(panel, "reportExport")->isEnabled());
    click(panel, "reportMake");
    ASSERT_TRUE(open.untilIdle());
    ASSERT_NE(open.session.reporting.pages(), nullptr) << open.errors();
    auto* list = found<QListWidget>(panel, "reportThumbnails");
    const int all = list->count();
    EXPECT_EQ(all, static_cast<int>(open.session.reporting.pages()->count()));
    EXPECT_TRUE(found<QPushButton>(panel, "reportExport")->isEnabled());

    QTest::keyClick(list, Qt::Key_Down);
    ASSERT_TRUE(open.untilIdle());
    EXPECT_EQ(open.session.reporting.lookedAt(), 1U);
    EXPECT_EQ(found<QLabel>(panel, "reportAbout")->text(), QString("Page 2 of %1").arg(all));
    const int before = open.session.reporting.page().width;
    for (int i = 0; i < 4; ++i) click(panel, "reportZoomIn");
    QTest::qWait(150);
    ASSERT_TRUE(open.untilIdle());
    EXPECT_GT(open.session.reporting.page().width, 2 * before);
    click(panel, "reportFit");
    QTest::qWait(150);
    ASSERT_TRUE(open.untilIdle());
    test::picture(panel, "report_panel");
    ASSERT_TRUE(open.untilIdle());

    click(panel, "reportMethod");  // nothing new to compute: it is seen at once
    ASSERT_TRUE(open.untilIdle());
    EXPECT_LT(list->count(), all);
}

}  // namespace
}  // namespace luxdeck::gui

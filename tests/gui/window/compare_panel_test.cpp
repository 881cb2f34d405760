// The compare panel under real clicks.
#include "gui/panels/compare_panel.h"
#include "gui/panels/error_plot.h"
#include "tests/gui/open_session.h"
#include "tests/gui/window/panel_support.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>

#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::click;
using test::found;
using test::OpenSession;
using test::OwnFolder;

class ComparePanelTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors();
        panel.resize(1280, 800);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }

    OwnFolder folder;
    OpenSession open;
    ComparePanel panel{open.session};
};

TEST_F(ComparePanelTest, ComparesTwoAlgorithmsAndShowsTheRunThatIsClicked) {
    test::picture(panel, "compare_panel_empty");
    found<QDoubleSpinBox>(panel, "compareBudget")->setValue(0.2);
    found<QSpinBox>(panel, "compareRungs")->setValue(4);
    found<QSpinBox>(panel, "compareRepetitions")->setValue(3);
    found<QDoubleSpinBox>(panel, "compareKnown")->setValue(10);
    found<QDoubleSpinBox>(panel, "comparePicturesKnown")->setValue(80);
    const auto view = QStringLiteral("compareView_") + QString::fromStdString(open.session.project()->project.views.front().name);
    found<QCheckBox>(panel, view.toLatin1().constData())->setChecked(true);
    click(panel, "compare_radiosity");
    click(panel, "compareButton");
    ASSERT_TRUE(open.untilIdle()) << open.errors();
    const auto& result = open.session.comparing.result();
    ASSERT_NE(result, nullptr) << open.errors();
    EXPECT_EQ(found<QTableWidget>(panel, "compareOrder")->rowCount(), 3);

    auto& plot = *found<ErrorPlot>(panel, "errorPlot");
    const RunKey key{"grids", result->runs.front().algorithm, result->runs.front().rung};
    const auto at = plot.placeOf(key);
    ASSERT_TRUE(at);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at->toPoint());
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(open.session.comparing.looked() == key);
    EXPECT_FALSE(open.session.comparing.pictures().empty());
    test::picture(panel, "compare_panel");
    open.session.comparing.look({open.session.project()->project.views.front().name, "path", 3});
    ASSERT_TRUE(open.untilIdle());
    test::picture(panel, "compare_panel_view");
}

TEST_F(ComparePanelTest, SaysWhatIsMissingBeforeItCanStart) {
    auto* button = found<QPushButton>(panel, "compareButton");
    EXPECT_TRUE(button->isEnabled());
    click(panel, "compareGrids");
    EXPECT_FALSE(button->isEnabled());
    EXPECT_EQ(found<QLabel>(panel, "compareEstimate")->text(), "Choose what to compare them on.");
}

}  // namespace
}  // namespace luxdeck::gui

// Opened, solved, read: the number under the cursor, in the table and of the command line is one number.
#include "gui/panels/text.h"
#include "tests/gui/window/hands.h"

#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::OpenWindow;
using test::OwnFolder;
using testing::HasSubstr;

constexpr std::size_t kWorkPlane = 7;  // of the office's calculation surfaces: the whole room's

TEST(SolveStory, TheCursorTheTableAndTheCommandLineAgree) {
    const OwnFolder folder;
    const auto file = folder.sample("office");
    OpenWindow open;
    ASSERT_TRUE(open.open(file));
    test::type(open.find<QDoubleSpinBox>("solveTarget"), "40");
    open.click("solveButton");
    ASSERT_TRUE(open.untilIdle());
    const auto result = open.session().solving.result();
    ASSERT_NE(result, nullptr);
    ASSERT_TRUE(result->complete && result->targetReached);
    const auto json = test::solveByCommandLine(file, "--algorithm shared --target-error 40%");
    ASSERT_FALSE(json.is_discarded());
    const auto& surface = json["grids"][kWorkPlane];
    ASSERT_EQ(surface["name"], "Whole room, work plane");

    // A point that no furniture hides from above, and not at the room's edge.
    const auto& grid = result->grids[kWorkPlane];
    const std::size_t row = static_cast<std::size_t>(grid.columns) + 9;
    open.session().select({Thing::Grid, kWorkPlane});
    auto* points = open.find<QTableView>("pointTable");
    const auto inTable = test::cell(points, static_cast<int>(row), 3);
    EXPECT_EQ(inTable.toStdString(), intervalText(surface["points"][row]["lx"], surface["points"][row]["ci95"]));

    auto& area = open.window->views();
    area.lookFrom(Side::Top);
    auto& view = area.view(0);
    const auto place = grid.points[row].position - open.session().project()->project.scene.origin;
    for (int i = 0; i < 12; ++i) test::wheelIn(view, view.pixelOf(place).value().toPoint());
    QTest::qWait(100);
    QString reading;
    QObject::connect(&area, &ViewArea::probed, [&](const QString& text) { reading = text; });
    test::moveTo(view, view.pixelOf(place).value().toPoint());
    EXPECT_THAT(reading.toStdString(), HasSubstr("Whole room, work plane"));
    // A pixel is millimetres wide from so near: it reads the point's light, but for the last digit.
    const auto number = [](const QString& interval) { return interval.section(QStringLiteral("±"), 0, 0).trimmed().remove(QLatin1Char(' ')).toDouble(); };
    EXPECT_GT(number(inTable), 0);
    EXPECT_NEAR(number(reading.section(QStringLiteral("·"), 1, 1)), number(inTable), 0.002 * number(inTable)) << reading.toStdString();
}

TEST(SolveStory, ADimmerIsFollowedWhileItMovesAndIsOneStepBack) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    test::clickBox(open.find<QCheckBox>("solveLayers"));
    test::type(open.find<QDoubleSpinBox>("solveTarget"), "50");
    test::type(open.find<QDoubleSpinBox>("solveTime"), "4");
    open.click("solveButton");
    ASSERT_TRUE(open.untilIdle());
    ASSERT_TRUE(open.session().solving.followsDimming());
    const auto text = open.session().document().text();
    auto* grids = open.find<QTableView>("gridTable");
    std::vector<QString> before;
    for (int row = 0; row < grids->model()->rowCount(); ++row) before.push_back(test::cell(grids, row, 1));
    const auto differs = [&] {
        for (int row = 0; row < grids->model()->rowCount(); ++row)
            if (test::cell(grids, row, 1) != before[static_cast<std::size_t>(row)]) return true;
        return false;
    };

    ASSERT_TRUE(test::clickTab(open, "Lighting"));
    auto* dimmer = open.find<QSlider>((std::string("dimmer") + open.session().project()->project.scene.luminaireTypes.front().id).c_str());
    QStyleOptionSlider option;
    option.initFrom(dimmer);
    option.minimum = dimmer->minimum(), option.maximum = dimmer->maximum(), option.sliderPosition = dimmer->value(), option.sliderValue = dimmer->value();
    const auto handle = dimmer->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, dimmer).center();
    QTest::mousePress(dimmer, Qt::LeftButton, {}, handle);
    test::moveTo(*dimmer, handle - QPoint(dimmer->width() / 4, 0), Qt::LeftButton);
    test::moveTo(*dimmer, handle - QPoint(dimmer->width() / 2, 0), Qt::LeftButton);
    EXPECT_TRUE(dimmer->isSliderDown());
    EXPECT_TRUE(differs()) << "the table follows the hand";
    EXPECT_EQ(open.session().document().text(), text) << "and the project waits for its end";
    QTest::mouseRelease(dimmer, Qt::LeftButton, {}, handle - QPoint(dimmer->width() / 2, 0));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_NE(open.session().document().text(), text);
    EXPECT_TRUE(differs());
    EXPECT_TRUE(open.session().solving.current());
    open.command("undo");
    ASSERT_TRUE(open.untilIdle());
    EXPECT_EQ(open.session().document().text(), text);
    EXPECT_FALSE(open.session().document().canUndo());
    EXPECT_FALSE(differs()) << "the numbers are those from before";
    EXPECT_EQ(dimmer->value(), dimmer->maximum());
}

}  // namespace
}  // namespace luxdeck::gui

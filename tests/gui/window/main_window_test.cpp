// The window as a designer uses it: real clicks and keys.
#include "tests/gui/window/hands.h"

#include <QAbstractItemModel>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QListWidget>
#include <QTableView>
#include <QTimer>
#include <QTreeWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace luxdeck::gui {
namespace {

using test::OpenWindow;
using test::OwnFolder;
using test::cell;
using test::replaceInFile;
using test::solveByCommandLine;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MainWindow, BeginsWithTheSamplesAndOpensOneByAClick) {
    OpenWindow open;
    EXPECT_TRUE(open.find("startPage")->isVisible());
    open.click("sample_office");
    ASSERT_TRUE(open.untilIdle());
    ASSERT_NE(open.session().project(), nullptr);
    EXPECT_FALSE(open.find("startPage")->isVisible());
    EXPECT_TRUE(open.find("projectTree")->isVisible());
    EXPECT_THAT(open.window->windowTitle().toStdString(), HasSubstr("Open office"));
    EXPECT_TRUE(open.memory.recent().front().endsWith(QStringLiteral("office/project.toml")));
}

// The numbers of the window are those of the command line: same engine, same seed, same samples, same digits.
TEST(MainWindow, SolvesToTheNumbersOfTheCommandLine) {
    const OwnFolder folder;
    const auto file = folder.sample("office");
    OpenWindow open;
    ASSERT_TRUE(open.open(file));
    SolveSettings settings;
    settings.algorithm = "shared";
    settings.samples = 128;
    open.session().solving.start(settings);
    ASSERT_TRUE(open.untilIdle());
    const auto json = solveByCommandLine(file, "--algorithm shared --samples 128");
    ASSERT_FALSE(json.is_discarded());
    auto* grids = open.find<QTableView>("gridTable");
    ASSERT_EQ(grids->model()->rowCount(), static_cast<int>(json["grids"].size()));
    for (int row = 0; row < grids->model()->rowCount(); ++row) {
        const auto& grid = json["grids"][static_cast<std::size_t>(row)];
        EXPECT_EQ(cell(grids, row, 0).toStdString(), grid["name"].get<std::string>());
        EXPECT_EQ(cell(grids, row, 1).toStdString(), intervalText(grid["mean"]["value"], grid["mean"]["ci95"]));
    }
    open.session().select({Thing::Grid, 2});
    auto* points = open.find<QTableView>("pointTable");
    const auto& expected = json["grids"][2]["points"];
    ASSERT_EQ(points->model()->rowCount(), static_cast<int>(expected.size()));
    for (int row = 0; row < points->model()->rowCount(); ++row)
        EXPECT_EQ(cell(points, row, 3).toStdString(), intervalText(expected[static_cast<std::size_t>(row)]["lx"], expected[static_cast<std::size_t>(row)]["ci95"]));
}

TEST(MainWindow, TheSolveButtonFillsTheTableAndTheTree) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    open.find<QDoubleSpinBox>("solveTarget")->setValue(10);
    open.click("solveButton");
    EXPECT_TRUE(open.session().place.jobs.running(JobKind::Solve));
    ASSERT_TRUE(open.untilIdle());
    ASSERT_NE(open.session().solving.result(), nullptr);
    EXPECT_TRUE(open.session().solving.result()->targetReached);
    EXPECT_EQ(open.find<QTableView>("gridTable")->model()->rowCount(), 12);
    EXPECT_TRUE(open.find("gridTable")->isVisible());
}

TEST(MainWindow, FootcandlesAndFeetEverywhere) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    SolveSettings settings;
    settings.samples = 64;
    open.session().solving.start(settings);
    ASSERT_TRUE(open.untilIdle());
    auto* grids = open.find<QTableView>("gridTable");
    const auto lux = cell(grids, 0, 1);
    open.command("unitFootcandle");
    open.command("unitFeet");
    EXPECT_THAT(grids->model()->headerData(1, Qt::Horizontal).toString().toStdString(), HasSubstr("fc"));
    EXPECT_NE(cell(grids, 0, 1), lux);
    EXPECT_THAT(open.find<QTableView>("pointTable")->model()->headerData(0, Qt::Horizontal).toString().toStdString(), HasSubstr("ft"));
    EXPECT_EQ(open.memory.display().units.light, LightUnit::Footcandle);
    open.command("unitLux");
    open.command("unitMetres");
}

TEST(MainWindow, AProjectWithAMistakeSaysFileAndLineAndWhatIsExpected) {
    const OwnFolder folder;
    const auto file = folder.sample("office");
    replaceInFile(file, "reflectance = 0.28", "reflectance = 2.8");
    OpenWindow open;
    open.window->open(QString::fromStdString(file.string()));
    const auto message = open.message();
    EXPECT_THAT(message, HasSubstr("project.toml:"));
    EXPECT_THAT(message, HasSubstr("2.8"));
    EXPECT_EQ(open.session().project(), nullptr);
}

TEST(MainWindow, AFileThatIsGoneIsSaidAndForgotten) {
    OpenWindow open;
    open.memory.opened(QStringLiteral("/nowhere/project.toml"));
    open.window->open(QStringLiteral("/nowhere/project.toml"));
    EXPECT_THAT(open.message(), HasSubstr("/nowhere/project.toml"));
    EXPECT_FALSE(open.memory.recent().contains(QStringLiteral("/nowhere/project.toml")));
}

// Bug: changes were let go of before it was seen that there was nothing to open instead.
TEST(MainWindow, AFileThatIsGoneCostsNoChanges) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    ASSERT_TRUE(open.session().edit("Note", [](const std::string& text) -> Result<std::string> { return text + "# a note\n"; }));
    ASSERT_TRUE(open.untilIdle());
    open.window->open(QStringLiteral("/nowhere/project.toml"));
    EXPECT_THAT(open.message(), HasSubstr("/nowhere/project.toml"));
    EXPECT_TRUE(open.window->isWindowModified());
    EXPECT_TRUE(open.session().editable());
}

TEST(MainWindow, ClosesWithWorkRunning) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    SolveSettings settings;
    settings.targetError = 0;
    settings.timeSeconds = 3600;
    open.session().solving.start(settings);
    EXPECT_TRUE(open.window->close());
    EXPECT_TRUE(open.untilIdle());
}

TEST(MainWindow, AsksBeforeItLosesChanges) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    ASSERT_TRUE(open.session().edit("Note", [](const std::string& text) -> Result<std::string> { return text + "\n# a note\n"; }));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(open.window->isWindowModified());
    OpenWindow::answer(QStringLiteral("Cancel"));
    EXPECT_FALSE(open.window->close());
    open.command("undo");
    ASSERT_TRUE(open.untilIdle());
    EXPECT_FALSE(open.window->isWindowModified());
    EXPECT_TRUE(open.window->close());
}

TEST(MainWindow, ListsEveryShortcutOnce) {
    OpenWindow open;
    std::vector<std::string> keys;
    for (const auto* action : open.window->commands())
        if (!action->shortcut().isEmpty()) keys.push_back(action->shortcut().toString().toStdString());
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
    open.command("shortcuts");
    auto* dialog = open.find("shortcutsDialog");
    EXPECT_TRUE(dialog->isVisible());
    int rows = 0;
    for (QTreeWidgetItemIterator it(dialog->findChild<QTreeWidget*>()); *it != nullptr; ++it) rows += (*it)->text(1).isEmpty() ? 0 : 1;
    EXPECT_GE(rows, static_cast<int>(keys.size()));
}

}  // namespace
}  // namespace luxdeck::gui

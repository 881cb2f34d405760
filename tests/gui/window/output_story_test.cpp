// Two algorithms are compared and a run is looked at; what was solved goes to the client as a report.
#include "gui/panels/error_plot.h"
#include "gui/panels/text.h"
#include "tests/gui/window/hands.h"

#include <QLabel>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTableWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace luxdeck::gui {
namespace {

namespace fs = std::filesystem;
using test::OpenWindow;
using test::OwnFolder;
using testing::HasSubstr;

TEST(CompareStory, CurvesFillInAndAClickShowsARun) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    open.command("compare");
    for (auto* box : open.window->findChildren<QCheckBox*>(QRegularExpression(QStringLiteral("^compare_")))) {
        const bool wanted = box->objectName() == "compare_path" || box->objectName() == "compare_direct";
        if (box->isChecked() != wanted) test::clickBox(box);
        EXPECT_EQ(box->isChecked(), wanted) << box->objectName().toStdString();
    }
    test::type(open.find<QDoubleSpinBox>("compareBudget"), "0.1");
    open.find<QSpinBox>("compareRungs")->setValue(3);
    open.find<QSpinBox>("compareRepetitions")->setValue(3);
    test::type(open.find<QDoubleSpinBox>("compareKnown"), "20");
    std::set<std::size_t> sizes;
    open.session().observe([&](Change change) {
        if (change == Change::Comparison && open.session().comparing.result()) sizes.insert(open.session().comparing.result()->runs.size());
    });
    open.click("compareButton");
    ASSERT_TRUE(open.untilIdle());
    const auto& result = open.session().comparing.result();
    ASSERT_NE(result, nullptr);
    EXPECT_GE(sizes.size(), 3U) << "the curves grow while it goes on";
    EXPECT_EQ(open.find<QTableWidget>("compareOrder")->rowCount(), 2);

    auto* plot = open.find<ErrorPlot>("errorPlot");
    for (const auto* algorithm : {"path", "direct"}) {
        RunKey key;
        for (const auto& run : result->runs)
            if (run.algorithm == algorithm && plot->placeOf({run.subject, run.algorithm, run.rung})) key = {run.subject, run.algorithm, run.rung};
        ASSERT_EQ(key.algorithm, algorithm) << "has no point in the plot";
        const auto at = plot->placeOf(key);
        QTest::mouseClick(plot, Qt::LeftButton, {}, at->toPoint());
        ASSERT_TRUE(open.untilIdle());
        EXPECT_TRUE(open.session().comparing.looked() == key) << algorithm;
        EXPECT_THAT(open.find<QLabel>("compareRun")->text().toStdString(), HasSubstr(algorithm));
        EXPECT_FALSE(open.session().comparing.pictures().empty());
    }
}

TEST(ReportStory, ThePdfHasTheProjectsNameAndItsTwinTheTablesNumbers) {
    const OwnFolder folder;
    OpenWindow open;
    ASSERT_TRUE(open.open(folder.sample("office")));
    test::type(open.find<QDoubleSpinBox>("solveTarget"), "20");
    open.click("solveButton");
    ASSERT_TRUE(open.untilIdle());
    open.command("report");
    test::type(open.find<QDoubleSpinBox>("reportViewTime"), "0.5");
    open.click("reportMake");
    ASSERT_TRUE(open.untilIdle());
    const auto pdf = folder.path() / "for the client.pdf";
    test::answerFile(pdf);
    open.click("reportExport");
    ASSERT_TRUE(open.untilIdle());
    ASSERT_TRUE(fs::exists(pdf));
    EXPECT_EQ(test::contents(pdf).substr(0, 5), "%PDF-");
    if (!test::outputOf("command -v pdftotext").empty()) {
        EXPECT_THAT(test::outputOf("pdftotext '" + pdf.string() + "' -"), HasSubstr(open.session().project()->project.info.name));
    }

    const auto twin = folder.path() / "for the client.json";
    ASSERT_TRUE(fs::exists(twin));
    const auto json = nlohmann::json::parse(test::contents(twin), nullptr, false);
    ASSERT_FALSE(json.is_discarded());
    ASSERT_TRUE(json.contains("solve"));
    const auto& solved = json["solve"]["grids"];
    const auto* grids = open.find<QTableView>("gridTable");
    ASSERT_EQ(grids->model()->rowCount(), static_cast<int>(solved.size()));
    for (int row = 0; row < grids->model()->rowCount(); ++row) {
        const auto& mean = solved[static_cast<std::size_t>(row)]["mean"];
        EXPECT_EQ(test::cell(grids, row, 1).toStdString(), intervalText(mean["value"], mean["ci95"]));
    }
}

}  // namespace
}  // namespace luxdeck::gui

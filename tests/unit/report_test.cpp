#include "analysis/report/number_format.h"
#include "analysis/report/page_images.h"
#include "analysis/report/pdf_writer.h"
#include "analysis/report/plan_section.h"
#include "analysis/report/report_gather.h"
#include "analysis/report/report_json.h"
#include "engine/core/file.h"
#include "tests/support/example_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <unistd.h>

namespace luxdeck {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A folder of this test's own, gone afterwards.
class ReportFiles : public ::testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                   ("luxdeck_report_" + std::to_string(::getpid()) + "_" +
                                    ::testing::UnitTest::GetInstance()->current_test_info()->name());

    /// The PDF's text as a reader's search sees it; empty when pdftotext is not installed.
    std::string textOf(const ReportContents& contents) {
        const auto path = folder / "report.pdf";
        const auto written = writePdf(contents, path);
        EXPECT_TRUE(written) << (written ? "" : written.error().text());
        std::string text;
        FILE* pipe = ::popen(("pdftotext -layout -enc UTF-8 '" + path.string() + "' - 2>/dev/null").c_str(), "r");
        if (pipe == nullptr) return text;
        std::array<char, 4096> block{};
        while (const auto n = std::fread(block.data(), 1, block.size(), pipe)) text.append(block.data(), n);
        ::pclose(pipe);
        return text;
    }
};

int pagesOf(const std::string& pdf) {
    int pages = 0;
    for (auto at = pdf.find("/Type /Page\n"); at != std::string::npos; at = pdf.find("/Type /Page\n", at + 1)) ++pages;
    return pages;
}

ReportContents small() {
    auto contents = example::office();
    contents.views.clear();
    return contents;
}

TEST(ReportNumbers, AreRoundedToTheirUncertainty) {
    EXPECT_EQ(formatInterval({512.34, 7.6}), "512 ± 8");
    EXPECT_EQ(formatInterval({0.6312, 0.0195}), "0.631 ± 0.020");
    EXPECT_EQ(formatInterval({0.6312, 0.021}), "0.63 ± 0.03");
    EXPECT_EQ(formatInterval({1234.5, 130}), "1230 ± 130");
    EXPECT_EQ(formatInterval({512.34, 0}), "512.3");
    EXPECT_EQ(formatInterval({512.34, kInfinity}), "not known");
    EXPECT_EQ(formatInterval({0, 0}), "0");
    EXPECT_EQ(formatInterval({kInfinity, kInfinity}), "–");
}

TEST(ReportNumbers, APrintedIntervalIsNeverNarrowerThanTheComputedOne) {
    RandomStream random(7);
    for (int i = 0; i < 1000; ++i) {
        const double ci = std::pow(10.0, 4 * random.uniform() - 3);
        const auto text = formatInterval({1000 * random.uniform(), ci});
        const double printed = std::stod(text.substr(text.find("± ") + std::string("± ").size()));
        EXPECT_GE(printed, ci * (1 - 1e-8)) << text;  // 1e-9 is what the rounding forgives, and printing is exact to the digit
    }
}

TEST(ReportNumbers, HaveThinSpacesAndUnits) {
    EXPECT_EQ(formatFixed(51600, 0), "51\u2009600");
    EXPECT_EQ(formatFixed(4300, 0), "4300");
    EXPECT_EQ(formatSeconds(0.84), "840 ms");
    EXPECT_EQ(formatSeconds(200), "3 min 20 s");
    EXPECT_EQ(formatSeconds(7500), "2 h 05 min");
    EXPECT_EQ(formatPercent(0.0096), "0.96 %");
    EXPECT_EQ(formatGridLux(7.26), "7.3");
    EXPECT_EQ(formatGridLux(512.6), "513");
}

TEST(ReportJson, ComesBackAsItWent) {
    auto contents = example::office();
    contents.solve.grids[0].mean.interval.ci95 = kInfinity;
    const auto json = toJson(contents);
    ASSERT_TRUE(json);
    EXPECT_THAT(*json, HasSubstr("\"schema\": \"luxdeck-report/1\""));
    const auto back = fromJson(*json);
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->views[0].png, contents.views[0].png);
    EXPECT_TRUE(std::isinf(back->solve.grids[0].mean.interval.ci95));
    EXPECT_EQ(back->solve.grids[2].mean.verdict, Verdict::NotMet);
    EXPECT_EQ(*toJson(*back), *json);
}

TEST(ReportJson, RegeneratesTheSamePdf) {
    const auto contents = example::office();
    const auto back = fromJson(*toJson(contents));
    ASSERT_TRUE(back) << back.error().text();
    const auto first = pdfBytes(contents), second = pdfBytes(*back);
    ASSERT_TRUE(first);
    ASSERT_TRUE(second);
    EXPECT_TRUE(*first == *second) << "the PDFs differ";
    EXPECT_THAT(*first, HasSubstr("/CreationDate (D:20261122184000"));
}

TEST(ReportJson, NamesThePlaceOfAnError) {
    EXPECT_THAT(fromJson("{").error().text(), HasSubstr("not JSON"));
    EXPECT_THAT(fromJson("[]").error().text(), HasSubstr("expected an object"));
    EXPECT_THAT(fromJson(R"({"schema": "other/1"})").error().text(), HasSubstr("expected \"luxdeck-report/1\""));
    auto json = *toJson(small());
    const std::string good = "\"columns\": 16";
    json.replace(json.find(good), good.size(), "\"columns\": 17");
    EXPECT_THAT(fromJson(json).error().text(), HasSubstr("solve.grids[0]: 17 x 6 points, but 96 are listed"));
    json.replace(json.find("\"columns\": 17"), good.size(), "\"columns\": \"\"");
    EXPECT_THAT(fromJson(json).error().text(), HasSubstr("solve.grids[0].columns: saw \"\", expected a whole number"));
}

TEST_F(ReportFiles, TextCanBeSearched) {
    const auto text = textOf(example::office());
    if (text.empty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    for (const char* words : {"Office Seven", "Desks by the window", "undecided", "not met", "±", "≥ 500 lx", "16 × 6 = 96",
                              "EN 12464-1:2021", "Linea 120", "W/m²", "Operator: human", "5f0c9d2ab8e17734", "slope −1/2", "x86_64"})
        EXPECT_THAT(text, HasSubstr(words));
    EXPECT_THAT(text, Not(HasSubstr("INCOMPLETE")));
}

TEST_F(ReportFiles, AnIncompleteResultSaysSoOnEveryPage) {
    auto contents = small();
    contents.solve.complete = false;
    const auto text = textOf(contents);
    if (text.empty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    int pages = 0;
    for (std::size_t from = 0, end = text.find('\f'); end != std::string::npos; from = end + 1, end = text.find('\f', from), ++pages)
        EXPECT_THAT(text.substr(from, end - from), HasSubstr("INCOMPLETE RESULT")) << "page " << pages + 1;
    EXPECT_GT(pages, 5);
}

TEST(ReportPdf, WhatIsLeftOutIsNotPrintedAndTheTwinSaysSo) {
    auto contents = example::office();
    const auto all = PageImages::create(contents);
    ASSERT_TRUE(all);
    std::size_t less = all->count();
    contents.leftOut.emplace();
    for (const auto section : {ReportSection::Grids, ReportSection::Schedule, ReportSection::Accuracy, ReportSection::Method}) {
        contents.leftOut->push_back(section);
        const auto pages = PageImages::create(contents);
        ASSERT_TRUE(pages);
        EXPECT_LT(pages->count(), less);
        less = pages->count();
        const auto again = fromJson(*toJson(contents));
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_TRUE(again->leftOut == contents.leftOut);
        EXPECT_EQ(pdfBytes(*again).value(), pdfBytes(contents).value());
    }
}

TEST(ReportPdf, PagesOnTheScreenAreThoseOfThePdf) {
    const auto pages = PageImages::create(example::office());
    ASSERT_TRUE(pages);
    const auto pdf = pdfBytes(example::office());
    ASSERT_TRUE(pdf);
    std::size_t inPdf = 0;
    for (auto at = pdf->find("/Type /Page\n"); at != std::string::npos; at = pdf->find("/Type /Page\n", at + 1)) ++inPdf;
    EXPECT_EQ(pages->count(), inPdf);
    const auto all = pages->all(2);
    ASSERT_EQ(all.size(), inPdf);
    EXPECT_EQ(pages->page(1, 2).rgb, all[1].rgb);
    EXPECT_EQ(pages->page(1, 4).width, 2 * all[1].width);
    EXPECT_TRUE(pages->page(inPdf, 2).rgb.empty());
}

TEST(ReportPdf, StandsExtremeContents) {
    EXPECT_TRUE(pdfBytes(ReportContents{})) << "nothing at all";
    auto one = small();
    one.solve.grids = {example::surface("One point", {1, 1, 0.75}, {1, 0, 0}, {0, 1, 0}, 1, 1, {})};
    one.solve.trace = {{1, kInfinity, kInfinity, 10}, {2, 0, 0, 20}};
    EXPECT_TRUE(pdfBytes(one));
    auto unknown = small();
    for (auto& grid : unknown.solve.grids)
        for (auto& p : grid.points) p.total = {std::numeric_limits<double>::quiet_NaN(), kInfinity};
    EXPECT_TRUE(pdfBytes(unknown));
    auto huge = small();
    for (auto& grid : huge.solve.grids)
        for (auto& p : grid.points) p.total.value *= 1e12;
    EXPECT_TRUE(pdfBytes(huge));
    auto equal = small();
    for (auto& grid : equal.solve.grids)
        for (auto& p : grid.points) p.total.value = 0;
    EXPECT_TRUE(pdfBytes(equal));
}

TEST(ReportPdf, LongTablesGoOnOverPages) {
    auto contents = small();
    const auto grid = contents.solve.grids[2];
    contents.solve.grids.assign(60, grid);
    const auto pdf = pdfBytes(contents);
    ASSERT_TRUE(pdf);
    EXPECT_GE(pagesOf(*pdf), 60 + 4 + 4);  // one a surface; the summary's 180 rows fill several
}

TEST(ReportPdf, RefusesAPictureThatIsNone) {
    auto contents = example::office();
    contents.views[1].png = "not a picture";
    const auto pdf = pdfBytes(contents);
    ASSERT_FALSE(pdf);
    EXPECT_EQ(pdf.error().code, ErrorCode::InvalidArgument);
    EXPECT_THAT(pdf.error().text(), HasSubstr("From the door, as a camera sees it"));
}

TEST_F(ReportFiles, AFullDiskIsAnErrorAndKeepsTheOldFile) {
    if (std::filesystem::exists("/dev/full")) {
        const auto written = writePdf(small(), "/dev/full");
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code, ErrorCode::OutOfResources);
    }
    const auto path = folder / "missing" / "report.pdf";
    EXPECT_FALSE(writePdf(small(), path));
    ASSERT_TRUE(writeFileAtomically(folder / "old.pdf", std::string_view("old")));
    auto bad = example::office();
    bad.views[0].png.clear();
    EXPECT_FALSE(writePdf(bad, folder / "old.pdf"));
    EXPECT_EQ(*readFile(folder / "old.pdf"), "old");
}

/// A box of 4 x 3 x 2.5 m, each wall two triangles, far from the origin.
Scene boxRoom() {
    Scene scene;
    scene.origin = {1e6, 0, 100};
    scene.objects = {{"walls", false}, {"desk", true}};
    Mesh walls, desk;
    const auto box = [](Mesh& mesh, Vec3 lo, Vec3 hi) {
        for (int i = 0; i < 8; ++i)
            mesh.positions.push_back({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
        for (const auto& q : std::array<std::array<std::uint32_t, 4>, 6>{
                 {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}}) {
            mesh.triangles.push_back({q[0], q[1], q[2]});
            mesh.triangles.push_back({q[0], q[2], q[3]});
        }
    };
    box(walls, {0, 0, 0}, {4, 3, 2.5F});
    box(desk, {1, 1, 0}, {2.6F, 1.8F, 0.74F});
    desk.object = 1;
    scene.meshes = {walls, desk};
    scene.materials = {Material{}};
    return scene;
}

TEST(PlanSection, JoinsTheTrianglesOfAWallAndDrawsFurnitureBelowTheCut) {
    const auto segments = planSection(boxRoom(), 101.2);
    double solid = 0, furniture = 0;
    int solids = 0;
    for (const auto& s : segments) {
        const double length = std::hypot(s.x1 - s.x0, s.y1 - s.y0);
        if (s.line == PlanLine::Solid) solid += length, ++solids;
        if (s.line == PlanLine::Furniture) furniture += length;
        EXPECT_GE(std::min(s.x0, s.x1), 1e6 - 1e-6);
    }
    EXPECT_EQ(solids, 4);
    // Vertices are floats of a few metres: rounding is below 1e-6 m each.
    EXPECT_NEAR(solid, 14, 1e-5);
    EXPECT_NEAR(furniture, 2 * (1.6 + 0.8), 1e-5);
}

TEST(PlanSection, OfNothingIsEmpty) {
    EXPECT_TRUE(planSection(Scene{}, 1).empty());
    EXPECT_TRUE(planSection(boxRoom(), 1).empty()) << "the cut is 99 m below the room";
}

TEST(ReportGather, FindsTheFloorByItsName) {
    auto scene = boxRoom();
    EXPECT_FALSE(floorArea(scene).has_value());
    scene.objects[0].name = "Floor slab";
    // Top and bottom of the box are level, 12 m^2 each; only one side counts. Float vertices: 1e-6 relative.
    EXPECT_NEAR(*floorArea(scene), 12, 1e-4);
}

}  // namespace
}  // namespace luxdeck

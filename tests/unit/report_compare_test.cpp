#include "analysis/compare/compare_output.h"
#include "analysis/report/compare_plot.h"
#include "analysis/report/pdf_writer.h"
#include "analysis/report/report_json.h"
#include "tests/support/example_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

/// What is drawn of a comparison, and that it reads and writes as the same.
namespace luxdeck {
namespace {

using ::testing::HasSubstr;

/// `path` falls as noise does, `cache` to a floor of 2 %; the last run of `path` is below the reference.
Comparison example(int algorithms = 2) {
    Comparison c;
    c.project = "Example", c.seed = 1, c.threads = 2, c.repetitions = 4, c.version = "0";
    c.reference.push_back({"grids", false, 0, 0, 4, "shared", 0.01, 0.01, 4096, 3, false});
    c.grids.push_back({"Desk", 2, 2, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}});
    for (int a = 0; a < algorithms; ++a) {
        const auto name = a == 0 ? "path" : a == 1 ? "cache" : "other_" + std::to_string(a);
        c.algorithms.push_back({name, a == 1 ? 0.02 : 0.0, true, ""});
        for (int rung = 0; rung < 5; ++rung) {
            ComparedRun run;
            run.subject = "grids", run.algorithm = name, run.rung = rung, run.seconds = std::ldexp(0.1, rung), run.samples = 32;
            const double noise = 0.1 * std::pow(2.0, -0.5 * rung);
            run.rms = a == 1 ? std::hypot(0.02, 0.3 * noise) : noise;
            run.rmsCi95 = 0.1 * *run.rms, run.rmsAtMost = 1.1 * *run.rms, run.max = 3 * *run.rms, run.p99 = 2 * *run.rms;
            if (a == 1) run.bias = 0.02, run.biasCi95 = 0.001;
            if (a == 0 && rung == 4) run.rms.reset(), run.rmsAtMost = 0.006;
            c.runs.push_back(run);
        }
        c.maps.push_back({"grids", name, "Desk", 2, 2, {0.01, -0.02, 0.5, 0}});
    }
    summarize(c);
    return c;
}

TEST(ReportCompare, ReadsWhatItWrites) {
    const auto json = compareJson(example());
    const auto read = readCompareJson(json, "c.json");
    ASSERT_TRUE(read) << (read ? "" : read.error().text());
    EXPECT_EQ(compareJson(*read), json);
    EXPECT_FALSE(read->runs[4].rms.has_value());
    const auto wrong = readCompareJson("{\"schema\":\"luxdeck-compare/1\"}", "c.json");
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.error().text(), HasSubstr("c.json: not a comparison"));
}

// Bug: the sizes of a grid's places and the finiteness of times and errors were taken on trust. Invariant: what readCompareJson()
// lets pass can be drawn. Plans read as many x, y and z as there are errors, beyond the end of lists that were shorter; an infinite
// time (null in the file) made an axis of endlessly many ticks.
TEST(ReportCompare, RefusesWhatCouldNotBeDrawn) {
    const auto refused = [](const Comparison& c) {
        const auto read = readCompareJson(compareJson(c), "c.json");
        return read ? std::string("let pass") : read.error().text();
    };
    auto c = example();
    c.grids[0].y.pop_back();
    EXPECT_THAT(refused(c), HasSubstr("grid \"Desk\" of 2 x 2 points has 4 x, 3 y and 4 z"));
    for (double ComparedRun::* field : {&ComparedRun::seconds, &ComparedRun::rmsAtMost}) {
        c = example();
        c.runs[1].*field = std::numeric_limits<double>::infinity();
        EXPECT_THAT(refused(c), HasSubstr("rung 1, is inf"));
        c.runs[1].*field = -1;
        EXPECT_THAT(refused(c), HasSubstr("rung 1, is -1"));
    }
    c = example();
    c.maps[0].columns = 3;
    EXPECT_THAT(refused(c), HasSubstr("a map of 3 x 2 has 4 errors"));
}

TEST(ReportCompare, SummaryOfKnownCurves) {
    const auto c = example();
    const auto path = std::find_if(c.slopes.begin(), c.slopes.end(), [](const auto& s) { return s.algorithm == "path"; });
    EXPECT_NEAR(path->slope, -0.5, 1e-9);
    EXPECT_EQ(path->runs, 4);
    ASSERT_EQ(c.order.size(), 2U);
    EXPECT_EQ(c.order[0].algorithm, "cache");
    EXPECT_NEAR(c.order[0].seconds, 0.8, 1e-12);  // where the last run of path ended whose error is known
}

TEST(ReportCompare, PlotsAreOfTheirKindAndTheSameEachTime) {
    for (const int algorithms : {1, 2, 12}) {
        const auto c = example(algorithms);
        const auto svg = comparePlot(c, "grids", SheetFormat::Svg), pdf = comparePlot(c, "grids", SheetFormat::Pdf), png = errorPlans(c, SheetFormat::Png);
        ASSERT_TRUE(svg && pdf && png);
        EXPECT_THAT(*svg, HasSubstr("<svg"));
        EXPECT_TRUE(pdf->starts_with("%PDF"));
        EXPECT_TRUE(png->starts_with("\x89PNG"));
        EXPECT_EQ(*comparePlot(c, "grids", SheetFormat::Pdf), *pdf);
        EXPECT_EQ(*comparePlot(c, "grids", SheetFormat::Svg), *svg);
    }
    EXPECT_FALSE(comparePlot(example(), "no such view", SheetFormat::Svg));
}

TEST(ReportCompare, NothingToPlotIsSaid) {
    auto c = example();
    c.runs.clear(), c.maps.clear();
    summarize(c);
    EXPECT_TRUE(comparePlot(c, "grids", SheetFormat::Svg));
    EXPECT_TRUE(errorPlans(c, SheetFormat::Svg));
    EXPECT_TRUE(c.order.empty());
    EXPECT_EQ(c.timeTo.front().time.how, Reached::NotReached);
}

TEST(ReportCompare, ItsPagesComeBackFromTheTwin) {
    auto contents = example::office();
    const auto without = pdfBytes(contents);
    contents.comparison = compareJson(example());
    const auto with = pdfBytes(contents);
    ASSERT_TRUE(without && with);
    EXPECT_GT(with->size(), without->size());
    const auto again = fromJson(*toJson(contents));
    ASSERT_TRUE(again);
    EXPECT_EQ(*pdfBytes(*again), *with);
    contents.comparison = "no JSON";
    EXPECT_FALSE(pdfBytes(contents)) << "a comparison that is none";
}

TEST(ReportCompare, ErrorPicturesShowTheSign) {
    const auto picture = errorPicture({"view", "path", "", 2, 1, {-1, 1}}, 0.5, "path");
    ASSERT_TRUE(picture);
    const auto at = [&](int x, int channel) { return picture->rgb[static_cast<std::size_t>(3 * (10 * picture->width + x) + channel)]; };
    EXPECT_GT(at(10, 2), at(10, 0));    // blue: too dark
    EXPECT_GT(at(490, 0), at(490, 2));  // red: too bright
    EXPECT_FALSE(errorPicture({"view", "path", "", 0, 0, {}}, 0.5, "path"));
}

}  // namespace
}  // namespace luxdeck

#include "engine/io/wea.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace luxdeck::test {
namespace {

using testing::HasSubstr;

std::string corpus(const std::string& file) {
    std::ifstream in(std::string(LUXDECK_SOURCE_DIR) + "/tests/fuzz/corpus/" + file);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    const auto at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
}

TEST(Epw, HoursAreNamedByTheirEndAndEastIsPositive) {
    const auto w = readEpw(corpus("epw/two_rows.epw"), "a.epw");
    ASSERT_TRUE(w) << w.error().text();
    EXPECT_EQ(w->place, "Testville");
    EXPECT_EQ(w->site.longitudeDeg, 4.77);
    EXPECT_EQ(w->site.timeZoneHours, 1);
    ASSERT_EQ(w->rows.size(), 2U);
    EXPECT_EQ(w->rows[0].middle.hour, 13.5);
    EXPECT_EQ(w->rows[0].middle.year, 1999);
    EXPECT_EQ(w->rows[0].directNormalWm2, 550);
    EXPECT_EQ(w->rows[0].diffuseHorizontalWm2, 250);
    EXPECT_EQ(w->rows[0].dewPointC, 12.5);
    EXPECT_FALSE(w->rows[1].directNormalWm2);
    EXPECT_FALSE(w->rows[1].dewPointC);
    EXPECT_EQ(w->at(6, 21, 13.2), &w->rows[0]);
    EXPECT_EQ(w->at(6, 21, 14), &w->rows[0]);
    EXPECT_EQ(w->at(6, 21, 14.1), &w->rows[1]);
    EXPECT_EQ(w->at(6, 21, 12.9), nullptr);
    EXPECT_EQ(w->at(6, 22, 14), nullptr);
}

TEST(Epw, QuartersOfAnHour) {
    const auto w = readEpw(corpus("epw/quarters.epw"), "a.epw");
    ASSERT_TRUE(w) << w.error().text();
    EXPECT_EQ(w->rows[0].middle.hour, 13.125);   // the quarter that ends 13:15
    EXPECT_EQ(w->rows[1].middle.hour, 13.375);
}

TEST(Epw, RefusalsNameLineAndField) {
    const auto good = corpus("epw/two_rows.epw");
    const auto refused = [&](const std::string& old, const std::string& by) {
        const auto w = readEpw(replaced(good, old, by), "a.epw");
        EXPECT_FALSE(w);
        return w ? std::string() : w.error().text();
    };
    EXPECT_THAT(refused("LOCATION", "PLACE"), HasSubstr("a.epw:1: begins with"));
    EXPECT_THAT(refused("52.30", "95"), HasSubstr("a.epw:1: field 7"));
    EXPECT_THAT(refused("DATA PERIODS,1,1", "DATA PERIODS,1,0"), HasSubstr("a.epw:8: field 3"));
    EXPECT_FALSE(readEpw("", "a.epw"));
}

/// The bug: one field that is no number refused the whole year, though only its hour needs it.
TEST(Epw, ABadFieldCostsItsHourAlone) {
    const auto good = corpus("epw/two_rows.epw");
    const auto bright = readEpw(replaced(good, ",550,250,", ",x,250,"), "a.epw");
    ASSERT_TRUE(bright) << bright.error().text();
    ASSERT_EQ(bright->rows.size(), 2U);
    EXPECT_THAT(bright->rows[0].fault, HasSubstr("a.epw:9: field 15 is \"x\", expected the direct normal irradiance"));
    EXPECT_FALSE(bright->rows[0].directNormalWm2);
    EXPECT_TRUE(bright->rows[1].fault.empty());

    const auto undated = readEpw(replaced(good, "1999,6,21,15", "1999,13,21,15"), "a.epw");
    ASSERT_TRUE(undated) << undated.error().text();
    ASSERT_EQ(undated->undated.size(), 1U);
    EXPECT_EQ(undated->undated[0].line, 10U);
    EXPECT_THAT(undated->undated[0].fault, HasSubstr("a.epw:10: field 2 is \"13\""));
    EXPECT_NE(undated->at(6, 21, 13.5), nullptr);
    EXPECT_EQ(undated->at(6, 21, 14.5), nullptr);

    auto none = replaced(good, "1999,6,21,14", "1999,6,x,14");
    none = replaced(none, "1999,6,21,15", "1999,6,x,15");
    EXPECT_THAT(readEpw(none, "a.epw").error().text(), HasSubstr("no row has a date and an hour: a.epw:9: field 3"));
}

TEST(Epw, IsTextAsProgramsWriteIt) {
    auto text = replaced(corpus("epw/two_rows.epw"), "Testville", "Orl\xE9""ans");  // ISO 8859-1
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : corpus("epw/two_rows.epw")) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(readEpw(text, "a.epw")->place, "Orl\xC3\xA9""ans");
    EXPECT_EQ(readEpw(windows, "a.epw")->rows.size(), 2U);
    EXPECT_EQ(readWeatherFile(windows, "A.WEATHER")->rows.size(), 2U);
    EXPECT_EQ(readWeatherFile(corpus("wea/hourly.wea"), "hourly.epw")->rows.size(), 2U) << "what it holds counts";
    EXPECT_THAT(readWeatherFile("hello", "a.epw").error().text(), HasSubstr("a.epw:1: begins with \"hello\""));
}

/// Daysim's years of ten minutes count from 0.583 to 24.417.
TEST(Wea, HoursAfterMidnightAreTheNextDays) {
    const auto good = corpus("wea/hourly.wea");
    const auto header = good.substr(0, good.find("6 21 13.500"));
    std::string rows;
    for (const char* day : {"2 28", "12 31"})
        for (const char* hour : {"23.917", "24.083", "24.250", "24.417"}) rows += fmt::format("{} {} 10 20\n", day, hour);
    const auto w = readWea(header + rows, "a.wea");
    ASSERT_TRUE(w) << w.error().text();
    EXPECT_NEAR(w->rows[0].intervalHours, 1.0 / 6, 1e-12);
    EXPECT_EQ(w->at(2, 28, 23.95), &w->rows[0]);
    EXPECT_EQ(w->at(3, 1, 0.1), &w->rows[1]);
    EXPECT_EQ(w->at(3, 1, 0.45), &w->rows[3]);
    EXPECT_EQ(w->at(1, 1, 0.2), &w->rows[6]) << "the year's last is its first morning";
    EXPECT_EQ(w->at(1, 1, 0.0), &w->rows[5]);
    EXPECT_EQ(w->at(3, 1, 0.6), nullptr);
    // Written with three digits, intervals of ten minutes miss each other by seconds: no moment between them is lost.
    for (double hour = 0.001; hour < 0.499; hour += 0.0007) EXPECT_NE(w->at(3, 1, hour), nullptr) << hour;
    const auto late = readWea(header + rows + "6 21 24.6 0 0\n6 21 12 x 0\n", "a.wea");
    ASSERT_EQ(late->undated.size(), 1U);
    EXPECT_THAT(late->undated[0].fault, HasSubstr("a.wea:15: field 3 is \"24.6\", expected the hour: 0 .. 24.5"));
    EXPECT_THAT(late->rows.back().fault, HasSubstr("a.wea:16: field 4 is \"x\""));
}

TEST(Wea, WestIsPositiveAndHoursAreMiddles) {
    const auto w = readWea(corpus("wea/hourly.wea"), "a.wea");
    ASSERT_TRUE(w) << w.error().text();
    EXPECT_EQ(w->site.longitudeDeg, 4.77);
    EXPECT_EQ(w->site.timeZoneHours, 1);
    ASSERT_EQ(w->rows.size(), 2U);
    EXPECT_EQ(w->rows[0].middle.hour, 13.5);
    EXPECT_EQ(w->at(6, 21, 14.5), &w->rows[1]);
    EXPECT_EQ(readWea(corpus("wea/half_hours.wea"), "b.wea")->rows[0].intervalHours, 0.5);
    EXPECT_THAT(readWea(replaced(corpus("wea/hourly.wea"), "longitude", "lon"), "a.wea").error().text(), HasSubstr("a.wea:3: is"));
    EXPECT_THAT(readWea(replaced(corpus("wea/hourly.wea"), "550", ""), "a.wea")->rows[0].fault, HasSubstr("a.wea:7: field 5"));
}

}  // namespace
}  // namespace luxdeck::test

#include "engine/io/wea.h"

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
    EXPECT_THAT(refused(",550,250,", ",x,250,"), HasSubstr("a.epw:9: field 15"));
    EXPECT_THAT(refused("1999,6,21,15", "1999,13,21,15"), HasSubstr("a.epw:10: field 2"));
    EXPECT_FALSE(readEpw("", "a.epw"));
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
    EXPECT_THAT(readWea(replaced(corpus("wea/hourly.wea"), "550", ""), "a.wea").error().text(), HasSubstr("a.wea:7: is"));
}

}  // namespace
}  // namespace luxdeck::test

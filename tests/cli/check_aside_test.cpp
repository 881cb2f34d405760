#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

/// `luxdeck check` of files that are no project, scene or photometry: what they are and where they belong.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kWea = "place Here\nlatitude 50\nlongitude -5\ntime_zone -15\nsite_elevation 0\n"
                             "weather_data_file_units 1\n6 21 13.5 500 200\n6 21 14.5 x 200\n";

TEST(CheckAside, WeatherIsToldWithItsFaultsAndItsPlace) {
    const Scratch scratch;
    scratch.write("My Year.WEA", kWea);
    const auto result = scratch.run({"check", "My Year.WEA"});
    EXPECT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("weather = \"My Year.WEA\""));
    EXPECT_THAT(result.err, HasSubstr("My Year.WEA:8: field 4 is \"x\""));
    EXPECT_THAT(result.err, HasSubstr("06-21 14 h to 15 h cannot be used"));
    const auto json = scratch.json({"check", "My Year.WEA", "--json"});
    EXPECT_EQ(json["files"][0]["kind"], "weather");
    EXPECT_EQ(json["files"][0]["facts"]["rowsUnusable"], 1);
    scratch.write("year.txt", kWea);
    EXPECT_EQ(scratch.run({"check", "year.txt"}).exitStatus, 0) << "what it holds counts";
    scratch.write("bad.wea", "place Here\nlatitude 95\nlongitude -5\ntime_zone -15\nsite_elevation 0\nx\n");
    const auto bad = scratch.run({"check", "bad.wea"});
    EXPECT_EQ(bad.exitStatus, 3);
    EXPECT_THAT(bad.err, HasSubstr("bad.wea:2"));
}

TEST(CheckAside, PicturesAndLibrariesSayWhereTheyBelong) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run({"render", "project.toml", "-o", "v.exr", "--samples", "1"}).exitStatus, 0);
    EXPECT_THAT(scratch.run({"check", "v.exr"}).out, HasSubstr("luxdeck tonemap v.exr"));
    scratch.write("v.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + std::string("\x80\x80\x80\x81\x80\x80\x80\x81", 8));
    const auto json = scratch.json({"check", "v.hdr", "--json"});
    EXPECT_EQ(json["files"][0]["facts"]["width"], 2);
    EXPECT_THAT(scratch.run({"check", "room.mtl"}).out, HasSubstr("mtllib room.mtl"));
    scratch.write("cut.hdr", "#?RADIANCE\n");
    EXPECT_EQ(scratch.run({"check", "cut.hdr"}).exitStatus, 3);
}

TEST(CheckAside, WhatIsNotReadSaysWhatToDo) {
    const Scratch scratch;
    scratch.writeRoom();
    scratch.write("house.ifc", "ISO-10303-21;\n");
    auto result = scratch.run({"check", "house.ifc"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, HasSubstr("export the model as glTF"));
    scratch.write("what.bin", std::string("\0\1\2\3", 4));
    EXPECT_THAT(scratch.run({"check", "what.bin"}).err, HasSubstr("is no file that is read: expected project.toml"));
    EXPECT_THAT(scratch.run({"check", "none.epw"}).err, HasSubstr("none.epw"));
    result = scratch.run({"check", "project.toml", "room.mtl"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, HasSubstr("room.mtl"));
}

}  // namespace
}  // namespace luxdeck::test

#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// What the program's exit status and messages say.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

TEST(ExitStatus, OkWhenAllIsWell) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto result = scratch.run({"solve", "project.toml", "--samples", "64", "--quiet"});
    EXPECT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("floor"));
}

TEST(ExitStatus, OneWhenARequirementIsNotMet) {
    const Scratch scratch;
    scratch.writeRoom("mean_lux = 100000");
    const auto result = scratch.run({"solve", "project.toml", "--samples", "64"});
    EXPECT_EQ(result.exitStatus, 1) << result.err;
    EXPECT_THAT(result.out, HasSubstr("not met"));
}

TEST(ExitStatus, ZeroWhenARequirementIsMet) {
    const Scratch scratch;
    scratch.writeRoom("mean_lux = 1");
    const auto result = scratch.run({"solve", "project.toml", "--samples", "64"});
    EXPECT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr(": met"));
}

TEST(ExitStatus, TwoForUsage) {
    const Scratch scratch;
    scratch.writeRoom();
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{}, "Usage"},
        {{"nonsense"}, "nonsense"},
        {{"solve"}, "project is required"},
        {{"solve", "project.toml", "--target-error", "abc"}, "expected a percentage"},
        {{"solve", "project.toml", "--target-error", "-2%"}, "expected more than 0"},
        {{"solve", "project.toml", "--target-error", "nan"}, "expected more than 0"},
        {{"solve", "project.toml", "--time", "5 weeks"}, "expected seconds"},
        {{"solve", "project.toml", "--time", "inf"}, "expected seconds"},
        {{"solve", "project.toml", "--samples", "0"}, "--samples"},
        {{"solve", "project.toml", "--threads", "-1"}, "--threads"},
        {{"solve", "project.toml", "--seed", "-1"}, "--seed"},
        {{"solve", "project.toml", "--algorithm", "magic"}, "path"},
        {{"render", "project.toml"}, "--output is required"},
        {{"render", "project.toml", "-o", "picture.png"}, "ends in .exr"},
        {{"render", "project.toml", "-o", "f.exr", "--size", "64"}, "--size"},
        {{"render", "project.toml", "-o", "f.exr", "--size", "0", "9"}, "--size"},
        {{"tonemap", "f.exr", "-o", "f.jpg"}, "ends in .png"},
        {{"tonemap", "f.exr", "-o", "f.png", "--operator", "warm"}, "human"},
        {{"sense", "project.toml", "--radiance", "--irradiance"}, "--radiance"},
        {{"sense", "project.toml", "--cylindrical", "--irradiance"}, "--irradiance"},
    };
    for (const auto& [arguments, expected] : cases) {
        const auto result = scratch.run(arguments);
        EXPECT_EQ(result.exitStatus, 2) << expected << "\n" << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_THAT(result.err, HasSubstr(expected));
    }
}

TEST(ExitStatus, ThreeForInputThatIsNotThere) {
    const Scratch scratch;
    for (const std::string command : {"check", "solve", "sense"}) {
        const auto result = scratch.run({command, "nowhere.toml"});
        EXPECT_EQ(result.exitStatus, 3);
        EXPECT_THAT(result.err, HasSubstr("nowhere.toml: no such file"));
    }
}

TEST(ExitStatus, FourWhenTheTimeIsTooShortForTheError) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto result = scratch.run({"solve", "project.toml", "--target-error", "0.0001%", "--time", "0.2", "--json"});
    EXPECT_EQ(result.exitStatus, 4) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_TRUE(json["complete"].get<bool>());  // it was not interrupted: it did what it was told
    EXPECT_FALSE(json["targetReached"].get<bool>());
}

TEST(ExitStatus, RefusesAnOutputThatCannotBeBeforeItWorks) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto missing = scratch.run({"render", "project.toml", "-o", "no/such/folder/f.exr", "--samples", "1000000"});
    EXPECT_EQ(missing.exitStatus, 3);
    EXPECT_THAT(missing.err, HasSubstr("no folder no/such/folder"));
    const auto folder = scratch.run({"solve", "project.toml", "-o", ".", "--samples", "1000000"});
    EXPECT_EQ(folder.exitStatus, 3);
    EXPECT_THAT(folder.err, HasSubstr("is a folder"));
}

TEST(ExitStatus, SaysWhenASceneHasNoGridAndNoView) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto result = scratch.run({"solve", "room.obj"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, HasSubstr("has no calculation grid"));
}

TEST(ExitStatus, WarnsOfASceneWithoutLight) {
    const Scratch scratch;
    scratch.writeRoom();
    EXPECT_THAT(scratch.run({"check", "room.obj"}).err, HasSubstr("no light"));
    EXPECT_THAT(scratch.run({"render", "room.obj", "-o", "f.exr", "--samples", "1", "--size", "8", "8"}).err, HasSubstr("no light"));
    EXPECT_THAT(scratch.json({"check", "room.obj", "--json"})["warnings"].dump(), HasSubstr("no light"));
    EXPECT_EQ(scratch.json({"check", "project.toml", "--json"})["warnings"].size(), 0U);
}

TEST(ExitStatus, NamesThatAreNotUtf8AreNoReasonToFail) {
    const Scratch scratch;
    scratch.writeRoom();
    std::filesystem::copy_file(scratch.path("room.obj"), scratch.path("r\xff.obj"));
    const auto json = scratch.json({"check", "--json", "r\xff.obj"});
    EXPECT_FALSE(json.is_discarded());
}

}  // namespace
}  // namespace luxdeck::test

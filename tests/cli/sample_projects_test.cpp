#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

/// The sample projects, as a user has them: they load without a warning, and their light is of the size that the lumen
/// method says and within what their own texts promise.
namespace luxdeck::test {
namespace {

using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

std::string sample(const std::string& name) { return std::string(LUXDECK_SOURCE_DIR) + "/projects/" + name + "/project.toml"; }

/// Few paths: a mean over eight points or more is then known to a few percent. Its own interval is allowed for below.
Json solved(const std::string& name, const std::string& samples = "64") {
    const Scratch scratch;
    // Unmet requirements are an exit status of their own: the JSON is looked at in any case.
    const auto result = scratch.run({"solve", sample(name), "--samples", samples, "--json", "--quiet"});
    EXPECT_LE(result.exitStatus, 1) << result.err;
    return Json::parse(result.out, nullptr, false);
}

class SampleProject : public ::testing::TestWithParam<const char*> {};

TEST_P(SampleProject, LoadsWithoutAWarning) {
    const Scratch scratch;
    const auto json = scratch.json({"check", "--json", sample(GetParam())});
    ASSERT_FALSE(json.is_discarded());
    EXPECT_THAT(json["warnings"].get<std::vector<std::string>>(), IsEmpty());
    EXPECT_GT(json["triangles"].get<int>(), 30000);
    EXPECT_GT(json["lumens"].get<double>(), 0);
    EXPECT_GE(json["views"].get<int>(), 4);
}

/// Every mean lies between nothing and ten times its limit, and no point lies inside a thing (it would read 0 lx).
TEST_P(SampleProject, NoPointIsBuried) {
    const auto json = solved(GetParam());
    ASSERT_FALSE(json.is_discarded());
    for (const auto& grid : json["grids"]) {
        EXPECT_GT(grid["min"]["value"].get<double>(), 0) << grid["name"];
        const auto& required = grid["mean"]["required"];
        if (required.is_null()) continue;
        EXPECT_LT(grid["mean"]["value"].get<double>(), 10 * required.get<double>()) << grid["name"];
    }
}

/// What each view shows is neither black nor without end.
TEST_P(SampleProject, RendersItsFirstView) {
    const Scratch scratch;
    const auto result = scratch.run({"render", sample(GetParam()), "-o", "view.exr", "--samples", "2", "--size", "60", "40", "--json", "--quiet"});
    EXPECT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_TRUE(scratch.has("view.exr"));
}

INSTANTIATE_TEST_SUITE_P(Projects, SampleProject, ::testing::Values("office", "classroom", "gallery"),
                         [](const auto& name) { return std::string(name.param); });

const Json& gridOf(const Json& json, const std::string& name) {
    for (const auto& grid : json["grids"])
        if (grid["name"] == name) return grid;
    ADD_FAILURE() << "no grid " << name;
    return json;
}

/// Lumen method: desks get the lamps' maintained lumens over the floor's 64.8 m^2 times a utilance of 0.5 to 1.3 (direct
/// light concentrates over the desks), and from the sky at most what fills the room evenly. The windows let in
/// 0.65 x 11 m^2 x 9500 lx (half the sky, the veiled sun at 62 degrees off the facade and the ground) = 68 klm; the room's
/// 229 m^2 of surface absorb about 0.35 of what falls on them: 68000 / (229 x 0.35) = 850 lx.
TEST(Classroom, DesksAgreeWithTheLumenMethod) {
    const Scratch scratch;
    const auto check = scratch.json({"check", "--json", sample("classroom")});
    const auto json = solved("classroom");
    ASSERT_FALSE(check.is_discarded() || json.is_discarded());
    const double lampsLux = check["lumens"].get<double>() / (9.0 * 7.2);
    for (const char* name : {"Desks at the windows", "Desks in the middle", "Desks at the corridor"}) {
        const double mean = gridOf(json, name)["mean"]["value"];
        EXPECT_GT(mean, 0.5 * lampsLux) << name;
        EXPECT_LT(mean, 1.3 * lampsLux + 850) << name;
    }
    // The sky is on one side: the means fall from the windows inwards, though lamps there are dimmed most.
    EXPECT_GT(gridOf(json, "Desks at the windows")["mean"]["value"].get<double>(), gridOf(json, "Desks at the corridor")["mean"]["value"].get<double>());
}

/// The limits that the requirements' names state; a mean may lie beyond by its own interval.
TEST(Gallery, WorksAreSeenAndSpared) {
    const auto json = solved("gallery", "256");
    ASSERT_FALSE(json.is_discarded());
    const std::pair<const char*, double> mostLux[]{{"Oil painting", 200}, {"Work on paper", 50}, {"Textile", 50}, {"Photograph", 150}};
    int works = 0;
    for (const auto& grid : json["grids"])
        for (const auto& [kind, most] : mostLux)
            if (grid["name"].get<std::string>().starts_with(kind)) {
                ++works;
                const double mean = grid["mean"]["value"], ci95 = grid["mean"]["ci95"];
                EXPECT_LE(mean - ci95, most) << grid["name"];
                EXPECT_GE(mean + ci95, grid["mean"]["required"].get<double>()) << grid["name"];
            }
    EXPECT_EQ(works, 12);
}

/// Lumen method from above: no floor gets more, evenly, than all lumens over its 90 m^2.
TEST(Gallery, FloorGetsNoMoreThanTheLamps) {
    const Scratch scratch;
    const auto check = scratch.json({"check", "--json", sample("gallery")});
    const auto json = solved("gallery");
    ASSERT_FALSE(check.is_discarded() || json.is_discarded());
    EXPECT_LT(gridOf(json, "Floor, where visitors walk")["mean"]["value"].get<double>(), check["lumens"].get<double>() / (12.0 * 7.5));
}

}  // namespace
}  // namespace luxdeck::test

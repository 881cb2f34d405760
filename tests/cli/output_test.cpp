#include "engine/io/image_files.h"
#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// What scripts and people get: JSON keys, --help, the manual, pictures.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

void expectKeys(const Json& json, const std::map<std::string, std::string>& types) {
    ASSERT_TRUE(json.is_object()) << json.dump().substr(0, 200);
    for (const auto& [key, type] : types) {
        ASSERT_TRUE(json.contains(key)) << key;
        EXPECT_EQ(std::string(json[key].type_name()), type) << key;
    }
}

TEST(JsonKeys, CheckOfAProject) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto json = scratch.json({"check", "project.toml", "--json"});
    expectKeys(json, {{"schema", "string"}, {"triangles", "number"}, {"luminaires", "number"}, {"materials", "number"}, {"bounds", "array"},
                      {"needs", "object"}, {"leftOut", "array"}, {"warnings", "array"}});
    EXPECT_EQ(json.begin().key(), "schema");
    EXPECT_EQ(json["triangles"], 12);
    EXPECT_EQ(json["bounds"], Json::parse("[[0,0,0],[4,5,3]]"));
    for (const auto& left : json["leftOut"]) expectKeys(left, {{"what", "string"}, {"why", "string"}});
}

TEST(JsonKeys, CheckOfALuminaire) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto json = scratch.json({"check", "lamp.ies", "--json"});
    expectKeys(json, {{"schema", "string"}, {"lumensDeclared", "number"}, {"lumensIntegrated", "number"}, {"photometry", "string"},
                      {"symmetry", "string"}, {"opening", "object"}, {"repairs", "array"}, {"warnings", "array"}});
    EXPECT_EQ(json.begin().key(), "schema");
}

TEST(JsonKeys, Solve) {
    const Scratch scratch;
    scratch.writeRoom("mean_lux = 10");
    const auto json = scratch.json({"solve", "project.toml", "--samples", "64", "--json", "--seed", "7"});
    expectKeys(json, {{"schema", "string"}, {"complete", "boolean"}, {"seconds", "number"}, {"samples", "number"}, {"algorithm", "string"},
                      {"seed", "number"}, {"grids", "array"}, {"leftOut", "array"}});
    EXPECT_EQ(json.begin().key(), "schema");
    EXPECT_EQ(json["seed"], 7);
    ASSERT_EQ(json["grids"].size(), 1U);
    const auto& grid = json["grids"][0];
    EXPECT_EQ(grid["name"], "floor");
    ASSERT_EQ(grid["points"].size(), 12U);
    for (const auto& point : grid["points"])
        for (const auto* key : {"x", "y", "z", "nx", "ny", "nz", "lx", "ci95", "direct", "indirect"}) EXPECT_TRUE(point[key].is_number()) << key;
    for (const auto* key : {"mean", "min", "uniformity"})
        for (const auto* part : {"value", "ci95", "required", "verdict"}) EXPECT_TRUE(grid[key].contains(part)) << key << " " << part;
    EXPECT_EQ(grid["mean"]["verdict"], "met");
}

TEST(JsonKeys, RenderAndTonemap) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto render = scratch.json({"render", "project.toml", "-o", "f.exr", "--samples", "2", "--json"});
    expectKeys(render, {{"schema", "string"}, {"output", "string"}, {"view", "string"}, {"complete", "boolean"}, {"seconds", "number"}});
    EXPECT_EQ(render.begin().key(), "schema");
    const auto tonemap = scratch.json({"tonemap", "f.exr", "-o", "f.png", "--json"});
    expectKeys(tonemap, {{"schema", "string"}, {"operator", "string"}, {"displayTransform", "string"}, {"curve", "array"}});
    EXPECT_EQ(tonemap.begin().key(), "schema");
}

TEST(Help, EachCommandNamesItsUnits) {
    const Scratch scratch;
    const std::map<std::string, std::vector<std::string>> units{{"check", {"lm", "cd"}}, {"solve", {"lx", "seconds"}}, {"sense", {"lx", "cd/m²"}},
                                                                {"render", {"lx", "cd/m²", "seconds"}}, {"tonemap", {"lx", "cd/m²"}}};
    for (const auto& [command, names] : units) {
        const auto result = scratch.run({command, "--help"});
        EXPECT_EQ(result.exitStatus, 0);
        EXPECT_EQ(result.err, "");
        for (const auto& name : names) EXPECT_THAT(result.out, HasSubstr(name)) << command;
        EXPECT_THAT(result.out, HasSubstr("Exit status"));
    }
    EXPECT_THAT(scratch.run({"sense", "--help"}).out, HasSubstr("blank line"));
}

TEST(Help, ManualIsCleanTroff) {
    const Scratch scratch;
    const auto manual = scratch.run({"--man"});
    EXPECT_EQ(manual.exitStatus, 0);
    EXPECT_TRUE(manual.out.starts_with(".TH LUXDECK 1"));
    for (const auto* section : {".SH NAME\n", ".SH SYNOPSIS\n", ".SH OPTIONS\n", ".SH COMMANDS\n", ".SH EXIT STATUS\n"})
        EXPECT_THAT(manual.out, HasSubstr(section));
    if (!std::filesystem::exists("/usr/bin/groff")) GTEST_SKIP() << "no groff to read the manual with";
    ProcessSettings groff;
    groff.arguments = {"/usr/bin/groff", "-K", "utf8", "-man", "-ww", "-z"};
    const auto result = runProcess(groff, manual.out);
    EXPECT_EQ(result.exitStatus, 0);
    if (result.err.find("preconv") == std::string::npos) {  // groff-base comes without it
        EXPECT_EQ(result.err, "");
    }
}

TEST(Pictures, SizeViewAndQuantity) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run({"render", "project.toml", "--view", "door", "--size", "40", "30", "--samples", "8", "-o", "l.exr"}).exitStatus, 0);
    const auto luminance = readHdrImage(scratch.path("l.exr"));
    ASSERT_TRUE(luminance);
    EXPECT_EQ(luminance->width(), 40);
    EXPECT_EQ(luminance->height(), 30);
    EXPECT_EQ(luminance->text.at("luxdeck:quantity"), "luminance");
    EXPECT_EQ(luminance->text.at("luxdeck:complete"), "true");
    ASSERT_EQ(scratch.run({"render", "project.toml", "--quantity", "illuminance", "--samples", "8", "-o", "e.exr"}).exitStatus, 0);
    const auto illuminance = readHdrImage(scratch.path("e.exr"));
    ASSERT_TRUE(illuminance);
    EXPECT_EQ(illuminance->text.at("luxdeck:unit"), "lx");
    const auto unknown = scratch.run({"render", "project.toml", "--view", "window", "-o", "x.exr"});
    EXPECT_EQ(unknown.exitStatus, 3);
    EXPECT_THAT(unknown.err, HasSubstr("expected one of: \"door\""));
    EXPECT_FALSE(scratch.has("x.exr"));
}

TEST(Pictures, EveryToneMapperWritesAPng) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run({"render", "project.toml", "--samples", "4", "-o", "f.exr"}).exitStatus, 0);
    const std::vector<std::vector<std::string>> ways{{"--operator", "human"}, {"--operator", "camera"}, {"--operator", "linear", "--exposure", "0.1"},
                                                     {"--isolines"}, {"--false-colour"}, {"--false-colour", "--isolines", "--linear-scale"},
                                                     {"--false-colour", "--map", "heat", "--range", "1", "1000"}, {"--no-veil", "--no-acuity", "--no-colour-loss"}};
    std::vector<std::string> seen;
    for (const auto& way : ways) {
        std::vector<std::string> arguments{"tonemap", "f.exr", "-o", "f.png"};
        arguments.insert(arguments.end(), way.begin(), way.end());
        const auto result = scratch.run(arguments);
        EXPECT_EQ(result.exitStatus, 0) << result.err;
        EXPECT_TRUE(scratch.read("f.png").starts_with("\x89PNG")) << way[0];
    }
    for (const std::vector<std::string>& range : {std::vector<std::string>{"100", "10"}, {"nan", "10"}, {"0", "10"}}) {
        const auto result = scratch.run({"tonemap", "f.exr", "-o", "g.png", "--false-colour", "--range", range[0], range[1]});
        EXPECT_TRUE(result.exitStatus == 2 || result.exitStatus == 3) << result.err;
        EXPECT_FALSE(scratch.has("g.png"));
    }
}

TEST(Pictures, OcioIsHonoured) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run({"render", "project.toml", "--samples", "4", "-o", "f.exr"}).exitStatus, 0);
    scratch.write("broken.ocio", "this is no config");
    for (const std::string name : {"broken.ocio", "nowhere.ocio"}) {
        const auto broken = scratch.run({"tonemap", "f.exr", "-o", "f.png"}, {{"OCIO", scratch.path(name).string()}});
        EXPECT_EQ(broken.exitStatus, 3);
        EXPECT_THAT(broken.err, HasSubstr(name));
        EXPECT_FALSE(scratch.has("f.png"));
    }
    if (sharedData().empty()) GTEST_SKIP() << "no ../shared/data";
    const auto config = sharedData() / "ocio" / "builtin-transforms-2.1.ocio";
    const auto own = scratch.run({"tonemap", "f.exr", "-o", "own.png", "--json"}, {{"OCIO", config.string()}});
    ASSERT_EQ(own.exitStatus, 0) << own.err;
    EXPECT_NE(Json::parse(own.out)["displayTransform"], scratch.json({"tonemap", "f.exr", "-o", "usual.png", "--json"})["displayTransform"]);
}

}  // namespace
}  // namespace luxdeck::test

#include "tests/cli/scratch.h"
#include "tests/support/json_schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

/// docs/schemas against what the program really prints. The list of commands is the manual's: a new command without a
/// run here, or a run whose output no schema describes, fails.
namespace luxdeck::test {
namespace {

using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// By the name in "schema", without its version.
std::map<std::string, Json> schemas() {
    std::map<std::string, Json> out;
    for (const auto& file : fs::directory_iterator(fs::path(LUXDECK_SOURCE_DIR) / "docs" / "schemas"))
        if (file.path().extension() == ".json") out[file.path().stem().stem().string()] = Json::parse(fileBytes(file.path()));
    return out;
}

std::set<std::string> commandsInTheManual(const Scratch& scratch) {
    std::set<std::string> out;
    std::istringstream manual(scratch.run({"--man"}).out);
    for (std::string row; std::getline(manual, row);)
        if (row.starts_with(".SS luxdeck ")) out.insert(std::regex_replace(row.substr(12), std::regex(R"(\\-)"), "-"));
    return out;
}

/// A run of a command, its arguments and what it reads.
struct Run {
    std::vector<std::string> arguments;
    std::string input;
    int exitStatus = 0;
};

const std::vector<Run>& runs() {
    static const std::vector<Run> all{
        {{"check", "project.toml"}},
        {{"check", "room.obj"}},
        {{"check", "lamp.ies"}},
        {{"check", "room.mtl"}},
        {{"check", "lamp.ies", "bad.ies"}, "", 3},
        {{"solve", "project.toml", "--samples", "64"}},
        {{"sense", "project.toml", "--samples", "64"}, "1 1 1 0 0 1\n"},
        {{"sense", "project.toml", "--samples", "64"}, "not six numbers\n", 3},
        {{"render", "project.toml", "-o", "f.exr", "--samples", "2"}},
        {{"tonemap", "f.exr", "-o", "f.png"}},
        {{"tonemap", "f.exr", "-o", "f.png", "--operator", "linear"}},
        {{"tonemap", "f.exr", "-o", "f.png", "--false-colour"}},
        {{"solve", "project.toml", "--samples", "64", "--by-luminaire", "--layers-out", "layers.json"}},
        {{"export", "project.toml", "-o", "exported"}},
        {{"compare", "project.toml", "--samples", "128", "--rungs", "3", "--repetitions", "3", "--algorithms", "path,direct", "--height", "8", "--reference-error", "20%",
          "--picture-reference-error", "90%", "-o", "compared", "--volumes"}},
        {{"validate", "--stability", "--algorithm", "direct"}},
        {{"validate", "--case", "5.2"}},
        {{"volume", "build", "project.toml", "-o", "a.vtu", "--grid", "3", "3", "3", "--bins", "5"}},
        {{"volume", "build", "project.toml", "-o", "b.vtu", "--grid", "3", "3", "3", "--bins", "5", "--samples", "1"}},
        {{"volume", "info", "a.vtu"}},
        {{"volume", "query", "a.vtu"}, "1 1 1 0 0 1\n"},
        {{"volume", "query", "a.vtu", "--scene", "project.toml"}, "not six numbers\n", 3},
        {{"volume", "diff", "a.vtu", "b.vtu", "-o", "c.vtu"}},
        {{"furniture", "project.toml", "--volume", "a.vtu", "--model", "room.obj", "--unit", "0.1", "--at", "2", "2.5", "0.5", "--required", "1"}},
        {{"furniture", "project.toml", "--volume", "a.vtu", "--model", "room.obj", "--unit", "0.1", "--at", "2", "2.5", "0.5", "--exact", "--full", "8", "--samples", "64", "-o", "f.ply"}},
        {{"shade", "project.toml", "--volume", "a.vtu", "--model", "room.obj", "--unit", "0.1", "--at", "2", "2.5", "0.5", "-o", "s.ply"}},
        {{"report", "project.toml", "-o", "r.pdf", "--samples", "64", "--view-time", "0.1"}},  // where the build has it
    };
    return all;
}

/// "solve" or "volume build".
std::string commandOf(const Run& run, const std::set<std::string>& commands) {
    const auto& a = run.arguments;
    return commands.contains(a[0] + " " + a[1]) ? a[0] + " " + a[1] : a[0];
}

TEST(Schemas, EveryOutputOfEveryCommandFitsItsSchema) {
    const Scratch scratch;
    scratch.writeRoom("mean_lux = 10");
    scratch.write("bad.ies", "nothing of the kind");
    const auto known = schemas();
    const auto commands = commandsInTheManual(scratch);
    std::set<std::string> seen;
    for (const auto& run : runs()) {
        if (!commands.contains(commandOf(run, commands))) continue;
        auto arguments = run.arguments;
        const auto name = arguments[0] + " " + arguments[1];
        arguments.insert(arguments.end(), {"--json", "--quiet"});
        const auto result = scratch.run(arguments, run.input);
        EXPECT_EQ(result.exitStatus, run.exitStatus) << name << result.err;
        const auto json = Json::parse(result.out, nullptr, false);
        ASSERT_FALSE(json.is_discarded()) << name << "\n" << result.out.substr(0, 300);
        ASSERT_EQ(json.begin().key(), "schema") << name;
        const auto schema = json["schema"].get<std::string>();
        const auto stem = schema.substr(8, schema.find('/') - 8);  // of "luxdeck-NAME/1"
        ASSERT_TRUE(known.contains(stem)) << name << ": no docs/schemas/" << stem << ".schema.json";
        EXPECT_THAT(complaintsOf(json, known.at(stem)), IsEmpty()) << name;
        seen.insert(stem);
    }
    for (const auto& [stem, unused] : known) EXPECT_TRUE(seen.contains(stem) || !commands.contains(stem)) << stem << " is never checked";
}

TEST(Schemas, TheFileOfLayersFitsItsSchema) {
    const Scratch scratch;
    scratch.writeRoom("mean_lux = 10");
    ASSERT_EQ(scratch.run({"solve", "project.toml", "--samples", "64", "--by-luminaire", "--layers-out", "layers.json", "--quiet"}).exitStatus, 0);
    EXPECT_THAT(complaintsOf(Json::parse(fileBytes(scratch.path("layers.json"))), schemas().at("layers")), IsEmpty());
}

TEST(Schemas, NoCommandIsForgotten) {
    const Scratch scratch;
    // "volume export" writes a table or a picture, and "gui" replaces itself by the window's program: neither prints JSON.
    std::set<std::string> run{"volume export", "gui"};
    const auto commands = commandsInTheManual(scratch);
    for (const auto& each : runs()) run.insert(commandOf(each, commands));
    EXPECT_GE(commands.size(), 5U);
    for (const auto& command : commands)
        EXPECT_TRUE(run.contains(command)) << "`luxdeck " << command << " --json` has no run here and so no checked schema";
}

TEST(Schemas, DescribeEveryKeyAndAllowNoOther) {
    for (const auto& [stem, schema] : schemas()) {
        EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema") << stem;
        EXPECT_THAT(schemaGaps(schema), IsEmpty()) << stem;
    }
}

TEST(Schemas, TheCheckerSeesWhatIsWrong) {
    const auto schema = Json::parse(R"({"type":"object","properties":{"a":{"type":"integer","minimum":1},"b":{"enum":["x",null]}},
                                        "required":["a"],"additionalProperties":false})");
    EXPECT_THAT(complaintsOf(Json::parse(R"({"a":1,"b":null})"), schema), IsEmpty());
    for (const char* wrong : {R"({"a":0})", R"({"a":1.5})", R"({"b":"x"})", R"({"a":1,"b":"y"})", R"({"a":1,"c":2})", "[]"})
        EXPECT_EQ(complaintsOf(Json::parse(wrong), schema).size(), 1U) << wrong;
    EXPECT_FALSE(complaintsOf(1, Json::parse(R"({"multipleOf":2})")).empty()) << "a keyword it does not know";
}

}  // namespace
}  // namespace luxdeck::test

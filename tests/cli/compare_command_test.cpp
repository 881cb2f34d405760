#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <unistd.h>

/// `luxdeck compare` from outside, on a small room. Numbers of samples are given instead of budgets, so that values depend on the seed alone.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

const std::vector<std::string> kSmall{"compare", "project.toml", "--quiet", "--samples", "256", "--rungs", "4", "--repetitions", "4", "--height", "12", "--reference-error", "1%",
                                      "--picture-reference-error", "20%"};

std::vector<std::string> with(std::vector<std::string> more) {
    auto all = kSmall;
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// All that must not change with the machine: no seconds and no memory.
Json valuesOf(const Json& json) {
    Json out = Json::array();
    for (const auto& run : json["runs"])
        out.push_back({run["subject"], run["algorithm"], run["rung"], run["samples"], run["effort"], run["rms"], run["rmsCi95"], run["bias"], run["max"], run["p99"], run["meanError"]});
    out.push_back(json["worst"]), out.push_back(json["maps"]);
    return out;
}

TEST(Compare, FindsWhatIsKnownOfItsAlgorithms) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto json = scratch.json(with({"--json", "--algorithms", "direct,path"}));
    ASSERT_FALSE(json.is_discarded());
    EXPECT_TRUE(json["complete"].get<bool>());
    ASSERT_EQ(json["runs"].size(), 2U * 2 * 4);  // algorithms, subjects, rungs
    for (const auto& run : json["runs"]) {
        // Without interreflection some light is missing, everywhere: an error that is there however often it is repeated.
        if (run["algorithm"] == "direct" && run["subject"] == "grids") {
            EXPECT_TRUE(run["bias"].is_number());
            EXPECT_LT(run["meanError"].get<double>() + run["meanErrorCi95"].get<double>(), 0);
        }
        EXPECT_LE(run["p99"].get<double>(), run["max"].get<double>());
    }
    EXPECT_EQ(json["grids"].size(), 1U);
    EXPECT_EQ(json["grids"][0]["x"].size(), 12U);
}

TEST(Compare, SameSeedSameValuesAtAnyNumberOfThreads) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto one = scratch.json(with({"--json", "--threads", "1", "--algorithms", "shared,path", "--seed", "3"}));
    const auto seven = scratch.json(with({"--json", "--threads", "7", "--algorithms", "path,shared", "--seed", "3"}));
    ASSERT_FALSE(one.is_discarded() || seven.is_discarded());
    EXPECT_EQ(valuesOf(one), valuesOf(seven));
    // What an algorithm is compared with changes nothing of its own values.
    const auto alone = scratch.json(with({"--json", "--algorithms", "path", "--seed", "3"}));
    for (const auto& run : alone["runs"]) {
        const auto same = std::find_if(one["runs"].begin(), one["runs"].end(), [&](const auto& other) {
            return other["algorithm"] == "path" && other["subject"] == run["subject"] && other["rung"] == run["rung"];
        });
        ASSERT_NE(same, one["runs"].end());
        EXPECT_EQ((*same)["rms"], run["rms"]);
    }
}

TEST(Compare, TheOrderDoesNotChangeWithTheSeed) {
    const Scratch scratch;
    scratch.writeRoom();
    for (const char* seed : {"1", "2", "3", "4"}) {
        const auto json = scratch.json(with({"--json", "--algorithms", "direct,path", "--views", "none", "--seed", seed}));
        ASSERT_EQ(json["order"].size(), 2U) << seed;
        // The smallest run of path is nearer than direct is ever, so no clock can change this.
        EXPECT_EQ(json["order"][0]["algorithm"], "path") << seed;
        EXPECT_EQ(json["order"][1]["place"], 2) << seed;
    }
}

TEST(Compare, WritesItsFolder) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto result = scratch.run(with({"--algorithms", "path,direct", "-o", "out"}));
    EXPECT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("furthest off"));
    for (const char* name : {"compare.json", "runs.csv", "errors.csv", "reference.json", "errors-door-path.png", "errors-door-direct.png"}) EXPECT_TRUE(scratch.has(std::string("out/") + name)) << name;
    EXPECT_EQ(Json::parse(scratch.read("out/compare.json"))["schema"], "luxdeck-compare/1");
    EXPECT_THAT(scratch.leftovers(), IsEmpty());
}

TEST(Compare, ReusesItsReferenceAndRefusesAnother) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto first = scratch.json(with({"--json", "--algorithms", "path", "--reference-file", "r.json"}));
    const auto again = scratch.json(with({"--json", "--algorithms", "path", "--reference-file", "r.json"}));
    ASSERT_FALSE(first.is_discarded() || again.is_discarded());
    EXPECT_FALSE(first["reference"][0]["reused"].get<bool>());
    EXPECT_TRUE(again["reference"][0]["reused"].get<bool>());
    EXPECT_EQ(valuesOf(first), valuesOf(again));
    scratch.write("project.toml", Scratch::roomProject("mean_lux = 10"));
    const auto other = scratch.run(with({"--algorithms", "path", "--reference-file", "r.json"}));
    EXPECT_EQ(other.exitStatus, 3);
    EXPECT_THAT(other.err, HasSubstr("r.json: is the reference of another project"));
    scratch.write("r.json", "{\"schema\":\"luxdeck-reference/1\"");
    EXPECT_EQ(scratch.run(with({"--algorithms", "path", "--reference-file", "r.json"})).exitStatus, 3);
}

TEST(Compare, RefusesWhatItCannotDo) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto expect = [&](std::vector<std::string> arguments, int exitStatus, const std::string& message) {
        const auto result = scratch.run(std::move(arguments));
        EXPECT_EQ(result.exitStatus, exitStatus) << message;
        EXPECT_THAT(result.err, HasSubstr(message));
    };
    expect(with({"--algorithms", "path,nothing"}), 3, "no algorithm \"nothing\", expected some of: path");
    expect(with({"--views", "attic"}), 3, "no view \"attic\", expected some of: \"door\"");
    expect(with({"--reference", "direct"}), 3, "cannot be the reference, expected one of: path, shared");
    expect(with({"--views", "none", "--no-grids"}), 3, "has neither a calculation grid nor a view");
    expect({"compare", "project.toml", "--samples", "64"}, 3, "expected at least 512");
    expect({"compare", "project.toml", "--rungs", "1"}, 2, "--rungs");
    expect({"compare", "project.toml", "--repetitions", "2"}, 2, "--repetitions");
    expect({"compare", "project.toml", "--budget", "no"}, 2, "--budget");
    expect(with({"-o", "no/such/folder"}), 3, "no/such/folder");
    expect(with({"-o", "lamp.ies"}), 3, "is no folder");
    expect({"compare", "none.toml"}, 3, "none.toml");
}

TEST(Compare, InterruptedItKeepsWholeRuns) {
    const Scratch scratch;
    scratch.writeRoom();
    for (const int ms : {700, 1500}) {
        Process process(scratch.command({"compare", "project.toml", "--quiet", "--budget", "20", "--rungs", "12", "--height", "8", "--reference-error", "20%", "--picture-reference-error", "90%", "-o", "out"}));
        ::usleep(static_cast<useconds_t>(ms) * 1000);
        process.signal(SIGINT);
        const auto result = process.wait();
        EXPECT_EQ(result.exitStatus, 130) << result.err;
        EXPECT_FALSE(result.timedOut);
        if (!scratch.has("out/compare.json")) continue;  // stopped before there was a reference
        const auto json = Json::parse(scratch.read("out/compare.json"), nullptr, false);
        ASSERT_FALSE(json.is_discarded());
        EXPECT_FALSE(json["complete"].get<bool>());
        EXPECT_THAT(scratch.leftovers(), IsEmpty());
    }
}

}  // namespace
}  // namespace luxdeck::test

#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

/// `luxdeck check` of photometric files: several at once, refusals, the sheet.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

bool canDraw(const Scratch& scratch) { return scratch.run({"check", "--help"}).out.find("--output") != std::string::npos; }

TEST(CheckPhotometry, MeasuresALambertianLuminaire) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto json = scratch.json({"check", "lamp.ies", "--json"});
    EXPECT_EQ(json["symmetryMeasured"], "axial");
    EXPECT_EQ(json["maxCandela"], 1000);
    EXPECT_EQ(json["lumensUp"], 0);
    // The file's 500 cd at 60 degrees is half of its maximum exactly; the measure steps by 0.1 degree.
    EXPECT_NEAR(json["angleC0"]["beam"].get<double>(), 120, 1e-3);
    EXPECT_THAT(scratch.run({"check", "lamp.ies"}).out, HasSubstr("beam angle  120.0°"));
}

TEST(CheckPhotometry, OneRefusedFileDoesNotHideTheOthers) {
    const Scratch scratch;
    scratch.writeRoom();
    scratch.write("bad.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 two 1 1 2 0 0 0\n");
    const auto result = scratch.run({"check", "bad.ies", "lamp.ies", "--json"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, HasSubstr("bad.ies:3"));
    const auto json = nlohmann::ordered_json::parse(result.out, nullptr, false);
    ASSERT_FALSE(json.is_discarded());
    EXPECT_EQ(json["files"][0]["file"], "lamp.ies");
    EXPECT_THAT(json["refused"][0]["why"].get<std::string>(), HasSubstr("bad.ies:3"));
}

TEST(CheckPhotometry, SheetIsTheSameBytesEveryTime) {
    const Scratch scratch;
    if (!canDraw(scratch)) GTEST_SKIP() << "built without reports";
    scratch.writeRoom();
    for (const auto& [name, start] : {std::pair{"a.png", "\x89PNG"}, {"a.pdf", "%PDF"}, {"a.svg", "<?xml"}}) {
        ASSERT_EQ(scratch.run({"check", "lamp.ies", "-o", name}).exitStatus, 0) << name;
        const auto first = scratch.read(name);
        EXPECT_THAT(first, StartsWith(start));
        ASSERT_EQ(scratch.run({"check", "lamp.ies", "-o", name}).exitStatus, 0) << name;
        EXPECT_TRUE(scratch.read(name) == first) << name;
    }
    EXPECT_THAT(scratch.read("a.svg"), HasSubstr("Polar curve"));
}

TEST(CheckPhotometry, RefusesWhatCannotBeDrawn) {
    const Scratch scratch;
    if (!canDraw(scratch)) GTEST_SKIP() << "built without reports";
    scratch.writeRoom();
    EXPECT_EQ(scratch.run({"check", "lamp.ies", "-o", "a.jpg"}).exitStatus, 3);
    EXPECT_EQ(scratch.run({"check", "lamp.ies", "lamp.ies", "-o", "a.png"}).exitStatus, 3);
    EXPECT_EQ(scratch.run({"check", "lamp.ies", "-o", "nowhere/a.png"}).exitStatus, 3);
    EXPECT_FALSE(scratch.has("a.jpg") || scratch.has("a.png"));
}

}  // namespace
}  // namespace luxdeck::test

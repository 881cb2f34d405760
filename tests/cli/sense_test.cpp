#include "tests/cli/scratch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

/// `luxdeck sense`: one line in, one line out, in order, whoever asks and however.
namespace luxdeck::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kBadAnswer = "nan nan nan nan inf";

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string question(int i) { return fmt::format("{} {} 0.8 0 0 1\n", 0.5 + 0.3 * (i % 10), 0.5 + 0.04 * (i % 97)); }

struct Answer {
    double r, g, b, y, ci95;
};

Answer parsed(const std::string& line) {
    Answer a{};
    std::istringstream in(line);
    in >> a.r >> a.g >> a.b >> a.y >> a.ci95;
    EXPECT_FALSE(in.fail()) << line;
    return a;
}

class Sense : public ::testing::Test {
protected:
    void SetUp() override { scratch.writeRoom(); }
    [[nodiscard]] std::vector<std::string> ask(const std::string& lines, std::vector<std::string> more, int expectedStatus = 0) const {
        more.insert(more.begin(), {"sense", "project.toml"});
        const auto result = scratch.run(std::move(more), lines);
        EXPECT_EQ(result.exitStatus, expectedStatus) << result.err;
        return linesOf(result.out);
    }
    Scratch scratch;
};

TEST_F(Sense, AnswersEachLineInOrder) {
    std::string lines;
    for (int i = 0; i < 50; ++i) lines += question(i);
    const auto all = ask(lines, {"--samples", "32", "--quiet"});
    ASSERT_EQ(all.size(), 50U);
    for (const auto& line : all) EXPECT_GT(parsed(line).y, 0);
}

TEST_F(Sense, SameAnswersInOneBatchOrSinglyAndWithAnyThreads) {
    std::string lines;
    for (int i = 0; i < 20; ++i) lines += question(i);
    const auto all = ask(lines, {"--samples", "64", "--threads", "1"});
    ASSERT_EQ(all.size(), 20U);
    for (const std::string threads : {"2", "7"}) {
        EXPECT_EQ(ask(lines, {"--samples", "64", "--threads", threads}), all);
        Process process(scratch.command({"sense", "project.toml", "--samples", "64", "--threads", threads}));
        for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_TRUE(process.write(question(static_cast<int>(i))));  // and waits for the answer before it asks again
            const auto answer = process.readLine();
            ASSERT_TRUE(answer);
            EXPECT_EQ(*answer, all[i]);
        }
        EXPECT_EQ(process.wait().exitStatus, 0);
    }
    EXPECT_NE(ask(lines, {"--samples", "64", "--seed", "2"}), all);
}

TEST_F(Sense, TargetErrorIsTheSameHoweverLinesArrive) {
    const auto together = ask(question(1) + question(2) + question(3), {"--target-error", "5%"});
    ASSERT_EQ(together.size(), 3U);
    for (const auto& line : together) EXPECT_LE(parsed(line).ci95, 0.05 * parsed(line).y * 1.01);  // 3 digits of ci95: 0.5 %, rounded up
    Process process(scratch.command({"sense", "project.toml", "--target-error", "5%"}));
    for (int i = 1; i <= 3; ++i) {
        process.write(question(i));
        EXPECT_EQ(process.readLine(), together[static_cast<std::size_t>(i - 1)]);
    }
}

TEST_F(Sense, BadLinesAreAnsweredAndOthersUnaffected) {
    const auto good = ask(question(0) + question(1) + question(2), {"--samples", "32"});
    for (const std::string bad : {"rubbish", "1 2 3", "1 2 3 4 5 6 7", "1 1 1 0 0 0", "nan 1 1 0 0 1", "1 1 1 0 0 inf", "1e300 1 1 0 0 1",
                                  "1e999 1 1 0 0 1", "1 1 1 0 0 1x", "\x01\x02\xff"}) {
        const auto result = scratch.run({"sense", "project.toml", "--samples", "32"}, question(0) + bad + "\n" + question(2));
        EXPECT_EQ(result.exitStatus, 3) << bad;
        EXPECT_THAT(linesOf(result.out), ElementsAre(good[0], kBadAnswer, good[2])) << bad;
        EXPECT_THAT(result.err, HasSubstr("stdin:2: ")) << bad;
    }
}

TEST_F(Sense, HugeAndTinyDirectionsAreDirections) {
    const auto usual = ask("1 1 1 0 0 1\n", {"--samples", "32"});
    EXPECT_EQ(ask("1 1 1 0 0 1e300\n", {"--samples", "32"}), usual);
    EXPECT_EQ(ask("1 1 1 0 0 1e-300\n", {"--samples", "32"}), usual);
}

TEST_F(Sense, BlankLinesAreAnsweredByBlankLines) {
    const auto good = ask(question(0) + question(1) + question(2), {"--samples", "32"});
    EXPECT_THAT(ask(question(0) + " \t\n" + question(2) + "\r\n", {"--samples", "32"}), ElementsAre(good[0], "", good[2], ""));
}

TEST_F(Sense, TakesCrlfCommasAndALastLineWithoutEnd) {
    const auto usual = ask("1 1 1 0 0 1\n1 2 1 0 0 1\n", {"--samples", "32"});
    EXPECT_EQ(ask("1 1 1 0 0 1\r\n1 2 1 0 0 1\r\n", {"--samples", "32"}), usual);
    EXPECT_EQ(ask("1,1,1,0,0,1\n1, 2,\t1, 0, 0, 1\n", {"--samples", "32"}), usual);
    EXPECT_EQ(ask("1 1 1 0 0 1\n1 2 1 0 0 1", {"--samples", "32"}), usual);
    EXPECT_EQ(ask("", {"--samples", "32"}).size(), 0U);
}

TEST_F(Sense, RefusesALineWithoutEndAfterAnsweringWhatCameBefore) {
    const auto result = scratch.run({"sense", "project.toml", "--samples", "32"}, question(0) + std::string(1'000'000, '1'));
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_EQ(linesOf(result.out).size(), 1U);
    EXPECT_THAT(result.err, HasSubstr("64 KiB"));
}

/// A hundred times the lines take no more memory but for what differs from run to run.
TEST_F(Sense, ManyLinesTakeBoundedMemory) {
    const auto peak = [&](int count) {
        std::string lines;
        for (int i = 0; i < count; ++i) lines += question(i);
        const auto result = scratch.run({"sense", "project.toml", "--algorithm", "direct", "--samples", "32", "--quiet"}, lines);
        EXPECT_EQ(result.exitStatus, 0) << result.err;
        EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), count);
        return result.peakKilobytes;
    };
    const long few = peak(4096);  // two full batches: every buffer has its largest size
    // 200,000 lines are 4 MB of text and 60 MB of sums: kept, they would show. Allocators vary by some MB.
    EXPECT_LT(peak(200'000), few + 20'000);
}

/// Straight under the lamp of 1000 cd, direct light alone: E = I / d^2. The lamp is a square of 0.2 m, 2 m away: as its luminance
/// is even, E exceeds the point's by less than (0.1 m / 2 m)^2 = 0.25 %.
TEST_F(Sense, IlluminanceUnderTheLampIsInLux) {
    const auto answer = parsed(ask("2 2.5 0.8 0 0 1\n", {"--algorithm", "direct", "--samples", "4096"}).at(0));
    EXPECT_NEAR(answer.y, 1000 / 4.0, 0.0075 * 250 + answer.ci95);
    EXPECT_NEAR(answer.r, answer.y, 1e-3 * answer.y);  // a white lamp
    EXPECT_EQ(ask("2 2.5 0.8 0 0 1\n", {"--irradiance", "--algorithm", "direct", "--samples", "4096"}),
              ask("2 2.5 0.8 0 0 1\n", {"--algorithm", "direct", "--samples", "4096"}));
}

/// A matte floor of 0.5 under direct light: L = rho E / pi, seen from anywhere.
TEST_F(Sense, RadianceOfTheFloorFollowsItsIlluminance) {
    const auto lux = parsed(ask("1 1 0.0001 0 0 1\n", {"--algorithm", "direct", "--samples", "4096"}).at(0));
    const auto seen = parsed(ask("1 1 1.5 0 0 -1\n", {"--radiance", "--algorithm", "direct", "--samples", "4096"}).at(0));
    EXPECT_NEAR(seen.y, 0.5 * lux.y / std::numbers::pi, seen.ci95 + 0.5 / std::numbers::pi * lux.ci95 + 0.002 * seen.y);  // 0.1 mm above
}

/// A small source straight above an upright cylinder lights none of it; from the side, E_z = I cos / (pi d^2).
TEST_F(Sense, CylindricalIlluminance) {
    const auto answer = parsed(ask("2 0.5 1.8 0 0 1\n", {"--cylindrical", "--algorithm", "direct", "--samples", "16384"}).at(0));
    const double d2 = 4 + 1, cosDown = 1 / std::sqrt(d2), sinDown = 2 / std::sqrt(d2);
    // The opening is 0.2 m wide and 2.24 m off: (0.1 / 2.24)^2 = 0.2 %; the table interpolates the cosine to 1 %.
    EXPECT_NEAR(answer.y, 1000 * cosDown * sinDown / (std::numbers::pi * d2), answer.ci95 + 0.015 * answer.y);
}

TEST_F(Sense, JsonLines) {
    const auto lines = ask(question(0) + "bad\n" + question(1), {"--samples", "32", "--json"}, 3);
    ASSERT_EQ(lines.size(), 3U);
    const auto first = nlohmann::ordered_json::parse(lines[0]), bad = nlohmann::ordered_json::parse(lines[1]);
    EXPECT_EQ(first.begin().key(), "schema");
    for (const auto* key : {"r", "g", "b", "y", "ci95"}) {
        EXPECT_TRUE(first[key].is_number()) << key;
        EXPECT_TRUE(bad[key].is_null()) << key;
    }
    EXPECT_EQ(first["samples"], 32);
}

}  // namespace
}  // namespace luxdeck::test

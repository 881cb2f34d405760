#include "engine/io/image_files.h"
#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <random>
#include <unistd.h>

/// Ctrl-C at any moment: exit status 130, and what is on disk is valid: a partial result that says so, or nothing new.
/// kill -9 at any moment: the target file is the old one or a whole new one.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// From before main() to well into the work.
std::vector<int> momentsMs(unsigned seed, int count, int most) {
    std::mt19937 random(seed);
    std::vector<int> out;
    for (int i = 0; i < count; ++i) out.push_back(std::uniform_int_distribution<>(0, most)(random));
    return out;
}

ProcessResult stopped(const Scratch& scratch, const std::vector<std::string>& arguments, int afterMs, int signal) {
    Process process(scratch.command(arguments));
    ::usleep(static_cast<useconds_t>(afterMs) * 1000);
    process.signal(signal);
    return process.wait();
}

/// 130 from us; or SIGINT itself before the program had a say, which a shell also calls 130.
void expectInterrupted(const ProcessResult& result) {
    EXPECT_TRUE(result.exitStatus == 130 || result.signal == SIGINT) << result.exitStatus << " " << result.err;
    EXPECT_FALSE(result.timedOut);
}

TEST(Interrupt, SolveWritesWhatThereIs) {
    for (const int ms : momentsMs(1, 12, 400)) {
        const Scratch scratch;
        scratch.writeRoom();
        expectInterrupted(stopped(scratch, {"solve", "project.toml", "--target-error", "0.0001%", "--json", "-o", "out.json"}, ms, SIGINT));
        EXPECT_THAT(scratch.leftovers(), IsEmpty());
        if (!scratch.has("out.json")) continue;
        const auto json = nlohmann::json::parse(scratch.read("out.json"), nullptr, false);
        ASSERT_FALSE(json.is_discarded()) << "after " << ms << " ms";
        EXPECT_FALSE(json["complete"].get<bool>());
        EXPECT_EQ(json["grids"].size(), 1U);
    }
}

TEST(Interrupt, SolveTextSaysSo) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto result = stopped(scratch, {"solve", "project.toml", "--target-error", "0.0001%"}, 600, SIGINT);
    expectInterrupted(result);
    EXPECT_THAT(result.out, HasSubstr("incomplete: interrupted"));
}

TEST(Interrupt, TerminateIsLikeCtrlC) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto result = stopped(scratch, {"solve", "project.toml", "--target-error", "0.0001%", "--json"}, 600, SIGTERM);
    EXPECT_EQ(result.exitStatus, 130) << result.signal;
    EXPECT_FALSE(nlohmann::json::parse(result.out)["complete"].get<bool>());
}

TEST(Interrupt, RenderWritesAPictureWithoutHolesOrNone) {
    int pictures = 0;
    for (const int ms : momentsMs(2, 12, 500)) {
        const Scratch scratch;
        scratch.writeRoom();
        expectInterrupted(stopped(scratch, {"render", "project.toml", "--time", "100", "-o", "f.exr"}, ms, SIGINT));
        EXPECT_THAT(scratch.leftovers(), IsEmpty());
        if (!scratch.has("f.exr")) continue;
        const auto image = readHdrImage(scratch.path("f.exr"));
        ASSERT_TRUE(image) << image.error().text();
        EXPECT_EQ(image->text.at("luxdeck:complete"), "false");
        EXPECT_GT(image->numbers.at("luxdeck:samplesPerPixel"), 0);
        ++pictures;
    }
    // Reading and a first pass of this room take some 50 ms: of 12 moments over 500 ms not all are before it.
    EXPECT_GT(pictures, 0);
}

TEST(Interrupt, RenderKeepsTheOldPictureWhenThereIsNoNewOne) {
    const Scratch scratch;
    scratch.writeRoom();
    scratch.write("f.exr", "the old picture");
    const auto result = stopped(scratch, {"render", "project.toml", "--size", "8000", "8000", "--time", "100", "-o", "f.exr"}, 700, SIGINT);
    expectInterrupted(result);
    EXPECT_EQ(scratch.read("f.exr"), "the old picture");
    EXPECT_THAT(scratch.leftovers(), IsEmpty());
}

TEST(Interrupt, SenseAnswersInWholeLines) {
    std::string lines;
    for (int i = 0; i < 5000; ++i) lines += "1 1 1 0 0 1\n";
    for (const int ms : momentsMs(3, 6, 500)) {
        const Scratch scratch;
        scratch.writeRoom();
        Process process(scratch.command({"sense", "project.toml", "--target-error", "0.01%"}));
        process.write(lines);
        ::usleep(static_cast<useconds_t>(ms) * 1000);
        process.signal(SIGINT);
        const auto result = process.wait();
        expectInterrupted(result);
        EXPECT_TRUE(result.out.empty() || result.out.back() == '\n');
    }
}

TEST(Interrupt, SenseThatWaitsForALineEnds) {
    const Scratch scratch;
    scratch.writeRoom();
    Process process(scratch.command({"sense", "project.toml", "--samples", "32"}));
    process.write("1 1 1 0 0 1\n1 1 1");
    ASSERT_TRUE(process.readLine());
    process.signal(SIGINT);
    // Its input stays open: only the signal can end it.
    EXPECT_FALSE(process.readLine()) << "half a line was answered";
    EXPECT_EQ(process.wait().exitStatus, 130);
}

TEST(Interrupt, SenseWithAFixedNumberCanBeStopped) {
    const Scratch scratch;
    scratch.writeRoom();
    Process process(scratch.command({"sense", "project.toml", "--samples", "1000000000"}));
    process.write("1 1 1 0 0 1\n");
    ::usleep(300'000);
    process.signal(SIGINT);
    const auto result = process.wait();
    expectInterrupted(result);
}

TEST(Interrupt, KilledWorkLeavesAWholeFileOrTheOldOne) {
    for (const int ms : momentsMs(4, 10, 300)) {
        const Scratch scratch;
        scratch.writeRoom();
        scratch.write("f.exr", "old");
        scratch.write("out.json", "old");
        const auto render = stopped(scratch, {"render", "project.toml", "--samples", "8", "-o", "f.exr"}, ms, SIGKILL);
        EXPECT_TRUE(render.signal == SIGKILL || render.exitStatus == 0);
        EXPECT_TRUE(scratch.read("f.exr") == "old" || readHdrImage(scratch.path("f.exr"))) << "after " << ms << " ms";
        (void)stopped(scratch, {"solve", "project.toml", "--samples", "320", "--json", "-o", "out.json"}, ms, SIGKILL);
        EXPECT_TRUE(scratch.read("out.json") == "old" || nlohmann::json::accept(scratch.read("out.json"))) << "after " << ms << " ms";
    }
}

}  // namespace
}  // namespace luxdeck::test

#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// A disk without room: exit status 5, the old file as it was, nothing half-written beside it.
///
/// Two ways there: /dev/full, which every write to fails with ENOSPC, and a limit on the size of files, which fails
/// amid a file as a full disk does and needs no mount.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Less than any result below takes.
constexpr std::size_t kRoom = 512;

void expectNoRoom(const ProcessResult& result) {
    EXPECT_EQ(result.exitStatus, 5) << "signal " << result.signal << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr("cannot be written"));
}

void expectOldFileKept(const std::vector<std::string>& arguments, const std::string& output, std::size_t room = kRoom) {
    const Scratch scratch;
    scratch.writeRoom();
    if (arguments[0] == "tonemap") {
        ASSERT_EQ(scratch.run({"render", "project.toml", "-o", "in.exr", "--samples", "1"}).exitStatus, 0);
    }
    scratch.write(output, "the old content");
    auto command = scratch.command(arguments);
    command.largestFile = room;
    expectNoRoom(runProcess(command));
    EXPECT_EQ(scratch.read(output), "the old content");
    EXPECT_THAT(scratch.leftovers(), IsEmpty());
}

TEST(FullDisk, KeepsTheOldResultOfSolve) {
    expectOldFileKept({"solve", "project.toml", "--samples", "32", "--json", "-o", "out.json"}, "out.json");
}

TEST(FullDisk, KeepsTheOldPicture) { expectOldFileKept({"render", "project.toml", "--samples", "1", "-o", "out.exr"}, "out.exr"); }

TEST(FullDisk, KeepsTheOldPng) { expectOldFileKept({"tonemap", "in.exr", "-o", "out.png"}, "out.png"); }

TEST(FullDisk, DeviceThatIsFull) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run({"render", "project.toml", "-o", "in.exr", "--samples", "1"}).exitStatus, 0);
    expectNoRoom(scratch.run({"solve", "project.toml", "--samples", "32", "-o", "/dev/full"}));
    expectNoRoom(scratch.run({"render", "project.toml", "--samples", "1", "-o", "/dev/full"}));
    expectNoRoom(scratch.run({"tonemap", "in.exr", "-o", "/dev/full"}));
}

TEST(FullDisk, StdoutThatIsFull) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const Scratch scratch;
    scratch.writeRoom();
    for (const std::string command : {"check project.toml", "solve project.toml --samples 32", "render project.toml --samples 1 -o f.exr",
                                      "tonemap f.exr -o f.png", "--man", "--help", "sense project.toml --samples 32 <<< '1 1 1 0 0 1'"}) {
        auto settings = scratch.command({});
        settings.arguments = {"/bin/bash", "-c", std::string("exec '") + LUXDECK_PROGRAM + "' " + command + " > /dev/full"};
        const auto result = runProcess(settings);
        EXPECT_EQ(result.exitStatus, 5) << command << "\n" << result.err;
        EXPECT_THAT(result.err, HasSubstr("stdout")) << command;
    }
}

/// Bug avoided: with stdout closed, the next file opened gets its number, and the message for people ends in the picture.
TEST(ClosedStreams, WithoutAStdoutNothingStrayLandsInAFile) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run({"render", "project.toml", "-o", "good.exr", "--samples", "1", "--quiet"}).exitStatus, 0);
    auto command = scratch.command({"render", "project.toml", "-o", "f.exr", "--samples", "1"});
    command.closeOutput = true;
    const auto result = runProcess(command);
    EXPECT_EQ(result.exitStatus, 5) << result.err;
    EXPECT_EQ(scratch.run({"tonemap", "f.exr", "-o", "f.png"}).exitStatus, 0);
    EXPECT_EQ(scratch.read("f.exr").find("paths each"), std::string::npos);
}

/// Bug: fmt::print to a closed pipe throws, out of a destructor: the process aborted. Nobody has to read messages.
TEST(ClosedStreams, ABrokenStderrIsNoReasonToStop) {
    const Scratch scratch;
    scratch.writeRoom();
    Process process(scratch.command({"solve", "project.toml", "--samples", "3200", "--json"}));
    process.closeErrors();
    const auto result = process.wait();
    EXPECT_EQ(result.exitStatus, 0) << "signal " << result.signal;
    EXPECT_TRUE(nlohmann::json::accept(result.out));
}

TEST(ClosedStreams, AReaderThatLeavesEndsTheWork) {
    const Scratch scratch;
    scratch.writeRoom();
    Process process(scratch.command({"sense", "project.toml", "--samples", "32"}));
    process.write("1 1 1 0 0 1\n");
    ASSERT_TRUE(process.readLine());
    process.closeOutput();
    process.write("1 1 1 0 0 1\n");
    const auto result = process.wait();
    EXPECT_EQ(result.exitStatus, 5) << "signal " << result.signal;
    EXPECT_THAT(result.err, HasSubstr("stdout"));
}

}  // namespace
}  // namespace luxdeck::test

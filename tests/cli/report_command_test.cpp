#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <unistd.h>

/// `luxdeck report`: a PDF and its JSON twin.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<std::string> kReport{"report", "project.toml", "-o", "r.pdf", "--samples", "64", "--view-time", "0.2"};

TEST(ReportCommand, WritesATwinThatMakesTheSamePdf) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto result = scratch.run(kReport);
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_EQ(result.err.find("QStandardPaths"), std::string::npos) << result.err;
    const auto json = nlohmann::ordered_json::parse(scratch.read("r.json"), nullptr, false);
    ASSERT_FALSE(json.is_discarded());
    EXPECT_EQ(json.begin().key(), "schema");
    const auto again = scratch.run({"report", "--from", "r.json", "-o", "again.pdf"});
    ASSERT_EQ(again.exitStatus, 0) << again.err;
    EXPECT_TRUE(scratch.read("again.pdf") == scratch.read("r.pdf"));
    EXPECT_FALSE(scratch.has("again.json")) << "its twin is r.json";
    if (!std::filesystem::exists("/usr/bin/pdftotext")) GTEST_SKIP() << "no pdftotext to read the report with";
    ProcessSettings reader;
    reader.arguments = {"/usr/bin/pdftotext", scratch.path("r.pdf").string(), "-"};
    EXPECT_THAT(runProcess(reader).out, HasSubstr("floor"));
}

TEST(ReportCommand, NeedsAProjectOrATwin) {
    const Scratch scratch;
    EXPECT_EQ(scratch.run({"report", "-o", "r.pdf"}).exitStatus, 2);
    EXPECT_EQ(scratch.run({"report", "project.toml", "-o", "r.json"}).exitStatus, 2);  // its twin would be the same file
}

TEST(ReportCommand, FullDiskKeepsTheOldReport) {
    const Scratch scratch;
    scratch.writeRoom();
    scratch.write("r.pdf", "old report");
    scratch.write("r.json", "old twin");
    auto command = scratch.command(kReport);
    command.largestFile = 512;
    const auto result = runProcess(command);
    EXPECT_EQ(result.exitStatus, 5) << result.signal << result.err;
    EXPECT_EQ(scratch.read("r.pdf"), "old report");
    EXPECT_EQ(scratch.read("r.json"), "old twin");
    EXPECT_THAT(scratch.leftovers(), IsEmpty());
}

TEST(ReportCommand, InterruptedItIsMarkedIncomplete) {
    for (const int ms : {30, 150, 400}) {
        const Scratch scratch;
        scratch.writeRoom();
        Process process(scratch.command({"report", "project.toml", "-o", "r.pdf", "--target-error", "0.0001%"}));
        ::usleep(static_cast<useconds_t>(ms) * 1000);
        process.signal(SIGINT);
        const auto result = process.wait();
        EXPECT_TRUE(result.exitStatus == 130 || result.signal == SIGINT) << result.exitStatus << result.err;
        EXPECT_THAT(scratch.leftovers(), IsEmpty());
        if (!scratch.has("r.json")) continue;
        EXPECT_TRUE(scratch.read("r.pdf").starts_with("%PDF"));
        EXPECT_THAT(scratch.read("r.json"), ::testing::ContainsRegex("\"complete\": *false"));
    }
}

}  // namespace
}  // namespace luxdeck::test

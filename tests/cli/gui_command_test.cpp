// `luxdeck gui` where the desktop program is not beside it, and where a user looks for it.
#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace luxdeck::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

/// A copy of the program alone in the folder: nothing lies beside it.
ProcessSettings alone(const Scratch& scratch, const std::vector<std::string>& arguments) {
    auto settings = scratch.command(arguments);
    fs::copy_file(settings.arguments.front(), scratch.path("luxdeck"));
    settings.arguments.front() = scratch.path("luxdeck").string();
    return settings;
}

TEST(GuiCommand, SaysWhatIsMissingWhereTheWindowIsNotBesideIt) {
    const Scratch scratch;
    scratch.writeRoom();
    for (const auto& arguments : {std::vector<std::string>{"gui"}, {"gui", "project.toml"}}) {
        fs::remove(scratch.path("luxdeck"));
        const auto result = runProcess(alone(scratch, arguments));
        EXPECT_EQ(result.exitStatus, 3) << "signal " << result.signal;
        EXPECT_THAT(result.out, IsEmpty());
        EXPECT_THAT(result.err, AllOf(HasSubstr(scratch.path("luxdeck-gui").string()), HasSubstr("cannot be started"), HasSubstr("LUXDECK_GUI")));
    }
}

TEST(GuiCommand, StartsWhatLiesBesideItWithTheProject) {
    const Scratch scratch;
    scratch.write("luxdeck-gui", "#!/bin/sh\necho \"window of $1\"\nexit 7\n");
    fs::permissions(scratch.path("luxdeck-gui"), fs::perms::owner_all);
    const auto result = runProcess(alone(scratch, {"gui", "a project.toml"}));
    EXPECT_EQ(result.out, "window of a project.toml\n");
    EXPECT_EQ(result.exitStatus, 7);
}

TEST(GuiCommand, IsListedByHelpManualAndCompletions) {
    const Scratch scratch;
    EXPECT_THAT(scratch.run({"--help"}).out, HasSubstr("Opens the desktop program"));
    EXPECT_THAT(scratch.run({"gui", "--help"}).out, AllOf(HasSubstr("project.toml"), HasSubstr("start page")));
    EXPECT_THAT(scratch.run({"--man"}).out, HasSubstr(".SS luxdeck gui"));
    for (const char* shell : {"bash", "zsh", "fish"}) EXPECT_THAT(scratch.run({"--completions", shell}).out, HasSubstr("gui")) << shell;
}

}  // namespace
}  // namespace luxdeck::test

#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

/// `luxdeck --completions`: bash is asked what it would offer; zsh and fish read their scripts where they are installed.
namespace luxdeck::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// What bash offers for the last of these words, in the folder of `scratch`.
std::vector<std::string> offered(const Scratch& scratch, const std::vector<std::string>& words) {
    scratch.write("luxdeck.bash", scratch.run({"--completions", "bash"}).out);
    std::string script = "source ./luxdeck.bash\nCOMP_WORDS=(";
    for (const auto& word : words) script += "'" + word + "' ";
    script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) + "\n_luxdeck\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    scratch.write("ask.bash", script);
    ProcessSettings bash;
    bash.arguments = {"/bin/bash", "--norc", "ask.bash"};
    bash.folder = scratch.path("");
    const auto result = runProcess(bash);
    EXPECT_EQ(result.err, "");
    std::vector<std::string> out;
    std::istringstream rows(result.out);
    for (std::string row; std::getline(rows, row);)
        if (!row.empty()) out.push_back(row);
    return out;
}

class BashCompletion : public ::testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists("/bin/bash")) GTEST_SKIP() << "no bash to ask";
    }
    Scratch scratch;
};

TEST_F(BashCompletion, Commands) {
    EXPECT_THAT(offered(scratch, {"luxdeck", ""}), IsSupersetOf({"check", "solve", "sense", "render", "tonemap"}));
    EXPECT_THAT(offered(scratch, {"luxdeck", "so"}), ElementsAre("solve"));
    EXPECT_THAT(offered(scratch, {"luxdeck", "--comp"}), ElementsAre("--completions"));
    EXPECT_THAT(offered(scratch, {"luxdeck", "--completions", ""}), ElementsAre("bash", "zsh", "fish"));
}

TEST_F(BashCompletion, OptionsOfACommand) {
    EXPECT_THAT(offered(scratch, {"luxdeck", "solve", "--"}), IsSupersetOf({"--json", "--target-error", "--threads", "--algorithm"}));
    EXPECT_THAT(offered(scratch, {"luxdeck", "solve", "--"}), Not(Contains("--isolines")));
    EXPECT_THAT(offered(scratch, {"luxdeck", "tonemap", "--iso"}), ElementsAre("--isolines"));
}

TEST_F(BashCompletion, ChoicesBehindASpaceAndAnEqualsSign) {
    EXPECT_THAT(offered(scratch, {"luxdeck", "tonemap", "--operator", ""}), ElementsAre("human", "camera", "linear"));
    EXPECT_THAT(offered(scratch, {"luxdeck", "tonemap", "--operator", "=", "c"}), ElementsAre("camera"));
    EXPECT_THAT(offered(scratch, {"luxdeck", "tonemap", "--operator", "="}), ElementsAre("human", "camera", "linear"));
    EXPECT_THAT(offered(scratch, {"luxdeck", "solve", "--algorithm", ""}), Contains("path"));
    EXPECT_THAT(offered(scratch, {"luxdeck", "solve", "--seed", ""}), IsEmpty());
}

TEST_F(BashCompletion, FilesWithSpacesToo) {
    scratch.write("my room.toml", "");
    std::filesystem::create_directory(scratch.path("my folder"));
    EXPECT_THAT(offered(scratch, {"luxdeck", "solve", "my"}), IsSupersetOf({"my room.toml", "my folder"}));
    EXPECT_THAT(offered(scratch, {"luxdeck", "render", "-o", "my r"}), ElementsAre("my room.toml"));
}

TEST(Completions, OtherShellsReadTheirScripts) {
    const Scratch scratch;
    int read = 0;
    for (const std::string shell : {"bash", "zsh", "fish"}) {
        const auto script = scratch.run({"--completions", shell});
        ASSERT_EQ(script.exitStatus, 0);
        for (const auto* word : {"solve", "target-error", "camera"}) EXPECT_THAT(script.out, HasSubstr(word)) << shell;
        const auto program = "/usr/bin/" + shell;
        if (!std::filesystem::exists(program)) continue;
        scratch.write("script." + shell, script.out);
        ProcessSettings check;
        check.arguments = {program, "-n", scratch.path("script." + shell).string()};
        const auto result = runProcess(check);
        EXPECT_EQ(result.exitStatus, 0) << shell << result.err;
        ++read;
    }
    EXPECT_EQ(scratch.run({"--completions", "tcsh"}).exitStatus, 2);
    if (read == 0) GTEST_SKIP() << "none of the shells is installed";
}

}  // namespace
}  // namespace luxdeck::test

// A program that is killed loses nothing: the next one offers what was not saved.
#include "tests/gui/window/open_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

namespace luxdeck::gui {
namespace {

using test::OpenWindow;
using test::OwnFolder;
using testing::HasSubstr;

constexpr const char* kProject = "LUXDECK_TEST_PROJECT";
constexpr const char* kNote = "# written before the end\n";

std::string contents(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The program that will be killed: this test, in a process of its own.
TEST(Recovery, DISABLED_EditsAndWaitsForTheEnd) {
    const char* project = std::getenv(kProject);
    ASSERT_NE(project, nullptr);
    OpenWindow open;
    ASSERT_TRUE(open.open(project));
    ASSERT_TRUE(open.session().edit("Note", [](const std::string& text) -> Result<std::string> { return text + kNote; }));
    ASSERT_TRUE(open.untilIdle());
    open.session().autosave();  // as the window does every twenty seconds
    std::ofstream(std::string(project) + ".ready") << "ready";
    QTest::qWait(600'000);
}

pid_t startVictim(const std::filesystem::path& project) {
    const pid_t child = fork();
    if (child != 0) return child;
    setenv(kProject, project.c_str(), 1);
    execl("/proc/self/exe", "luxdeck_test_window", "--gtest_filter=Recovery.DISABLED_EditsAndWaitsForTheEnd", "--gtest_also_run_disabled_tests", nullptr);
    _exit(127);
}

TEST(Recovery, WhatAKilledProgramHadNotSavedIsOfferedAndCanBeUndone) {
    const OwnFolder folder;
    const auto project = folder.sample("office");
    const auto saved = contents(project);
    const pid_t victim = startVictim(project);
    ASSERT_GT(victim, 0);
    ASSERT_TRUE(OpenWindow::until([&] { return std::filesystem::exists(project.string() + ".ready"); }));
    kill(victim, SIGKILL);
    waitpid(victim, nullptr, 0);
    EXPECT_EQ(contents(project), saved);

    OpenWindow open;
    OpenWindow::answer(QStringLiteral("Recover"));
    ASSERT_TRUE(open.open(project));
    EXPECT_EQ(open.session().document().text(), saved + kNote);
    EXPECT_TRUE(open.window->isWindowModified());
    open.command("undo");
    ASSERT_TRUE(open.untilIdle());
    EXPECT_EQ(open.session().document().text(), saved);
    open.command("redo");
    ASSERT_TRUE(open.untilIdle());
    open.command("saveProject");
    EXPECT_EQ(contents(project), saved + kNote);
    EXPECT_FALSE(std::filesystem::exists(project.parent_path() / ".project.toml.autosave"));
}

TEST(Recovery, WhatIsNotWantedStaysOut) {
    const OwnFolder folder;
    const auto project = folder.sample("office");
    const auto saved = contents(project);
    std::ofstream(project.parent_path() / ".project.toml.autosave") << saved << kNote;
    OpenWindow open;
    OpenWindow::answer(QStringLiteral("Open as saved"));
    ASSERT_TRUE(open.open(project));
    EXPECT_EQ(open.session().document().text(), saved);
    EXPECT_FALSE(open.window->isWindowModified());
}

}  // namespace
}  // namespace luxdeck::gui

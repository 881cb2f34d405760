// What cannot be used is said, with file, place and what is expected; and nothing is lost.
#include "tests/gui/window/hands.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace luxdeck::gui {
namespace {

namespace fs = std::filesystem;
using test::OpenWindow;
using test::OwnFolder;
using testing::AllOf;
using testing::HasSubstr;

class BadInputStory : public testing::Test {
protected:
    void SetUp() override {
        project_ = folder_.sample("office");
        ASSERT_TRUE(open_.open(project_));
        text_ = session().document().text();
    }
    Session& session() { return open_.session(); }
    /// Why a dropped file cannot be used, as the dialog says it; the dialog is closed.
    std::string refusalOf(const fs::path& file) {
        test::drop(*open_.window, {file});
        auto* dialog = open_.find<QDialog>("importDialog");
        QLabel* why = nullptr;
        const bool shown = OpenWindow::until([&] { return (why = dialog->findChild<QLabel*>("importRefused")) != nullptr && why->isVisible(); });
        EXPECT_TRUE(shown);
        const auto said = shown ? why->text().toStdString() : std::string();
        EXPECT_EQ(dialog->findChild<QPushButton*>("importAddType"), nullptr) << "there is nothing to do with it";
        dialog->close();
        QTest::qWait(50);
        EXPECT_EQ(session().document().text(), text_);
        EXPECT_NE(session().project(), nullptr);
        return said;
    }
    void edit() {
        ASSERT_TRUE(session().edit("Note", [](const std::string& text) -> Result<std::string> { return text + "\n# a note\n"; }));
        ASSERT_TRUE(open_.untilIdle());
    }

    OwnFolder folder_;
    OpenWindow open_;
    fs::path project_;
    std::string text_;
};

TEST_F(BadInputStory, WhatIsDroppedAndCannotBeUsedSaysWhatAndWhere) {
    const auto photometry = folder_.path() / "broken.ies", model = folder_.path() / "half.glb", letter = folder_.path() / "letter.doc";
    std::ofstream(photometry) << "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 drei 1 1 2 0 0 0\n1 1 10\n";
    EXPECT_THAT(refusalOf(photometry), AllOf(HasSubstr("broken.ies:3"), HasSubstr("drei"), HasSubstr("expected")));
    const auto whole = test::contents(folder_.path() / "office/office.glb");
    std::ofstream(model, std::ios::binary) << whole.substr(0, whole.size() / 2);
    EXPECT_THAT(refusalOf(model), HasSubstr("half.glb"));
    EXPECT_THAT(refusalOf(folder_.path()), HasSubstr(folder_.path().filename().string()));
    std::ofstream(letter) << "Dear designer";
    EXPECT_THAT(refusalOf(letter), AllOf(HasSubstr("letter.doc"), HasSubstr("expected")));
}

TEST_F(BadInputStory, AFileWithoutRights) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const auto file = folder_.path() / "secret.ies";
    fs::copy_file(folder_.path() / "office/luminaires/b_pendant.ldt", file);
    fs::permissions(file, fs::perms::none);
    EXPECT_THAT(refusalOf(file), HasSubstr("secret.ies"));
}

TEST_F(BadInputStory, ADroppedProjectWithAMistakeLeavesTheMessage) {
    const auto other = folder_.path() / "other.toml";
    std::ofstream(other) << "schema = \"luxdeck-project/1\"\n[project]\nname = 3\n";
    test::drop(*open_.window, {other});
    EXPECT_THAT(open_.message(), HasSubstr("other.toml:3"));
    EXPECT_EQ(test::contents(project_), text_);
}

// A limit on the size of files fails amid a file, as a full disk does, and needs no mount.
TEST_F(BadInputStory, AFullDiskWhileSavingLosesNothing) {
    edit();
    const auto changed = session().document().text();
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, SIG_IGN);
    const rlimit small{512, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    open_.command("saveProject");
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_THAT(open_.message(), AllOf(HasSubstr("project.toml"), HasSubstr("cannot be written")));
    EXPECT_EQ(test::contents(project_), text_) << "the file is as it was";
    EXPECT_EQ(session().document().text(), changed);
    EXPECT_TRUE(open_.window->isWindowModified());
    open_.command("saveProject");
    EXPECT_EQ(test::contents(project_), changed) << "and there is room again";
    EXPECT_FALSE(open_.window->isWindowModified());
}

TEST_F(BadInputStory, SavingWhereNothingCanBeWritten) {
    edit();
    test::answerFile("/proc/office.toml");
    open_.command("saveProjectAs");
    EXPECT_THAT(open_.message(), HasSubstr("/proc/office.toml"));
    EXPECT_TRUE(open_.window->isWindowModified());
    EXPECT_EQ(session().document().file(), project_) << "it is still the project that was opened";
}

}  // namespace
}  // namespace luxdeck::gui

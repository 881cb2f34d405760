#include "engine/core/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FileTest : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("luxdeck_file_" + std::to_string(::getpid()) + "_" +
                                               ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_);
    }
    void TearDown() override {
        std::error_code ec;
        fs::remove_all(folder_, ec);
    }
    [[nodiscard]] std::size_t filesThere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

TEST_F(FileTest, GivesBackWhatWasWritten) {
    const std::string bytes("a\0b\r\n\xff", 6);
    for (const auto& content : {bytes, std::string(), std::string(200'000, 'x')}) {
        ASSERT_TRUE(writeFileAtomically(folder_ / "a", content));
        const auto read = readFile(folder_ / "a");
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(*read, content);
    }
    EXPECT_EQ(filesThere(), 1U) << "a temporary file was left";
}

TEST_F(FileTest, RefusesWhatIsNoFileOrTooLarge) {
    const auto missing = readFile(folder_ / "none");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::FileNotFound);
    EXPECT_EQ(missing.error().where, (folder_ / "none").string());
    EXPECT_EQ(readFile(folder_).error().code, ErrorCode::Parse);
    ASSERT_TRUE(writeFileAtomically(folder_ / "a", "12345"));
    EXPECT_TRUE(readFile(folder_ / "a", 5));
    EXPECT_THAT(readFile(folder_ / "a", 4).error().message, HasSubstr("is 5 bytes, expected at most 4"));
}

TEST_F(FileTest, ReadsWhatTellsNoSize) {
    const auto nothing = readFile("/dev/null");
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->empty());
    const auto endless = readFile("/dev/zero", 1 << 20);
    ASSERT_FALSE(endless);
    EXPECT_EQ(endless.error().code, ErrorCode::Parse);
}

TEST_F(FileTest, AFailedWriteLeavesTheOldFile) {
    const auto path = folder_ / "a";
    ASSERT_TRUE(writeFileAtomically(path, "old"));
    const auto failed = writeFileAtomically(path, [](const fs::path& target) -> Result<void> {
        std::ofstream(target) << "half";
        return Error{ErrorCode::OutOfResources, "disk full", "there"};
    });
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().message, "disk full");
    EXPECT_EQ(*readFile(path), "old");
    EXPECT_EQ(filesThere(), 1U);
}

TEST_F(FileTest, AFullDiskAndAMissingFolderAreTold) {
    const auto full = writeFileAtomically("/dev/full", "bytes");
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().code, ErrorCode::OutOfResources);
    const auto nowhere = writeFileAtomically(folder_ / "none/a", "bytes");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(nowhere.error().where, (folder_ / "none/a").string()) << "the user's name, not that of the temporary file";
    EXPECT_TRUE(writeFileAtomically("/dev/null", "bytes"));
}

TEST(ContentHash, IsXxh3) {
    EXPECT_EQ(contentHash(""), "2d06800538d394c2");  // the reference implementation's value of no bytes
    EXPECT_NE(contentHash("a"), contentHash("b"));
    EXPECT_EQ(contentHash("luxdeck").size(), 16U);
}

}  // namespace
}  // namespace luxdeck

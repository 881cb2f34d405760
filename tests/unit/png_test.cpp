#include "engine/core/file.h"
#include "engine/io/image_files.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;

class Png : public ::testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("luxdeck_png_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    fs::path folder;
};

DisplayImage sample() {
    DisplayImage image{13, 7, {}, {{"luxdeck:operator", "human"}, {"Title", "Büro, 500 lx"}, {"empty", ""}}};
    for (int i = 0; i < 13 * 7 * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i * 37));
    return image;
}

TEST_F(Png, KeepsPixelsAndText) {
    ASSERT_TRUE(writePng(folder / "a.png", sample()));
    const auto back = readPng(folder / "a.png");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->width, 13);
    EXPECT_EQ(back->height, 7);
    EXPECT_EQ(back->rgb, sample().rgb);
    EXPECT_EQ(back->text, sample().text);
}

TEST_F(Png, AnyTruncationOrFlippedByteIsAnErrorOrAPicture) {
    ASSERT_TRUE(writePng(folder / "a.png", sample()));
    const auto bytes = *readFile(folder / "a.png");
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(parsePng(std::string_view(bytes).substr(0, size), "cut.png")) << size;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        auto broken = bytes;
        broken[i] = static_cast<char>(broken[i] ^ 0x55);
        const auto image = parsePng(broken, "flipped.png");
        EXPECT_TRUE(image || image.error().code == ErrorCode::Parse) << i;
    }
}

TEST_F(Png, SaysWhatIsWrong) {
    EXPECT_EQ(readPng(folder / "none.png").error().code, ErrorCode::FileNotFound);
    EXPECT_EQ(parsePng("GIF89a..........", "x.png").error().code, ErrorCode::Parse);
    EXPECT_EQ(writePng(folder / "a.png", DisplayImage{2, 2, {1, 2, 3}, {}}).error().code, ErrorCode::InvalidArgument);
    auto badKey = sample();
    badKey.text["tab\there"] = "x";
    EXPECT_EQ(writePng(folder / "a.png", badKey).error().code, ErrorCode::InvalidArgument);
    EXPECT_FALSE(fs::exists(folder / "a.png"));
    if (fs::exists("/dev/full")) {
        EXPECT_EQ(writePng("/dev/full", sample()).error().code, ErrorCode::OutOfResources);
    }
}

}  // namespace
}  // namespace luxdeck

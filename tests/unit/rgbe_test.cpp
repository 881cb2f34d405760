#include "engine/core/file.h"
#include "engine/core/primaries.h"
#include "engine/core/rng.h"
#include "engine/io/image_files.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <cmath>
#include <limits>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;

class Rgbe : public ::testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("luxdeck_rgbe_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    fs::path folder;
};

/// Pixels (mantissas m, m, m, exponent 128 + 1) are (m + 0.5) / 128.
std::string pixel(int r, int g, int b, int e) {
    return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

std::string file(const std::string& variables, const std::string& resolution, const std::string& pixels) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + variables + "\n" + resolution + "\n" + pixels;
}

TEST_F(Rgbe, RoundTripsWithinTheFormatsPrecision) {
    for (const int width : {1, 7, 8, 300}) {
        Image image(width, 4, {"R", "G", "B"});
        RandomStream random(7);
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            const auto level = static_cast<float>(std::pow(10.0, -4 + 9 * random.uniform()));
            for (const char* name : {"R", "G", "B"})
                image.channel(name)[i] = i % 3 == 0 ? 50.0F : level * static_cast<float>(random.uniform());
        }
        image.text["VIEW"] = "-vtv -vh 60 -vv 40";
        ASSERT_TRUE(writeRgbe(folder / "a.hdr", image));
        const auto back = readHdrImage(folder / "a.hdr");
        ASSERT_TRUE(back) << back.error().text();
        EXPECT_EQ(back->text.at("VIEW"), "-vtv -vh 60 -vv 40");
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            const Rgb a = colours(image)[i], b = colours(*back)[i];
            // The largest mantissa is 128..255, read at its interval's middle: half a unit in 128.
            const float tolerance = a.max() * (0.5F / 128 + 1e-6F);
            EXPECT_NEAR(a.r, b.r, tolerance);
            EXPECT_NEAR(a.g, b.g, tolerance);
            EXPECT_NEAR(a.b, b.b, tolerance);
        }
    }
}

TEST_F(Rgbe, GreyIsLuminanceBy179WhateverThePrimaries) {
    for (const std::string primaries :
         {"", "PRIMARIES= .64 .33 .3 .6 .15 .06 .3127 .329\n", "PRIMARIES= .7 .3 .17 .8 .13 .05 .35 .36\n"}) {
        const auto image = parseRgbe(file(primaries, "-Y 1 +X 1", pixel(127, 127, 127, 129)), "grey.hdr");
        ASSERT_TRUE(image) << image.error().text();
        const double expected = 179 * 127.5 / 128;
        // Float pixels: 6e-8 relative, a matrix of terms up to 3 and their cancellation.
        for (const char* name : {"R", "G", "B"}) EXPECT_NEAR(image->channel(name)[0], expected, 1e-4) << primaries;
    }
}

TEST_F(Rgbe, LuminanceOfSaturatedColoursSurvivesTheChangeOfPrimaries) {
    const auto image = parseRgbe(file("", "-Y 1 +X 1", pixel(10, 200, 60, 129)), "green.hdr");
    ASSERT_TRUE(image);
    const double expected = 179 / 128.0 * (0.265074126 * 10.5 + 0.670114631 * 200.5 + 0.064811243 * 60.5);
    EXPECT_NEAR(luminance(colours(*image)[0]), expected, 1e-4 * expected);
}

TEST_F(Rgbe, ExposureAndColourCorrectionMultiplyUp) {
    const auto image =
        parseRgbe(file("PRIMARIES= .64 .33 .3 .6 .15 .06 .3127 .329\nEXPOSURE=2\nEXPOSURE= 2.5e+00\nCOLORCORR= 1 2 4\n",
                       "-Y 1 +X 1", pixel(127, 127, 127, 129)),
                  "e.hdr");
    ASSERT_TRUE(image) << image.error().text();
    const double one = 179 * 127.5 / 128 / 5;
    EXPECT_NEAR(image->channel("R")[0], one, 1e-4);
    EXPECT_NEAR(image->channel("G")[0], one / 2, 1e-4);
    EXPECT_NEAR(image->channel("B")[0], one / 4, 1e-4);
}

TEST_F(Rgbe, XyzIsCandelaAlreadyAndEqualEnergyIsWhite) {
    const auto image =
        parseRgbe("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel(127, 127, 127, 129), "x.hdr");
    ASSERT_TRUE(image) << image.error().text();
    for (const char* name : {"R", "G", "B"}) EXPECT_NEAR(image->channel(name)[0], 127.5 / 128, 1e-6);
}

TEST_F(Rgbe, AllEightOrientations) {
    // As seen: top row a b c, bottom row d e f.
    const std::string seen = "abcdef";
    const auto at = [&](int x, int y) { return seen[static_cast<std::size_t>(y * 3 + x)]; };
    for (const bool columns : {false, true})
        for (const bool right : {false, true})
            for (const bool bottom : {false, true}) {
                std::string pixels;
                const int slowCount = columns ? 3 : 2, fastCount = columns ? 2 : 3;
                for (int slow = 0; slow < slowCount; ++slow)
                    for (int fast = 0; fast < fastCount; ++fast) {
                        const int x = columns ? slow : fast, y = columns ? fast : slow;
                        pixels += pixel(100 + at(right ? 2 - x : x, bottom ? 1 - y : y), 0, 0, 136);
                    }
                const std::string xs = right ? "-X 3" : "+X 3", ys = bottom ? "+Y 2" : "-Y 2";
                const std::string resolution = columns ? xs + " " + ys : ys + " " + xs;
                const auto image =
                    parseRgbe("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nPRIMARIES= .64 .33 .3 .6 .15 .06 .3127 .329\n\n" +
                                  resolution + "\n" + pixels,
                              "o.hdr");
                ASSERT_TRUE(image) << image.error().text();
                ASSERT_EQ(image->width(), 3);
                ASSERT_EQ(image->height(), 2);
                for (int i = 0; i < 6; ++i)  // exponent 136 makes mantissas whole numbers
                    EXPECT_NEAR(image->channel("R")[static_cast<std::size_t>(i)] / 179,
                                100 + seen[static_cast<std::size_t>(i)] + 0.5, 1e-3)
                        << resolution;
            }
}

TEST_F(Rgbe, OldRunsCountToTheBase256) {
    // 1 + 2 + 256 pixels of one colour, in a scanline long enough for the new style too.
    const auto image =
        parseRgbe(file("", "-Y 1 +X 259", pixel(9, 8, 7, 128) + pixel(1, 1, 1, 2) + pixel(1, 1, 1, 1)), "r.hdr");
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_EQ(image->channel("R")[0], image->channel("R")[258]);
    EXPECT_GT(image->channel("R")[258], 0);
}

TEST_F(Rgbe, HostileFilesAreRefusedWithALine) {
    const struct {
        std::string bytes, says;
    } cases[] = {
        {"", "RADIANCE"},
        {"#?RADIANCE\n", "does not end"},
        {"#?RADIANCE\n\n-Y 1 +X 1\n", "FORMAT"},
        {"#?RADIANCE\nFORMAT=64-bit\n\n-Y 1 +X 1\n", "x.hdr:2"},
        {file("EXPOSURE=0\n", "-Y 1 +X 1", ""), "x.hdr:3"},
        {file("EXPOSURE=nan\n", "-Y 1 +X 1", ""), "above 0"},
        {file("EXPOSURE=1e300\n", "-Y 1 +X 1", ""), "product"},
        {file("PRIMARIES= 1 2 3\n", "-Y 1 +X 1", ""), "eight"},
        {file("PRIMARIES= .3 .3 .3 .3 .3 .3 .3 .3\n", "-Y 1 +X 1", ""), "span"},
        {file("", "-Y 1 -Y 1", "aaaa"), "resolution"},
        {file("", "-Y 0 +X 1", "aaaa"), "resolution"},
        {file("", "-Y 1.5 +X 1", "aaaa"), "resolution"},
        {file("", "-Y 65536 +X 65536", "aaaa"), "do not fit"},
        {file("", "-Y 20000 +X 20000", "aaaa"), "do not fit"},
        {file("", "-Y 1 +X 2", "aaaab"), "too early"},
        {file("", "-Y 1 +X 9", std::string("\2\2\0\12", 4)), "coded as"},
        {file("", "-Y 1 +X 9", std::string("\2\2\0\11\0a", 6)), "run of 0"},
        {file("", "-Y 1 +X 9",
              std::string("\2\2\0\11\xff"
                          "a",
                          6)),
         "run of 127"},
        {file("", "-Y 1 +X 2", pixel(1, 1, 1, 1) + pixel(1, 1, 1, 1)), "run of 1"},
        {file("", "-Y 1 +X 9",
              pixel(5, 1, 1, 1) + pixel(1, 1, 1, 0) + pixel(1, 1, 1, 0) + pixel(1, 1, 1, 0) + pixel(1, 1, 1, 0) +
                  pixel(1, 1, 1, 0)),
         "32 bits"},
    };
    for (const auto& c : cases) {
        const auto image = parseRgbe(c.bytes, "x.hdr");
        ASSERT_FALSE(image) << c.bytes;
        EXPECT_EQ(image.error().code, ErrorCode::Parse);
        EXPECT_NE(image.error().text().find(c.says), std::string::npos) << image.error().text() << " / " << c.says;
    }
}

TEST_F(Rgbe, AnyTruncationIsAnError) {
    Image image(20, 3, {"Y"});
    for (std::size_t i = 0; i < 60; ++i) image.channel("Y")[i] = static_cast<float>(i % 7);
    ASSERT_TRUE(writeRgbe(folder / "a.hdr", image));
    const auto bytes = *readFile(folder / "a.hdr");
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(parseRgbe(std::string_view(bytes).substr(0, size), "cut.hdr")) << size;
}

TEST_F(Rgbe, WhatTheFormatCannotHoldIsRefused) {
    Image image(2, 2, {"R", "G", "B"});
    image.channel("G")[3] = std::numeric_limits<float>::quiet_NaN();
    const auto written = writeRgbe(folder / "a.hdr", image);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(written.error().text().find("(1, 1)"), std::string::npos) << written.error().text();
    if (fs::exists("/dev/full")) {
        EXPECT_EQ(writeRgbe("/dev/full", Image(40, 40, {"Y"})).error().code, ErrorCode::OutOfResources);
    }
}

TEST_F(Rgbe, ReadsTheRadianceTestPicturesThatAreThere) {
    const fs::path data = fs::path(LUXDECK_SOURCE_DIR) / "../shared/data";
    if (!fs::exists(data)) GTEST_SKIP() << "no test data at " << data;
    int found = 0;
    for (const auto& entry : fs::recursive_directory_iterator(data)) {
        const auto extension = entry.path().extension();
        if (extension != ".hdr" && extension != ".pic") continue;
        ++found;
        const auto image = readRgbe(entry.path());
        EXPECT_TRUE(image) << image.error().text();
    }
    if (found == 0) GTEST_SKIP() << "no Radiance pictures under " << data;
}

}  // namespace
}  // namespace luxdeck

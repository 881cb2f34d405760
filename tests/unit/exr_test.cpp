#include "engine/core/file.h"
#include "engine/core/primaries.h"
#include "engine/io/image_files.h"

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <unistd.h>
#include <cmath>
#include <cstring>
#include <limits>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;

class Exr : public ::testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("luxdeck_exr_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    fs::path folder;
};

Image sample() {
    Image image(5, 3, {"R", "G", "B", "stderr.Y"});
    int n = 0;
    for (const auto& [name, values] : image.channels())
        for (float& v : image.channel(name)) v = 0.1F * static_cast<float>(++n);
    image.channel("R")[0] = std::numeric_limits<float>::quiet_NaN();
    image.channel("G")[1] = std::numeric_limits<float>::infinity();
    image.channel("B")[2] = 1e-38F;
    image.channel("B")[3] = -3e38F;
    image.text = {{"luxdeck:unit", "cd/m^2"}, {"luxdeck:algorithm", "path"}};
    image.numbers = {{"whiteLuminance", 1.0}, {"luxdeck:seconds", 1.0 / 3.0}, {"luxdeck:seed", 9007199254740991.0}};
    return image;
}

TEST_F(Exr, KeepsEveryBitOfEveryChannelAndAttribute) {
    const Image image = sample();
    ASSERT_TRUE(writeExr(folder / "a.exr", image));
    const auto back = readExr(folder / "a.exr");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->width(), 5);
    EXPECT_EQ(back->height(), 3);
    ASSERT_EQ(back->channels().size(), image.channels().size());
    for (const auto& [name, values] : image.channels())
        EXPECT_EQ(std::memcmp(values.data(), back->channel(name).data(), values.size() * sizeof(float)), 0) << name;
    EXPECT_EQ(back->text, image.text);
    EXPECT_EQ(back->numbers, image.numbers);
    EXPECT_EQ(back->weights, kRec709);
}

TEST_F(Exr, KeepsTheWorkingSpace) {
    Image image(1, 1, {"R", "G", "B"});
    image.weights = luminanceWeights(kRadianceChromaticities);
    ASSERT_TRUE(writeExr(folder / "a.exr", image));
    const auto back = readExr(folder / "a.exr");
    ASSERT_TRUE(back) << back.error().text();
    // Chromaticities are floats in the file: 6e-8 each, amplified a few times by the matrix.
    EXPECT_NEAR(back->weights.r, image.weights.r, 1e-6);
    EXPECT_NEAR(back->weights.g, image.weights.g, 1e-6);
}

TEST_F(Exr, MultipliesByWhiteLuminance) {
    Image image(1, 1, {"Y", "A"});
    image.channel("Y")[0] = 2;
    image.channel("A")[0] = 1;
    image.numbers["whiteLuminance"] = 100;
    ASSERT_TRUE(writeExr(folder / "a.exr", image));
    const auto back = readExr(folder / "a.exr");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->channel("Y")[0], 200);
    EXPECT_EQ(back->channel("A")[0], 1);
    EXPECT_EQ(back->numbers.at("whiteLuminance"), 1);
}

TEST_F(Exr, ReadsTiledHalfAndUint) {
    const Imath::Box2i window({2, 3}, {2 + 39, 3 + 19});
    Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), window);
    header.channels().insert("G", Imf::Channel(Imf::HALF));
    header.channels().insert("id", Imf::Channel(Imf::UINT));
    header.setTileDescription(Imf::TileDescription(16, 16));
    std::vector<half> g(800, half(0.5F));
    std::vector<unsigned> id(800);
    for (unsigned i = 0; i < 800; ++i) id[i] = i;
    {
        Imf::TiledOutputFile out((folder / "t.exr").c_str(), header);
        Imf::FrameBuffer buffer;
        buffer.insert("G", Imf::Slice::Make(Imf::HALF, g.data(), window));
        buffer.insert("id", Imf::Slice::Make(Imf::UINT, id.data(), window));
        out.setFrameBuffer(buffer);
        out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
    }
    const auto image = readExr(folder / "t.exr");
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_EQ(image->width(), 40);
    EXPECT_EQ(image->height(), 20);
    EXPECT_EQ(image->channel("G")[799], 0.5F);
    EXPECT_EQ(image->channel("id")[437], 437.0F);
    EXPECT_FALSE(image->numbers.contains("whiteLuminance"));
}

TEST_F(Exr, SaysWhatIsWrong) {
    EXPECT_EQ(readExr(folder / "none.exr").error().code, ErrorCode::FileNotFound);
    EXPECT_EQ(parseExr("not a picture", "x.exr").error().code, ErrorCode::Parse);
    EXPECT_EQ(parseExr("", "x.exr").error().code, ErrorCode::Parse);
    EXPECT_EQ(writeExr(folder / "a.exr", Image{}).error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(writeExr(folder / "no" / "a.exr", sample()).error().code, ErrorCode::InvalidArgument);
}

TEST_F(Exr, AnyTruncationIsAnError) {
    ASSERT_TRUE(writeExr(folder / "a.exr", sample()));
    const auto bytes = readFile(folder / "a.exr");
    ASSERT_TRUE(bytes);
    for (std::size_t size = 0; size < bytes->size(); ++size) {
        const auto image = parseExr(std::string_view(*bytes).substr(0, size), "cut.exr");
        ASSERT_FALSE(image) << size;
        EXPECT_EQ(image.error().code, ErrorCode::Parse) << image.error().text();
    }
}

TEST_F(Exr, RefusesASizeThatTheFileCannotHold) {
    ASSERT_TRUE(writeExr(folder / "a.exr", Image(8, 8, {"R", "G", "B"})));
    auto bytes = *readFile(folder / "a.exr");
    const auto at = bytes.find("dataWindow");
    ASSERT_NE(at, std::string::npos);
    // dataWindow \0 box2i \0 size(4) then xMin yMin xMax yMax, little-endian
    const std::size_t xMax = at + 11 + 6 + 4 + 8;
    const int huge = 10000;
    std::memcpy(bytes.data() + xMax, &huge, 4);
    std::memcpy(bytes.data() + xMax + 4, &huge, 4);
    const auto image = parseExr(bytes, "hostile.exr");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, ErrorCode::Parse);
    EXPECT_NE(image.error().text().find("do not fit"), std::string::npos) << image.error().text();
}

TEST_F(Exr, AFullDiskIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this machine";
    const auto written = writeExr("/dev/full", sample());
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::OutOfResources) << written.error().text();
}

TEST_F(Exr, ExtensionsChooseTheReader) {
    ASSERT_TRUE(writeExr(folder / "A.EXR", sample()));
    EXPECT_TRUE(readHdrImage(folder / "A.EXR"));
    EXPECT_EQ(readHdrImage(folder / "a.tif").error().code, ErrorCode::Unsupported);
}

}  // namespace
}  // namespace luxdeck

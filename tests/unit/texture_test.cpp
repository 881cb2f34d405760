#include "engine/scene/texture.h"

#include "engine/io/texture_image.h"

#include <gtest/gtest.h>
#include <jpeglib.h>
#include <png.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace luxdeck {
namespace {

/// Two texels side by side: black, white.
Texture blackWhite(bool srgb) {
    Texture t;
    t.width = 2;
    t.height = 1;
    t.rgba = {0, 0, 0, 255, 255, 255, 255, 255};
    t.srgb = srgb;
    return t;
}

std::string pngBytes(const std::vector<std::uint8_t>& pixels, int width, int height, std::uint32_t format) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = format;
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr);
    std::string bytes(size, '\0');
    png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
    return bytes;
}

std::string jpegBytes(int width, int height, std::uint8_t grey) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &buffer, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    std::vector<std::uint8_t> line(static_cast<std::size_t>(width) * 3, grey);
    for (int y = 0; y < height; ++y) {
        JSAMPROW row = line.data();
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    std::string bytes(reinterpret_cast<char*>(buffer), size);
    jpeg_destroy_compress(&jpeg);
    std::free(buffer);
    return bytes;
}

TEST(Texture, TexelMiddlesAreExactAndBetweenThemItIsLinear) {
    const auto t = blackWhite(false);
    EXPECT_EQ(t.sample({0.25F, 0.5F}).r, 0.0F);
    EXPECT_EQ(t.sample({0.75F, 0.5F}).r, 1.0F);
    EXPECT_FLOAT_EQ(t.sample({0.5F, 0.5F}).r, 0.5F);
}

TEST(Texture, MixesLightNotCodes) {
    // Half of black and white is half the light, not the light of code 0.5 (0.21).
    EXPECT_FLOAT_EQ(blackWhite(true).sample({0.5F, 0.5F}).g, 0.5F);
}

TEST(Texture, DecodesSrgb) {
    Texture t;
    t.width = t.height = 1;
    t.rgba = {10, 128, 255, 255};
    const Rgb c = t.sample({0.3F, 0.7F});
    EXPECT_FLOAT_EQ(c.r, 10 / 255.0F / 12.92F);  // the straight foot of the curve
    EXPECT_NEAR(c.g, 0.21586, 1e-5);             // IEC 61966-2-1 at 128/255, rounded to 5 digits
    EXPECT_EQ(c.b, 1.0F);
}

TEST(Texture, Wraps) {
    auto t = blackWhite(false);
    EXPECT_EQ(t.sample({-0.25F, 0.5F}).r, 1.0F);  // repeat: one texel left of the first is the last
    EXPECT_EQ(t.sample({3.25F, 0.5F}).r, 0.0F);
    t.wrapU = TextureWrap::Clamp;
    EXPECT_EQ(t.sample({-5.0F, 0.5F}).r, 0.0F);
    EXPECT_EQ(t.sample({5.0F, 0.5F}).r, 1.0F);
    t.wrapU = TextureWrap::Mirror;
    EXPECT_EQ(t.sample({-0.25F, 0.5F}).r, 0.0F);
    EXPECT_EQ(t.sample({1.25F, 0.5F}).r, 1.0F);
    EXPECT_EQ(t.sample({1.75F, 0.5F}).r, 0.0F);
}

TEST(Texture, SurvivesAnyCoordinate) {
    const auto t = blackWhite(true);
    for (const float u : {1e30F, -1e30F, NAN, INFINITY}) EXPECT_TRUE(isFinite(t.sample({u, u})));
    EXPECT_EQ(Texture{}.sample({0, 0}), Rgb{1.0F});
}

TEST(TextureSlot, TransformIsTheExtensionsExample) {
    // KHR_texture_transform: "utilizes only the lower left quadrant of the source image, rotated clockwise 90 degrees".
    TextureSlot slot;
    slot.offset = {0, 1};
    slot.rotation = kPi / 2;
    slot.scale = {0.5F, 0.5F};
    for (const Vec2& corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}}) {
        const Vec2 uv = slot.apply(corner);
        // cos(pi/2) in float is 4e-8: the corners may miss the quadrant by that times 0.5
        EXPECT_GE(uv.x, -1e-7F);
        EXPECT_LE(uv.x, 0.5F + 1e-7F);
        EXPECT_GE(uv.y, 0.5F - 1e-7F);
        EXPECT_LE(uv.y, 1.0F + 1e-7F);
    }
    EXPECT_EQ(TextureSlot{}.apply({0.3F, 0.4F}), (Vec2{0.3F, 0.4F}));
}

TEST(DecodeTexture, ReadsPngOfEveryKind) {
    const auto colour = decodeTexture(pngBytes({1, 2, 3, 250, 251, 252}, 2, 1, PNG_FORMAT_RGB), "c");
    ASSERT_TRUE(colour) << colour.error().text();
    EXPECT_EQ(colour->rgba, (std::vector<std::uint8_t>{1, 2, 3, 255, 250, 251, 252, 255}));
    const auto grey = decodeTexture(pngBytes({7, 9}, 1, 2, PNG_FORMAT_GRAY), "g");
    ASSERT_TRUE(grey);
    EXPECT_EQ(grey->height, 2);
    EXPECT_EQ(grey->rgba, (std::vector<std::uint8_t>{7, 7, 7, 255, 9, 9, 9, 255}));
    const auto alpha = decodeTexture(pngBytes({1, 2, 3, 4}, 1, 1, PNG_FORMAT_RGBA), "a");
    ASSERT_TRUE(alpha);
    EXPECT_EQ(alpha->rgba, (std::vector<std::uint8_t>{1, 2, 3, 4}));
}

TEST(DecodeTexture, ReadsJpeg) {
    const auto picture = decodeTexture(jpegBytes(20, 10, 128), "j");
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ(picture->width, 20);
    EXPECT_EQ(picture->rgba.size(), 20U * 10U * 4U);
    EXPECT_NEAR(picture->rgba[5], 128, 1);  // a flat picture survives but for rounding
    EXPECT_EQ(picture->rgba[3], 255);
}

TEST(DecodeTexture, RefusesDamage) {
    const std::string png = pngBytes(std::vector<std::uint8_t>(3000, 77), 100, 10, PNG_FORMAT_RGB);
    const std::string jpeg = jpegBytes(64, 64, 90);
    // The last 12 bytes are the end mark, without which the pixels are still whole.
    for (std::size_t keep = 0; keep < png.size() - 12; ++keep) EXPECT_FALSE(decodeTexture(png.substr(0, keep), "p")) << keep;
    EXPECT_FALSE(decodeTexture(jpeg.substr(0, jpeg.size() / 2), "j"));
    EXPECT_EQ(decodeTexture("GIF89a", "g").error().code, ErrorCode::Unsupported);
}

TEST(DecodeTexture, RefusesSizesItsBytesCannotHold) {
    // A JPEG whose header is patched to 8000 x 8000: the size stands 5 bytes after the frame marker.
    std::string jpeg = jpegBytes(8, 8, 90);
    const auto frame = jpeg.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    for (const std::size_t at : {frame + 5, frame + 7}) {
        jpeg[at] = static_cast<char>(8000 >> 8);
        jpeg[at + 1] = static_cast<char>(8000 & 0xFF);
    }
    const auto result = decodeTexture(jpeg, "bomb");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("8000 x 8000"), std::string::npos) << result.error().text();
}

}  // namespace
}  // namespace luxdeck

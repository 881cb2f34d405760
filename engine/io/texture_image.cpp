#include "engine/io/texture_image.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <csetjmp>
#include <jpeglib.h>
#include <jerror.h>
#include <png.h>

#include <vector>

namespace luxdeck {

namespace {

/// Both libraries report errors by longjmp, which skips destructors. So everything with a destructor lives
/// in the callers of the two decode functions, which touch only plain data after setjmp.
struct Decoding {
    std::string_view bytes;
    std::size_t position = 0;
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t>* rgba = nullptr;
    char message[JMSG_LENGTH_MAX] = "";
    bool unsupported = false;
    std::jmp_buf jump;
};

/// Refuses sizes before anything of that size is allocated. `pixelsPerByte` is what the format can at most
/// make of a byte.
bool sizeIsPlausible(Decoding& d, std::uint64_t pixelsPerByte) {
    const std::uint64_t pixels = static_cast<std::uint64_t>(d.width) * d.height;
    if (pixels > kMaxTexturePixels) {
        std::snprintf(d.message, sizeof d.message, "is %u x %u pixels, expected at most %llu in all", d.width, d.height,
                      static_cast<unsigned long long>(kMaxTexturePixels));
        d.unsupported = true;
        return false;
    }
    if (pixels > pixelsPerByte * d.bytes.size()) {
        std::snprintf(d.message, sizeof d.message, "claims %u x %u pixels, which its %zu bytes cannot hold", d.width,
                      d.height, d.bytes.size());
        return false;
    }
    return true;
}

[[noreturn]] void pngFailed(png_structp png, png_const_charp message) {
    auto* d = static_cast<Decoding*>(png_get_error_ptr(png));
    std::snprintf(d->message, sizeof d->message, "damaged PNG: %s", message);
    std::longjmp(d->jump, 1);
}

void pngIgnore(png_structp, png_const_charp) {}

void pngRead(png_structp png, png_bytep target, std::size_t count) {
    auto* d = static_cast<Decoding*>(png_get_io_ptr(png));
    if (count > d->bytes.size() - d->position) png_error(png, "it ends early");
    std::memcpy(target, d->bytes.data() + d->position, count);
    d->position += count;
}

bool decodePng(Decoding& d) {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &d, pngFailed, pngIgnore);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr || setjmp(d.jump) != 0) {
        png_destroy_read_struct(&png, &info, nullptr);
        return false;
    }
    png_set_read_fn(png, &d, pngRead);
    png_read_info(png, info);
    d.width = png_get_image_width(png, info);
    d.height = png_get_image_height(png, info);
    // Deflate makes at most 1032 bytes of one; a pixel may be a single bit.
    if (!sizeIsPlausible(d, 8 * 1032)) {
        png_destroy_read_struct(&png, &info, nullptr);
        return false;
    }
    png_set_expand(png);
    png_set_strip_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    const std::size_t rowBytes = static_cast<std::size_t>(d.width) * 4;
    if (png_get_rowbytes(png, info) != rowBytes) png_error(png, "its rows have an unexpected length");
    d.rgba->resize(rowBytes * d.height);
    for (int pass = 0; pass < passes; ++pass)
        for (std::uint32_t y = 0; y < d.height; ++y) png_read_row(png, d.rgba->data() + y * rowBytes, nullptr);
    png_destroy_read_struct(&png, &info, nullptr);
    return true;
}

[[noreturn]] void jpegFailed(j_common_ptr jpeg) {
    auto* d = static_cast<Decoding*>(jpeg->client_data);
    char text[JMSG_LENGTH_MAX];
    jpeg->err->format_message(jpeg, text);
    std::snprintf(d->message, sizeof d->message, "damaged JPEG: %.180s", text);
    std::longjmp(d->jump, 1);
}

void jpegMessage(j_common_ptr jpeg, int level) {
    if (level < 0 && jpeg->err->msg_code == JWRN_JPEG_EOF) jpegFailed(jpeg);  // libjpeg would fill up with grey
}

void jpegStart(jpeg_decompress_struct& jpeg, jpeg_error_mgr& errors, Decoding& d) {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = jpegFailed;
    errors.emit_message = jpegMessage;
    jpeg.client_data = &d;
}

bool decodeJpeg(Decoding& d, std::vector<std::uint8_t>& line) {
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpegStart(jpeg, errors, d);
    if (setjmp(d.jump) != 0) {
        jpeg_destroy_decompress(&jpeg);
        return false;
    }
    jpeg_create_decompress(&jpeg);
    jpeg.client_data = &d;
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(d.bytes.data()), d.bytes.size());
    jpeg_read_header(&jpeg, TRUE);
    d.width = jpeg.image_width;
    d.height = jpeg.image_height;
    // A block of 8 x 8 pixels takes at least one bit.
    bool good = sizeIsPlausible(d, 8 * 64);
    if (good && jpeg.num_components != 1 && jpeg.num_components != 3) {
        std::snprintf(d.message, sizeof d.message, "JPEG of %d components, expected 1 or 3", jpeg.num_components);
        d.unsupported = true;
        good = false;
    }
    if (good) {
        jpeg.out_color_space = JCS_RGB;
        jpeg_start_decompress(&jpeg);
        line.resize(static_cast<std::size_t>(d.width) * 3);
        d.rgba->resize(static_cast<std::size_t>(d.width) * d.height * 4);
        std::uint8_t* target = d.rgba->data();
        while (jpeg.output_scanline < jpeg.output_height) {
            JSAMPROW row = line.data();
            jpeg_read_scanlines(&jpeg, &row, 1);
            for (std::uint32_t x = 0; x < d.width; ++x, target += 4) {
                std::memcpy(target, row + 3 * static_cast<std::size_t>(x), 3);
                target[3] = 255;
            }
        }
        jpeg_finish_decompress(&jpeg);
    }
    jpeg_destroy_decompress(&jpeg);
    return good;
}

}  // namespace

Result<Texture> decodeTexture(std::string_view bytes, const std::string& name) {
    Texture texture;
    texture.name = name;
    std::vector<std::uint8_t> line;
    Decoding decoding;
    decoding.bytes = bytes;
    decoding.rgba = &texture.rgba;
    bool good = false;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"))
        good = decodePng(decoding);
    else if (bytes.starts_with("\xff\xd8\xff"))
        good = decodeJpeg(decoding, line);
    else
        return Error{ErrorCode::Unsupported, "is neither PNG nor JPEG", name};
    if (!good)
        return Error{decoding.unsupported ? ErrorCode::Unsupported : ErrorCode::Parse,
                     decoding.message[0] != 0 ? decoding.message : "cannot be decoded", name};
    texture.width = static_cast<int>(decoding.width);
    texture.height = static_cast<int>(decoding.height);
    return texture;
}

}  // namespace luxdeck

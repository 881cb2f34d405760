#include "engine/io/image_files.h"

#include "engine/core/file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <new>

namespace luxdeck {

namespace fs = std::filesystem;

namespace {

/// What libpng's callbacks need. libpng leaves by longjmp on an error, past no C++ object: functions that call
/// setjmp or sit between it and libpng own nothing; all memory is here, owned by their callers.
struct PngState {
    std::string_view in;             // what is left to read
    std::string out;                 // what has been written
    std::string message;             // what libpng complained of
    std::vector<png_bytep> rows;
    std::vector<png_text> texts;
    DisplayImage image;
    bool outOfMemory = false;
};

void onError(png_structp png, png_const_charp message) {
    auto* state = static_cast<PngState*>(png_get_error_ptr(png));
    state->message.assign(message);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}  // colour-profile oddities: no concern of 8-bit sRGB

void onRead(png_structp png, png_bytep to, std::size_t count) {
    auto* state = static_cast<PngState*>(png_get_io_ptr(png));
    if (count > state->in.size()) png_error(png, "the file ends too early");
    std::memcpy(to, state->in.data(), count);
    state->in.remove_prefix(count);
}

void onWrite(png_structp png, png_bytep from, std::size_t count) {
    auto* state = static_cast<PngState*>(png_get_io_ptr(png));
    try {
        state->out.append(reinterpret_cast<const char*>(from), count);
        return;
    } catch (const std::bad_alloc&) {
        state->outOfMemory = true;
    }
    png_error(png, "not enough memory");
}

void onFlush(png_structp) {}

bool encode(png_structp png, png_infop info, PngState& state) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &state, onWrite, onFlush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(state.image.width), static_cast<png_uint_32>(state.image.height),
                 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (!state.texts.empty()) png_set_text(png, info, state.texts.data(), static_cast<int>(state.texts.size()));
    png_write_info(png, info);
    png_write_image(png, state.rows.data());
    png_write_end(png, info);
    return true;
}

/// Reads up to the pixels and asks for 8-bit RGB, whatever the file has.
bool decodeHeader(png_structp png, png_infop info, PngState& state) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_read_fn(png, &state, onRead);
    png_set_user_limits(png, kLargestImageSide, kLargestImageSide);
    png_set_chunk_malloc_max(png, 1U << 20);
    png_set_chunk_cache_max(png, 1000);
    png_read_info(png, info);
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_strip_alpha(png);
    png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

bool decodePixels(png_structp png, png_infop info, PngState& state) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_image(png, state.rows.data());
    png_read_end(png, info);
    return true;
}

void makeRows(PngState& state) {
    const auto rowBytes = 3 * static_cast<std::size_t>(state.image.width);
    state.rows.clear();
    for (std::size_t y = 0; y < static_cast<std::size_t>(state.image.height); ++y)
        state.rows.push_back(state.image.rgb.data() + y * rowBytes);
}

/// libpng's two objects, freed together.
struct PngReader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    explicit PngReader(PngState& state)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &state, onError, onWarning)) {
        if (png != nullptr) info = png_create_info_struct(png);
    }
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

struct PngWriter {
    png_structp png = nullptr;
    png_infop info = nullptr;
    explicit PngWriter(PngState& state)
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &state, onError, onWarning)) {
        if (png != nullptr) info = png_create_info_struct(png);
    }
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
};

bool isKey(std::string_view key) {
    return !key.empty() && key.size() <= 79 && key.front() != ' ' && key.back() != ' ' &&
           std::ranges::all_of(key, [](char c) { return c >= 32 && c < 127; });
}

Result<void> addTexts(PngState& state, const std::string& where) {
    for (auto& [key, value] : state.image.text) {
        if (!isKey(key))
            return Error{ErrorCode::InvalidArgument,
                         fmt::format("text key '{}', expected 1 to 79 printable ASCII characters", key), where};
        const bool ascii = std::ranges::all_of(value, [](char c) { return static_cast<unsigned char>(c) < 128; });
        png_text text{};
        text.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(key.c_str());  // only read by libpng
        text.text = value.data();
        text.text_length = ascii ? value.size() : 0;
        text.itxt_length = ascii ? 0 : value.size();
        state.texts.push_back(text);
    }
    return {};
}

void readTexts(png_structp png, png_infop info, DisplayImage& image) {
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    for (int i = 0; i < count; ++i) {
        const auto length = std::max(texts[i].text_length, texts[i].itxt_length);
        image.text[texts[i].key] = std::string(texts[i].text, texts[i].text == nullptr ? 0 : length);
    }
}

/// That no chunk claims more than the file has: libpng clears a buffer of that size before it looks.
Result<void> checkChunks(std::string_view bytes, const std::string& where) {
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
    constexpr std::size_t kSignature = 8, kAroundData = 12;  // length, kind and checksum
    for (std::size_t at = kSignature; at < bytes.size();) {
        const std::size_t left = bytes.size() - at;
        const std::size_t length =
            left < 4 ? 0 : byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
        if (left < kAroundData || length > left - kAroundData)
            return Error{ErrorCode::Parse, fmt::format("the chunk at byte {} is cut off: {} bytes are left", at, left),
                         where};
        if (bytes.substr(at + 4, 4) == "IEND") return {};
        at += length + kAroundData;
    }
    return Error{ErrorCode::Parse, "ends without an IEND chunk", where};
}

Result<DisplayImage> decode(std::string_view bytes, const std::string& where) {
    PngState state;
    state.in = bytes;
    PngReader reader(state);
    if (reader.png == nullptr || reader.info == nullptr) throw std::bad_alloc();
    const auto broken = [&] {
        return Error{ErrorCode::Parse, fmt::format("is not a readable PNG: {}", state.message), where};
    };
    if (!decodeHeader(reader.png, reader.info, state)) return broken();

    const std::uint64_t width = png_get_image_width(reader.png, reader.info),
                        height = png_get_image_height(reader.png, reader.info);
    // zlib shrinks 1032 times at the very most, and a pixel is at least one bit.
    if (width * height * 3 > kMostImageValues || width * height / 8 > bytes.size() * 1032)
        return Error{ErrorCode::Parse,
                     fmt::format("{} x {} pixels do not fit in a file of {} bytes", width, height, bytes.size()),
                     where};
    if (png_get_rowbytes(reader.png, reader.info) != 3 * width)
        return Error{ErrorCode::Internal, "libpng did not convert the picture to 8-bit RGB", where};
    state.image.width = static_cast<int>(width);
    state.image.height = static_cast<int>(height);
    state.image.rgb.resize(width * height * 3);
    makeRows(state);
    if (!decodePixels(reader.png, reader.info, state)) return broken();
    readTexts(reader.png, reader.info, state.image);
    return std::move(state.image);
}

Result<std::string> encoded(const DisplayImage& image, const std::string& where) {
    PngState state;
    state.image = image;
    makeRows(state);
    if (auto ok = addTexts(state, where); !ok) return ok.error();
    PngWriter writer(state);
    if (writer.png == nullptr || writer.info == nullptr) throw std::bad_alloc();
    if (!encode(writer.png, writer.info, state)) {
        if (state.outOfMemory) throw std::bad_alloc();
        return Error{ErrorCode::Internal, fmt::format("cannot be written as PNG: {}", state.message), where};
    }
    return std::move(state.out);
}

}  // namespace

Result<void> writePng(const fs::path& path, const DisplayImage& image) {
    const bool sizeFits =
        image.width > 0 && image.height > 0 && image.width <= kLargestImageSide && image.height <= kLargestImageSide &&
        image.rgb.size() == 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (!sizeFits)
        return Error{
            ErrorCode::InvalidArgument,
            fmt::format("{} bytes for {} x {} pixels, expected 3 a pixel", image.rgb.size(), image.width, image.height),
            path.string()};
    try {
        const auto bytes = encoded(image, path.string());
        if (!bytes) return bytes.error();
        return writeFileAtomically(path, *bytes);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "not enough memory to write the picture", path.string()};
    }
}

Result<DisplayImage> parsePng(std::string_view bytes, const fs::path& name) {
    if (bytes.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) != 0)
        return Error{ErrorCode::Parse, "does not begin as a PNG file does", name.string()};
    try {
        if (auto ok = checkChunks(bytes, name.string()); !ok) return ok.error();
        return decode(bytes, name.string());
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "not enough memory to read the picture", name.string()};
    }
}

Result<DisplayImage> readPng(const fs::path& path) {
    auto bytes = readFile(path);
    if (!bytes) return bytes.error();
    return parsePng(*bytes, path);
}

}  // namespace luxdeck

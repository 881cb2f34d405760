#include "engine/io/gltf_uri.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>

namespace luxdeck::gltf {

namespace {

constexpr std::uint8_t kNotBase64 = 255;

std::array<std::uint8_t, 256> base64Values() {
    std::array<std::uint8_t, 256> values{};
    values.fill(kNotBase64);
    const std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    return values;
}

Result<std::string> decodeBase64(std::string_view text) {
    static const auto kValues = base64Values();
    for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    int bitCount = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint8_t value = kValues[static_cast<unsigned char>(text[i])];
        if (value == kNotBase64)
            return Error{ErrorCode::Parse, fmt::format("byte {} of the embedded data is not base64", i), ""};
        bits = bits << 6 | value;
        bitCount += 6;
        if (bitCount < 8) continue;
        bitCount -= 8;
        bytes.push_back(static_cast<char>(bits >> bitCount & 0xFF));
    }
    if (bitCount == 6) return Error{ErrorCode::Parse, "embedded base64 data is cut off", ""};
    return bytes;
}

}  // namespace

std::string percentDecoded(std::string_view uri) {
    std::string result;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned code = 0;
        if (uri[i] == '%' && i + 2 < uri.size()) {
            const auto [end, error] = std::from_chars(uri.data() + i + 1, uri.data() + i + 3, code, 16);
            if (error == std::errc() && end == uri.data() + i + 3) {
                result.push_back(static_cast<char>(code));
                i += 2;
                continue;
            }
        }
        result.push_back(uri[i]);
    }
    return result;
}

std::optional<Result<std::string>> decodeDataUri(std::string_view uri) {
    if (!uri.starts_with("data:")) return std::nullopt;
    const auto comma = uri.find(',');
    if (comma == std::string_view::npos) return Error{ErrorCode::Parse, "data URI without a comma", ""};
    const auto header = uri.substr(0, comma);
    const auto body = uri.substr(comma + 1);
    if (header.ends_with(";base64")) return decodeBase64(body);
    return Result<std::string>(percentDecoded(body));
}

Result<std::filesystem::path> resolveBelow(const std::filesystem::path& folder, std::string_view reference) {
    const auto refused = [&](const char* why) {
        return Error{ErrorCode::Unsupported,
                     fmt::format("names '{}', {}; expected a file in this file's folder or below it", reference, why), ""};
    };
    if (reference.empty() || reference.find('\0') != std::string_view::npos) return refused("which is no file name");
    const auto colon = reference.find(':');
    if (colon != std::string_view::npos && reference.find('/') > colon) return refused("which has a scheme or a drive");
    const std::filesystem::path relative = std::filesystem::path(reference).lexically_normal();
    if (relative.is_absolute()) return refused("which is absolute");
    if (relative.empty() || *relative.begin() == "..") return refused("which leads out of the folder");
    return folder / relative;
}

}  // namespace luxdeck::gltf

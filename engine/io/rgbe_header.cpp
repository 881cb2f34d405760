#include "engine/io/rgbe_header.h"

#include "engine/io/image_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace luxdeck {

namespace {

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> out;
    constexpr std::string_view kSpace = " \t\r";
    while (true) {
        const auto begin = text.find_first_not_of(kSpace);
        if (begin == std::string_view::npos) return out;
        text.remove_prefix(begin);
        const auto end = std::min(text.find_first_of(kSpace), text.size());
        out.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
}

std::optional<double> number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, ec] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (ec != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return {};
    return value;
}

/// Exactly `count` finite numbers, or nothing.
std::optional<std::vector<double>> numbers(std::string_view text, std::size_t count) {
    std::vector<double> out;
    for (const auto word : words(text)) {
        const auto value = number(word);
        if (!value) return {};
        out.push_back(*value);
    }
    if (out.size() != count) return {};
    return out;
}

/// The header under construction, and where reading it stands.
class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Result<RgbeHeader> read() {
        auto line = nextLine();
        if (!line || !line->starts_with("#?")) return failure("does not begin with '#?RADIANCE'");
        bool formatSeen = false;
        while ((line = nextLine()) && !line->empty()) {
            if (line->starts_with("FORMAT=")) formatSeen = true;
            if (auto ok = readVariable(*line); !ok) return ok.error();
        }
        if (!line) return failure("the header does not end: expected an empty line");
        if (!formatSeen) return failure("the header has no FORMAT= line");
        line = nextLine();
        if (!line) return failure("ends before the resolution line");
        if (auto ok = readResolution(*line); !ok) return ok.error();
        header_.byteSize = position_;
        return header_;
    }

private:
    static constexpr std::size_t kLongestLine = 1 << 16;

    std::optional<std::string_view> nextLine() {
        const auto rest = bytes_.substr(position_, kLongestLine);
        const auto end = rest.find('\n');
        if (end == std::string_view::npos) return {};
        position_ += end + 1;
        ++line_;
        auto line = rest.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    [[nodiscard]] Error failure(const std::string& message) const {
        return {ErrorCode::Parse, message, fmt::format("{}:{}", name_, line_)};
    }

    Result<void> readFormat(std::string_view value) {
        const auto format = words(value);
        if (format.size() == 1 && format[0] == "32-bit_rle_rgbe") header_.xyz = false;
        else if (format.size() == 1 && format[0] == "32-bit_rle_xyze") header_.xyz = true;
        else return failure(fmt::format("FORMAT is '{}', expected 32-bit_rle_rgbe or 32-bit_rle_xyze", value));
        return {};
    }

    Result<void> readVariable(std::string_view line) {
        const auto equals = line.find('=');
        if (equals == std::string_view::npos) return {};  // a command of the picture's history
        const auto key = line.substr(0, equals), value = line.substr(equals + 1);
        if (key == "FORMAT") return readFormat(value);
        if (key == "VIEW") {
            header_.view = value.substr(std::min(value.find_first_not_of(' '), value.size()));
        } else if (key == "EXPOSURE" || key == "PIXASPECT") {
            const auto factor = numbers(value, 1);
            if (!factor || factor->front() <= 0)
                return failure(fmt::format("{}= is '{}', expected a number above 0", key, value));
            double& product = key == "EXPOSURE" ? header_.exposure : header_.pixelAspect;
            product *= factor->front();
            if (!(product > 1e-30 && product < 1e30))
                return failure(fmt::format("the product of {}= lines is {}", key, product));
        } else if (key == "COLORCORR") {
            const auto factors = numbers(value, 3);
            if (!factors || (*factors)[0] <= 0 || (*factors)[1] <= 0 || (*factors)[2] <= 0)
                return failure(fmt::format("COLORCORR= is '{}', expected three numbers above 0", value));
            header_.correction *= Rgb(static_cast<float>((*factors)[0]), static_cast<float>((*factors)[1]),
                                      static_cast<float>((*factors)[2]));
        } else if (key == "PRIMARIES") {
            return readPrimaries(value);
        }
        return {};
    }

    Result<void> readPrimaries(std::string_view value) {
        const auto n = numbers(value, 8);
        if (!n) return failure(fmt::format("PRIMARIES= is '{}', expected eight numbers", value));
        const auto& v = *n;
        header_.primaries = {v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]};
        if (!isUsable(header_.primaries)) return failure(fmt::format("PRIMARIES= {} span no colours", value));
        return {};
    }

    Result<void> readResolution(std::string_view line) {
        const auto w = words(line);
        const auto expected = [&] {
            return failure(fmt::format("resolution line '{}', expected one such as '-Y 480 +X 640', 1 to {} a side",
                                       line.substr(0, 80), kLargestImageSide));
        };
        if (w.size() != 4) return expected();
        bool seenX = false, seenY = false;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto direction = w[2 * axis];
            const auto size = number(w[2 * axis + 1]);
            if (!size || *size < 1 || *size > kLargestImageSide || *size != std::floor(*size)) return expected();
            if (direction == "+X" || direction == "-X") {
                seenX = true;
                header_.width = static_cast<int>(*size);
                header_.fromRight = direction == "-X";
                header_.columnsFirst = axis == 0;
            } else if (direction == "+Y" || direction == "-Y") {
                seenY = true;
                header_.height = static_cast<int>(*size);
                header_.fromBottom = direction == "+Y";
            } else {
                return expected();
            }
        }
        if (!seenX || !seenY) return expected();
        return {};
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t position_ = 0;
    int line_ = 0;
    RgbeHeader header_;
};

}  // namespace

Result<RgbeHeader> parseRgbeHeader(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

}  // namespace luxdeck

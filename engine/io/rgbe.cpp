#include "engine/io/image_files.h"

#include "engine/core/file.h"
#include "engine/io/rgbe_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

namespace luxdeck {

namespace fs = std::filesystem;

namespace {

constexpr double kLumensPerWatt = 179;  // Radiance's bookkeeping constant, not the SI's 683
constexpr int kShortestRun = 4;         // a shorter run costs more bytes than it saves

using Rgbe = std::array<std::uint8_t, 4>;

/// The middle of the interval that the mantissas stand for. Source: Radiance color.h.
Rgb decode(const Rgbe& p) {
    if (p[3] == 0) return {};
    const float scale = std::ldexp(1.0F, static_cast<int>(p[3]) - (128 + 8));
    return {(static_cast<float>(p[0]) + 0.5F) * scale, (static_cast<float>(p[1]) + 0.5F) * scale,
            (static_cast<float>(p[2]) + 0.5F) * scale};
}

Rgbe encode(const Rgb& c) {
    if (c.max() < 1e-32F) return {};
    int exponent = 0;
    std::frexp(c.max(), &exponent);
    if (exponent > 127) return {255, 255, 255, 255};
    const auto mantissa = [&](float v) {
        return static_cast<std::uint8_t>(std::clamp(std::ldexp(v, 8 - exponent), 0.0F, 255.0F));
    };
    return {mantissa(c.r), mantissa(c.g), mantissa(c.b), static_cast<std::uint8_t>(exponent + 128)};
}

/// Decodes scanlines one after another. Source: the formats of Radiance's color.c, old and new.
class ScanlineReader {
public:
    ScanlineReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Result<void> read(std::vector<Rgbe>& line) {
        ++scanline_;
        const auto length = line.size();
        const bool mayBeNew = length >= 8 && length < 32768;
        if (mayBeNew && left() >= 4 && byte(0) == 2 && byte(1) == 2 && byte(2) < 128) {
            const std::size_t coded = byte(2) << 8U | byte(3);
            if (coded != length) return failure(fmt::format("is coded as {} pixels, expected {}", coded, length));
            position_ += 4;
            return readPlanes(line);
        }
        return readOld(line);
    }

private:
    [[nodiscard]] std::size_t left() const { return bytes_.size() - position_; }
    [[nodiscard]] unsigned byte(std::size_t ahead) const {
        return static_cast<unsigned char>(bytes_[position_ + ahead]);
    }
    [[nodiscard]] Error failure(const std::string& message) const {
        return {ErrorCode::Parse, fmt::format("scanline {} {}", scanline_, message), name_};
    }

    Result<void> readPlanes(std::vector<Rgbe>& line) {
        for (std::size_t plane = 0; plane < 4; ++plane) {
            for (std::size_t x = 0; x < line.size();) {
                if (left() < 2) return failure("ends too early");
                const bool run = byte(0) > 128;
                const std::size_t count = run ? byte(0) - 128 : byte(0);
                ++position_;
                if (count == 0 || count > line.size() - x)
                    return failure(fmt::format("has a run of {} where {} pixels are left", count, line.size() - x));
                if (!run && left() < count) return failure("ends too early");
                for (std::size_t i = 0; i < count; ++i)
                    line[x + i][plane] = static_cast<std::uint8_t>(byte(run ? 0 : i));
                position_ += run ? 1 : count;
                x += count;
            }
        }
        return {};
    }

    /// Plain pixels, with (1, 1, 1, n) for n more of the last one; several of them in a row are the digits of
    /// a count to the base 256, the lowest first.
    Result<void> readOld(std::vector<Rgbe>& line) {
        unsigned shift = 0;
        for (std::size_t x = 0; x < line.size();) {
            if (left() < 4) return failure("ends too early");
            const Rgbe p{static_cast<std::uint8_t>(byte(0)), static_cast<std::uint8_t>(byte(1)),
                         static_cast<std::uint8_t>(byte(2)), static_cast<std::uint8_t>(byte(3))};
            position_ += 4;
            if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
                line[x++] = p;
                shift = 0;
                continue;
            }
            if (shift > 24) return failure("has a run count of more than 32 bits");
            const std::size_t count = static_cast<std::size_t>(p[3]) << shift;
            shift += 8;
            if (x == 0 || count > line.size() - x)
                return failure(fmt::format("has a run of {} where {} pixels are left", count, line.size() - x));
            std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(x), count, line[x - 1]);
            x += count;
        }
        return {};
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t position_ = 0;
    int scanline_ = 0;
};

/// From the file's numbers to Rec.709 in cd/m^2.
Imath::M33d toCandela(const RgbeHeader& header) {
    const double scale = (header.xyz ? 1.0 : kLumensPerWatt) / header.exposure;
    const auto& k = header.correction;
    const Imath::M33d correction(scale / k.r, 0, 0, 0, scale / k.g, 0, 0, 0, scale / k.b);
    return correction *
           (header.xyz ? xyzToRgb(kRec709Chromaticities) : rgbToRgb(header.primaries, kRec709Chromaticities));
}

Result<Image> decodePixels(std::string_view bytes, const RgbeHeader& header, const std::string& name) {
    const auto pixels = static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height);
    // New runs cover 127 pixels with 2 bytes a plane; the old style's 12 bytes code at most 65,536 pixels, and a
    // scanline of one colour that is wider than 12,288 is not worth letting hostile headers ask for gigabytes.
    if (pixels * 3 > kMostImageValues || pixels > bytes.size() * 1024)
        return Error{
            ErrorCode::Parse,
            fmt::format("{} x {} pixels do not fit in the file's {} bytes", header.width, header.height, bytes.size()),
            name};

    Image image(header.width, header.height, {"R", "G", "B"});
    auto &r = image.channel("R"), &g = image.channel("G"), &b = image.channel("B");
    const Imath::M33d matrix = toCandela(header);
    ScanlineReader reader(bytes, name);
    std::vector<Rgbe> line(static_cast<std::size_t>(header.scanlineLength()));
    for (int slow = 0; slow < header.scanlineCount(); ++slow) {
        if (auto ok = reader.read(line); !ok) return ok.error();
        for (int fast = 0; fast < header.scanlineLength(); ++fast) {
            const int x = header.columnsFirst ? slow : fast, y = header.columnsFirst ? fast : slow;
            const auto i =
                image.index(header.fromRight ? header.width - 1 - x : x, header.fromBottom ? header.height - 1 - y : y);
            const Rgb c = transformed(decode(line[static_cast<std::size_t>(fast)]), matrix);
            r[i] = c.r, g[i] = c.g, b[i] = c.b;
        }
    }
    return image;
}

/// One plane of a new-style scanline: runs of 4 and more as such, what lies between as literals.
void appendPlane(std::string& out, const std::vector<Rgbe>& line, std::size_t plane) {
    const auto runAt = [&](std::size_t x) {
        std::size_t end = x + 1;
        while (end < line.size() && end - x < 127 && line[end][plane] == line[x][plane]) ++end;
        return end - x;
    };
    std::size_t literal = 0;  // first pixel not written yet
    const auto flush = [&](std::size_t end) {
        while (literal < end) {
            const auto count = std::min<std::size_t>(128, end - literal);
            out += static_cast<char>(count);
            for (std::size_t i = 0; i < count; ++i) out += static_cast<char>(line[literal++][plane]);
        }
    };
    for (std::size_t x = 0; x < line.size();) {
        const auto run = runAt(x);
        if (run >= kShortestRun) {
            flush(x);
            out += static_cast<char>(128 + run);
            out += static_cast<char>(line[x][plane]);
            literal = x + run;
        }
        x += run;
    }
    flush(line.size());
}

void appendScanline(std::string& out, const std::vector<Rgbe>& line) {
    if (line.size() >= 8 && line.size() < 32768) {
        out += {2, 2, static_cast<char>(line.size() >> 8), static_cast<char>(line.size() & 255)};
        for (std::size_t plane = 0; plane < 4; ++plane) appendPlane(out, line, plane);
    } else {
        // Flat pixels: black and mantissas of our own encoder are never (1, 1, 1, n), for one of them is >= 128.
        for (const auto& p : line) out.append(reinterpret_cast<const char*>(p.data()), p.size());
    }
}

std::string headerText(const Image& image) {
    const auto c = chromaticitiesOf(image.weights);
    std::string out = "#?RADIANCE\nSOFTWARE=Luxdeck\nFORMAT=32-bit_rle_rgbe\n";
    out += fmt::format("PRIMARIES= {} {} {} {} {} {} {} {}\n", c.redX, c.redY, c.greenX, c.greenY, c.blueX, c.blueY,
                       c.whiteX, c.whiteY);
    if (const auto view = image.text.find("VIEW");
        view != image.text.end() && view->second.find('\n') == std::string::npos)
        out += fmt::format("VIEW= {}\n", view->second);
    return out + fmt::format("\n-Y {} +X {}\n", image.height(), image.width());
}

}  // namespace

Result<Image> parseRgbe(std::string_view bytes, const fs::path& name) {
    const auto header = parseRgbeHeader(bytes, name.string());
    if (!header) return header.error();
    try {
        auto image = decodePixels(bytes.substr(header->byteSize), *header, name.string());
        if (!image) return image;
        if (!header->view.empty()) image->text["VIEW"] = header->view;
        image->text["luxdeck:unit"] = "cd/m^2";
        image->numbers["whiteLuminance"] = 1;
        if (header->pixelAspect != 1) image->numbers["pixelAspect"] = header->pixelAspect;
        return image;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "not enough memory to read the picture", name.string()};
    }
}

Result<Image> readRgbe(const fs::path& path) {
    auto bytes = readFile(path);
    if (!bytes) return bytes.error();
    return parseRgbe(*bytes, path);
}

Result<void> writeRgbe(const fs::path& path, const Image& image) {
    if (image.empty() || (!image.hasColour() && !image.has("Y")))
        return Error{ErrorCode::InvalidArgument, "the picture has no R, G, B and no Y channel", path.string()};
    const auto pixels = colours(image);
    std::string bytes = headerText(image);
    std::vector<Rgbe> line(static_cast<std::size_t>(image.width()));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Rgb& c = pixels[image.index(x, y)];
            if (!isFinite(c))
                return Error{ErrorCode::InvalidArgument,
                             fmt::format("pixel ({}, {}) is not finite, which RGBE cannot hold: write .exr", x, y),
                             path.string()};
            line[static_cast<std::size_t>(x)] = encode(c * static_cast<float>(1.0 / kLumensPerWatt));
        }
        appendScanline(bytes, line);
    }
    return writeFileAtomically(path, bytes);
}

}  // namespace luxdeck

#include "engine/io/image_files.h"

#include "engine/core/file.h"
#include "engine/core/primaries.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVersion.h>
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

namespace luxdeck {

namespace fs = std::filesystem;

namespace {

/// OpenEXR's view of bytes in memory.
class MemoryInput : public Imf::IStream {
public:
    MemoryInput(std::string_view bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}

    bool read(char c[], int n) override {
        if (n < 0 || static_cast<std::uint64_t>(n) > bytes_.size() - position_)
            throw std::runtime_error("the file ends too early");
        std::memcpy(c, bytes_.data() + position_, static_cast<std::size_t>(n));
        position_ += static_cast<std::size_t>(n);
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override {
        if (position > bytes_.size()) throw std::runtime_error("an offset points past the end of the file");
        position_ = position;
    }

private:
    std::string_view bytes_;
    std::size_t position_ = 0;
};

/// A file in memory: OpenEXR's own output swallows a full disk in its destructor.
class MemoryOutput : public Imf::OStream {
public:
    explicit MemoryOutput(const std::string& name) : OStream(name.c_str()) {}

    void write(const char c[], int n) override {
        const auto count = static_cast<std::size_t>(n);
        if (position_ + count > bytes.size()) bytes.resize(position_ + count);
        std::memcpy(bytes.data() + position_, c, count);
        position_ += count;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::string bytes;

private:
    std::size_t position_ = 0;
};

/// Attributes that say how the file is laid out: the library's own, never Image::text or Image::numbers.
bool isStructural(std::string_view name) {
    for (const std::string_view reserved :
         {"channels", "compression", "dataWindow", "displayWindow", "lineOrder", "pixelAspectRatio",
          "screenWindowCenter", "screenWindowWidth", "chromaticities", "tiles", "type", "version", "chunkCount", "name",
          "view", "maxSamplesPerPixel", "dwaCompressionLevel", "zipCompressionLevel"})
        if (name == reserved) return true;
    return false;
}

Imf::Header headerOf(const Image& image) {
    Imf::Header header(image.width(), image.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, values] : image.channels()) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const auto c = chromaticitiesOf(image.weights);
    const auto point = [](double x, double y) { return Imath::V2f(static_cast<float>(x), static_cast<float>(y)); };
    Imf::addChromaticities(header, Imf::Chromaticities(point(c.redX, c.redY), point(c.greenX, c.greenY),
                                                       point(c.blueX, c.blueY), point(c.whiteX, c.whiteY)));
    for (const auto& [name, value] : image.text)
        if (!name.empty() && !isStructural(name)) header.insert(name, Imf::StringAttribute(value));
    for (const auto& [name, value] : image.numbers) {
        if (name.empty() || isStructural(name)) continue;
        if (name == "whiteLuminance")
            Imf::addWhiteLuminance(header, static_cast<float>(value));  // a float by the standard
        else header.insert(name, Imf::DoubleAttribute(value));
    }
    return header;
}

void readAttributes(const Imf::Header& header, Image& image) {
    for (auto it = header.begin(); it != header.end(); ++it) {
        const std::string name = it.name();
        if (isStructural(name)) continue;
        if (const auto* s = dynamic_cast<const Imf::StringAttribute*>(&it.attribute())) image.text[name] = s->value();
        else if (const auto* f = dynamic_cast<const Imf::FloatAttribute*>(&it.attribute()))
            image.numbers[name] = f->value();
        else if (const auto* d = dynamic_cast<const Imf::DoubleAttribute*>(&it.attribute()))
            image.numbers[name] = d->value();
        else if (const auto* i = dynamic_cast<const Imf::IntAttribute*>(&it.attribute()))
            image.numbers[name] = i->value();
    }
    if (!Imf::hasChromaticities(header)) return;
    const auto& c = Imf::chromaticities(header);
    const Chromaticities found{c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
    if (isUsable(found)) image.weights = luminanceWeights(found);
}

/// Lines that share a chunk; fewer chunks than these cannot hold a picture.
int linesPerChunk(Imf::Compression compression) {
    switch (compression) {
        case Imf::ZIP_COMPRESSION:
        case Imf::PXR24_COMPRESSION: return 16;
        case Imf::PIZ_COMPRESSION:
        case Imf::B44_COMPRESSION:
        case Imf::B44A_COMPRESSION:
        case Imf::DWAA_COMPRESSION: return 32;
        case Imf::DWAB_COMPRESSION: return 256;
        default: return 1;
    }
}

/// A tile may be larger than the picture, and OpenEXR makes room for the whole of one.
///
/// mostValues  that the file's size can hold
Result<void> checkTiles(const Imf::Header& header, std::uint64_t channelCount, std::uint64_t mostValues, const std::string& where) {
    if (!header.hasTileDescription()) return {};
    const auto& tile = header.tileDescription();
    constexpr std::uint64_t kAlways = 512ULL * 512ULL;  // pixels; writers use 16 to 256 a side
    const auto pixels = std::uint64_t{tile.xSize} * tile.ySize;
    if (tile.xSize < 1 || tile.ySize < 1 || tile.xSize > kLargestImageSide || tile.ySize > kLargestImageSide ||
        (pixels > kAlways && pixels * channelCount > mostValues))
        return Error{ErrorCode::Parse, fmt::format("tiles of {} x {} pixels, expected what the file can hold", tile.xSize, tile.ySize), where};
    return {};
}

/// What the header promises against what the file's size can hold, before anything is allocated.
Result<void> checkHeader(const Imf::Header& header, std::size_t byteSize, const std::string& where) {
    const auto& window = header.dataWindow();
    const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1;
    const auto height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
    // A part may say itself how many chunks it has; each has a place in a table of 8 bytes.
    if (header.hasChunkCount() && (header.chunkCount() < 0 || static_cast<std::uint64_t>(header.chunkCount()) * 8 > byteSize))
        return Error{ErrorCode::Parse, fmt::format("{} chunks do not fit in a file of {} bytes", header.chunkCount(), byteSize), where};
    if (width < 1 || height < 1 || width > kLargestImageSide || height > kLargestImageSide)
        return Error{
            ErrorCode::Parse,
            fmt::format("a picture of {} x {} pixels, expected 1 to {} a side", width, height, kLargestImageSide),
            where};

    std::uint64_t channelCount = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it, ++channelCount)
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            return Error{ErrorCode::Unsupported,
                         fmt::format("channel '{}' is subsampled, expected one value a pixel", it.name()), where};
    if (channelCount == 0) return Error{ErrorCode::Parse, "has no channels", where};

    const auto values = static_cast<std::uint64_t>(width * height) * channelCount;
    if (values > kMostImageValues)
        return Error{ErrorCode::Parse,
                     fmt::format("{} values in all channels, expected at most {}", values, kMostImageValues), where};
    const auto compression = header.compression();
    // A chunk is at least 8 bytes in the offset table and 8 of its own. zlib shrinks 1032 times at the very most;
    // a black picture in a wavelet or DCT codec was seen to shrink 36,000 times.
    const auto chunks = static_cast<std::uint64_t>(height) / static_cast<std::uint64_t>(linesPerChunk(compression));
    const bool wavelets = compression == Imf::PIZ_COMPRESSION || compression == Imf::DWAA_COMPRESSION ||
                          compression == Imf::DWAB_COMPRESSION;
    const std::uint64_t strongest = wavelets ? 65536 : 1032;
    if ((!header.hasTileDescription() && chunks * 16 > byteSize) || values * 2 > byteSize * strongest)
        return Error{ErrorCode::Parse,
                     fmt::format("{} x {} pixels of {} channels do not fit in a file of {} bytes", width, height,
                                 channelCount, byteSize),
                     where};
    return checkTiles(header, channelCount, byteSize * strongest / 2, where);
}

/// "stderr.Y" -> "Y".
std::string_view baseName(std::string_view channel) { return channel.substr(channel.rfind('.') + 1); }

/// Values come as multiples of whiteLuminance; ours are cd/m^2.
Result<void> scaleToCandela(Image& image, const std::string& where) {
    const auto found = image.numbers.find("whiteLuminance");
    if (found == image.numbers.end() || found->second == 1.0) return {};
    if (!(found->second > 0) || !std::isfinite(found->second))
        return Error{ErrorCode::Parse, fmt::format("whiteLuminance is {}, expected a number above 0", found->second),
                     where};
    const auto scale = static_cast<float>(found->second);
    for (const auto& [name, unused] : image.channels()) {
        const auto base = baseName(name);
        if (base != "R" && base != "G" && base != "B" && base != "Y") continue;
        for (float& value : image.channel(name)) value *= scale;
    }
    found->second = 1.0;
    image.text["luxdeck:unit"] = "cd/m^2";
    return {};
}

/// Of the version's flags: headers of several parts follow each other, an empty one after the last.
bool hasParts(std::string_view bytes) { return (static_cast<unsigned char>(bytes[5]) & 0x10U) != 0; }

/// The size that OpenEXR reads of an attribute of this type whatever the file says; none: what it says.
std::optional<std::uint32_t> fixedSize(std::string_view type) {
    static constexpr std::pair<std::string_view, std::uint32_t> kSizes[] = {
        {"box2i", 16}, {"box2f", 16}, {"int", 4},   {"float", 4},  {"double", 8},  {"v2i", 8},   {"v2f", 8},   {"v2d", 16},     {"v3i", 12},        {"v3f", 12},     {"v3d", 24},
        {"m33f", 36},  {"m33d", 72},  {"m44f", 64}, {"m44d", 128}, {"compression", 1}, {"lineOrder", 1}, {"envmap", 1}, {"deepImageState", 1}, {"chromaticities", 32}, {"keycode", 28},
        {"rational", 8}, {"timecode", 8}, {"tiledesc", 9}};
    for (const auto& [name, size] : kSizes)
        if (name == type) return size;
    return std::nullopt;
}

/// Whether a value of this type is as long as it says: OpenEXR reads the rest of the header from where it ended.
bool isWhole(std::string_view type, std::string_view value) {
    if (const auto size = fixedSize(type)) return value.size() == *size;
    if (type == "preview") {  // two sides, then 4 bytes a pixel
        if (value.size() < 8) return false;
        std::uint32_t sides[2] = {};
        std::memcpy(sides, value.data(), sizeof sides);
        return std::uint64_t{sides[0]} * sides[1] == (value.size() - 8) / 4;
    }
    if (type != "chlist") return true;
    while (!value.empty() && value[0] != '\0') {  // name, then 16 bytes
        const auto end = value.find('\0');
        if (end == std::string_view::npos || value.size() - end < 17) return false;
        value.remove_prefix(end + 17);
    }
    return value.size() == 1;
}

/// That no attribute of the header at `at` claims more than the file has: OpenEXR makes room for it before it looks.
///
/// at  moves past the header
Result<void> checkAttributes(std::string_view bytes, std::size_t& at, const std::string& where) {
    const auto cutOff = [&] { return Error{ErrorCode::Parse, "the header is cut off", where}; };
    const auto skipName = [&] {
        const auto end = bytes.substr(at).find('\0');
        if (end == std::string_view::npos) return false;
        at += end + 1;
        return true;
    };
    while (at < bytes.size() && bytes[at] != '\0') {
        const std::size_t begin = at;
        if (!skipName()) return cutOff();
        const std::size_t typeAt = at;
        if (!skipName() || bytes.size() - at < 4) return cutOff();
        const auto type = bytes.substr(typeAt, at - 1 - typeAt);
        std::uint32_t size = 0;
        for (unsigned i = 0; i < 4; ++i) size |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
        at += 4;
        if (size > bytes.size() - at)
            return Error{
                ErrorCode::Parse,
                fmt::format("the attribute at byte {} has {} bytes, {} are left", begin, size, bytes.size() - at),
                where};
        if (!isWhole(type, bytes.substr(at, size)))
            return Error{ErrorCode::Parse, fmt::format("the attribute at byte {} has {} bytes, not those of a {}", begin, size, type.substr(0, 32)), where};
        at += size;
    }
    return at++ < bytes.size() ? Result<void>() : cutOff();
}

/// Reads and checks the headers alone: opening the file whole would allocate tables as long as they claim.
Result<void> checkHeaders(std::string_view bytes, const std::string& where) {
    if (bytes.size() < 8) return Error{ErrorCode::Parse, "the header is cut off", where};
    std::size_t at = 8;  // after magic number and version
    do {
        if (auto ok = checkAttributes(bytes, at, where); !ok) return ok.error();
    } while (hasParts(bytes) && at < bytes.size() && bytes[at] != '\0');
    MemoryInput stream(bytes, where);
    std::uint8_t b[8];
    stream.read(reinterpret_cast<char*>(b), 8);
    int version = b[4] | b[5] << 8 | b[6] << 16;
    if (Imf::isNonImage(version)) return Error{ErrorCode::Unsupported, "is a deep picture, expected a flat one", where};
    do {
        Imf::Header header;
        header.readFrom(stream, version);
        if (auto ok = checkHeader(header, bytes.size(), where); !ok) return ok.error();
    } while (hasParts(bytes) && stream.tellg() < bytes.size() && bytes[stream.tellg()] != '\0');
    return {};
}

Result<Image> decode(std::string_view bytes, const std::string& where) {
    if (auto ok = checkHeaders(bytes, where); !ok) return ok.error();
    MemoryInput stream(bytes, where);
    Imf::InputFile file(stream);
    const Imf::Header& header = file.header();
    const auto& window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    std::vector<std::string> names;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) names.emplace_back(it.name());
    Image image(width, height, names);

    Imf::FrameBuffer buffer;
    for (const auto& name : names)
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, image.channel(name).data(), window));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    readAttributes(header, image);
    if (auto ok = scaleToCandela(image, where); !ok) return ok.error();
    return image;
}

}  // namespace

Result<void> writeExr(const fs::path& path, const Image& image) {
    if (image.empty())
        return Error{ErrorCode::InvalidArgument, "the picture has no pixels or no channels", path.string()};
    try {
        MemoryOutput stream(path.string());
        {
            Imf::OutputFile file(stream, headerOf(image));
            Imf::FrameBuffer buffer;
            const auto rowBytes = sizeof(float) * static_cast<std::size_t>(image.width());
            for (const auto& [name, values] : image.channels())
                buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(values.data())),
                                               sizeof(float), rowBytes));  // only read through
            file.setFrameBuffer(buffer);
            file.writePixels(image.height());
        }  // the destructor writes the table of offsets
        return writeFileAtomically(path, stream.bytes);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "not enough memory to write the picture", path.string()};
    } catch (const std::exception& e) {
        return Error{ErrorCode::InvalidArgument, fmt::format("cannot be written as OpenEXR: {}", e.what()),
                     path.string()};
    }
}

Result<Image> parseExr(std::string_view bytes, const fs::path& name) {
    constexpr std::string_view kMagic("\x76\x2f\x31\x01", 4);
    if (bytes.substr(0, 4) != kMagic)
        return Error{ErrorCode::Parse, "does not begin as an OpenEXR file does", name.string()};
    try {
        return decode(bytes, name.string());
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "not enough memory to read the picture", name.string()};
    } catch (const std::exception& e) {
        return Error{ErrorCode::Parse, fmt::format("is not a readable OpenEXR file: {}", e.what()), name.string()};
    }
}

Result<Image> readExr(const fs::path& path) {
    auto bytes = readFile(path);
    if (!bytes) return bytes.error();
    return parseExr(*bytes, path);
}

}  // namespace luxdeck

#include "engine/io/pattern_picture.h"

#include "engine/core/file.h"
#include "engine/core/primaries.h"
#include "engine/io/image_files.h"
#include "engine/io/rgbe_header.h"

#include <utility>

namespace luxdeck {

namespace {

constexpr double kLumensPerWatt = 179;  // what parseRgbe() multiplies by

/// Takes back what parseRgbe() makes of the file's numbers.
Imath::M33d toFile(const RgbeHeader& header) {
    const double scale = header.exposure / kLumensPerWatt;
    const auto& k = header.correction;
    const Imath::M33d correction(scale * k.r, 0, 0, 0, scale * k.g, 0, 0, 0, scale * k.b);
    return rgbToRgb(kRec709Chromaticities, header.primaries) * correction;
}

/// One pixel is the same everywhere: two of them are.
void widen(int& width, int& height, std::vector<Rgb>& pixels) {
    if (width == 1) {
        std::vector<Rgb> wide;
        for (const auto& p : pixels) wide.insert(wide.end(), 2, p);
        pixels = std::move(wide);
        width = 2;
    }
    if (height == 1) {
        pixels.reserve(2 * pixels.size());
        for (std::size_t i = 0, n = pixels.size(); i < n; ++i) pixels.push_back(pixels[i]);
        height = 2;
    }
}

}  // namespace

Result<std::shared_ptr<const PatternPicture>> PatternPicture::parse(std::string_view bytes,
                                                                    const std::filesystem::path& name) {
    const auto header = parseRgbeHeader(bytes, name.string());
    if (!header) return header.error();
    if (header->xyz)
        return Error{ErrorCode::Unsupported, "a picture in XYZE, expected one in RGBE for a pattern", name.string()};
    const auto image = parseRgbe(bytes, name);
    if (!image) return image.error();

    auto picture = std::make_shared<PatternPicture>();
    picture->hash_ = contentHash(bytes);
    int width = image->width(), height = image->height();
    const double aspect = double(height) / double(width) * header->pixelAspect;  // of the whole, height over width
    const Imath::M33d matrix = toFile(*header);
    const auto shown = colours(*image);
    picture->pixels_.reserve(shown.size());
    for (int y = height; y-- > 0;)
        for (int x = 0; x < width; ++x) picture->pixels_.push_back(transformed(shown[image->index(x, y)], matrix));
    widen(width, height, picture->pixels_);
    picture->across_.end = aspect >= 1 ? 1 : 1 / aspect;
    picture->across_.count = static_cast<std::size_t>(width);
    picture->up_.end = aspect >= 1 ? aspect : 1;
    picture->up_.count = static_cast<std::size_t>(height);
    return std::shared_ptr<const PatternPicture>(std::move(picture));
}

Rgb PatternPicture::value(double u, double v) const {
    const AxisPlace x = across_.place(u), y = up_.place(v);
    const auto* row = pixels_.data() + y.lower * across_.count + x.lower;
    const auto* above = row + across_.count;
    const auto weighted = [](const Rgb& c, double w) { return c * static_cast<float>(w); };
    return weighted(row[0], x.lowerWeight * y.lowerWeight) + weighted(row[1], x.upperWeight * y.lowerWeight) +
           weighted(above[0], x.lowerWeight * y.upperWeight) + weighted(above[1], x.upperWeight * y.upperWeight);
}

}  // namespace luxdeck

#include "tonemap/falsecolor.h"

#include "tonemap/isolines.h"
#include "tonemap/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

constexpr double kMostDecades = 6;

Result<void> check(const Field& field) {
    if (field.width > 0 && field.height > 0 &&
        field.values.size() == static_cast<std::size_t>(field.width) * static_cast<std::size_t>(field.height))
        return {};
    return Error{ErrorCode::InvalidArgument,
                 fmt::format("{} values for {} x {} samples", field.values.size(), field.width, field.height), ""};
}

Result<void> check(const ScaleRange& range, bool logarithmic) {
    if (std::isfinite(range.low) && std::isfinite(range.high) && range.low < range.high &&
        (!logarithmic || range.low > 0))
        return {};
    return Error{ErrorCode::InvalidArgument,
                 fmt::format("range {} to {}, expected {}low < high", range.low, range.high, logarithmic ? "0 < " : ""),
                 ""};
}

/// 1, 2 or 5 times a power of ten, at least (or at most) `value` > 0.
double roundedUp(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * decade >= value * (1 - 1e-9)) return m * decade;
    return 10 * decade;
}
double roundedDown(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double m : {5.0, 2.0})
        if (m * decade <= value * (1 + 1e-9)) return m * decade;
    return decade;
}

/// Where a value lies on the scale, 0..1 within the range.
double position(double value, const ScaleRange& range, bool logarithmic) {
    if (!logarithmic) return (value - range.low) / (range.high - range.low);
    return value > 0 ? std::log(value / range.low) / std::log(range.high / range.low) : -1;
}

struct Counts {
    std::size_t below = 0, above = 0, notFinite = 0;
};

Counts paint(DisplayImage& image, const Field& field, const FalseColourSettings& settings, const ScaleRange& range) {
    Counts counts;
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            const double value = field.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width) +
                                              static_cast<std::size_t>(x)];
            Colour8 colour = kNotANumber;
            if (std::isfinite(value)) {
                const double t = position(value, range, settings.logarithmic);
                if (t < 0) ++counts.below;
                if (t > 1) ++counts.above;
                colour = colourAt(settings.map, t);
            } else {
                ++counts.notFinite;
            }
            std::ranges::copy(colour, image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + x));
        }
    return counts;
}

}  // namespace

Result<Field> luminanceField(const Image& image) {
    if (image.empty() || (!image.hasColour() && !image.has("Y")))
        return Error{ErrorCode::InvalidArgument, "the picture has no pixels, or no channels R, G, B and none called Y",
                     ""};
    Field field{image.width(), image.height(), {}};
    field.values.reserve(image.pixelCount());
    if (image.hasColour())
        for (const Rgb& c : colours(image)) field.values.push_back(luminance(c, image.weights));
    else
        for (const float y : image.channel("Y")) field.values.push_back(y);
    return field;
}

ScaleRange roundedRange(const Field& field, bool logarithmic) {
    std::vector<double> sorted;
    for (const double v : field.values)
        if (std::isfinite(v) && v > 0) sorted.push_back(v);
    if (sorted.empty()) return logarithmic ? ScaleRange{0.1, 1} : ScaleRange{0, 1};
    const auto percentile = [&](double p) {
        const auto at = sorted.begin() +
                        static_cast<std::ptrdiff_t>(std::llround(p / 100 * static_cast<double>(sorted.size() - 1)));
        std::ranges::nth_element(sorted, at);
        return *at;
    };
    const double top = percentile(99.9);
    if (!logarithmic) {
        const double step = roundedUp(top / 8);
        return {0, step * std::ceil(top / step - 1e-9)};
    }
    const double high = roundedUp(top);
    double low = std::max(roundedDown(percentile(0.5)), high * std::pow(10.0, -kMostDecades));
    if (low >= high) low = roundedDown(0.4 * high);
    return {low, high};
}

std::string labelOf(double value) {
    const double magnitude = std::abs(value);
    if (magnitude >= 999999.5 || (magnitude > 0 && magnitude < 9.9995e-5)) {
        auto text = fmt::format("{:.4g}", value);  // 3e+06 -> 3e6
        for (const char* padding : {"e+0", "e+", "e-0"})
            if (const auto at = text.find(padding); at != std::string::npos) {
                text.replace(at, std::string_view(padding).size(), padding[1] == '-' ? "e-" : "e");
                break;
            }
        return text;
    }
    if (magnitude < 9999.5) return fmt::format("{:.4g}", value);
    auto text = fmt::format("{:.0f}", value);
    text.insert(text.size() - 3, " ");
    return text;
}

Result<DisplayImage> falseColour(const Field& field, const FalseColourSettings& settings) {
    if (auto ok = check(field); !ok) return ok.error();
    const auto range = settings.range.value_or(roundedRange(field, settings.logarithmic));
    if (auto ok = check(range, settings.logarithmic); !ok) return ok.error();

    const Legend legend(field.height, range, settings);
    DisplayImage image;
    image.width = field.width + (settings.legend ? legend.width() : 0);
    image.height = settings.legend ? std::max(field.height, legend.leastHeight()) : field.height;
    image.rgb.assign(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 255);
    const Counts counts = paint(image, field, settings, range);
    if (settings.isolines) {
        auto style = *settings.isolines;
        if (style.levels.empty()) style.levels = roundLevels(range.low, range.high, 8, settings.logarithmic);
        if (auto ok = drawIsolines(image, field, style, settings.logarithmic); !ok) return ok.error();
    }
    if (settings.legend) legend.draw(image, field.width, counts.notFinite > 0);
    image.text = {{"luxdeck:falsecolour", std::string(name(settings.map))},
                  {"luxdeck:quantity", settings.quantity},
                  {"luxdeck:unit", settings.unit},
                  {"luxdeck:scale", fmt::format("{} {:g} to {:g}", settings.logarithmic ? "logarithmic" : "linear",
                                                range.low, range.high)},
                  {"luxdeck:beyond",
                   fmt::format("{} below, {} above, {} not finite", counts.below, counts.above, counts.notFinite)}};
    return image;
}

}  // namespace luxdeck::tonemap

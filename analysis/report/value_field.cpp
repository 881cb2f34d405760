#include "analysis/report/value_field.h"

#include "analysis/grids/grid_field.h"
#include "analysis/report/number_format.h"
#include "tonemap/colour_map.h"
#include "tonemap/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace luxdeck::report {

namespace {

/// The 1-2-5 step nearest below that divides `span` into at most about `wanted` parts.
double roundStep(double span, int wanted) {
    const double raw = span / wanted;
    const double magnitude = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (raw <= factor * magnitude * 1.0000001) return factor * magnitude;
    return 10 * magnitude;
}

}  // namespace

ValueRange roundRange(const std::vector<double>& values) {
    double low = 1e300, high = -1e300;
    for (const double v : values)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    if (high < low) return {0, 1};
    if (high - low < 1e-6 * std::max(1.0, std::abs(high))) return {std::floor(low), std::floor(low) + 1};
    const double step = roundStep(high - low, 6);
    return {std::floor(low / step) * step, std::ceil(high / step) * step};
}

std::vector<double> isolineLevels(double low, double high) {
    static constexpr std::array kSeries{1.0, 1.5, 2.0, 3.0, 5.0, 7.5, 10.0};  // times a power of ten
    std::vector<double> levels;
    if (!(high > low) || low < 0) return levels;
    for (double decade = 1e-3; decade <= high; decade *= 10)
        for (std::size_t i = 0; i + 1 < kSeries.size(); ++i) {
            const double level = kSeries[i] * decade;
            if (level > low && level < high) levels.push_back(level);
        }
    if (levels.size() > 10) levels.erase(levels.begin(), levels.end() - 10);
    if (levels.size() >= 3) return levels;
    levels = tonemap::roundLevels(low, high, 6, false);
    std::erase_if(levels, [&](double level) { return level <= low || level >= high; });
    return levels;
}

QColor fieldColour(double fraction) {
    if (std::isnan(fraction)) return ink::kPale;
    const auto c = tonemap::colourAt(tonemap::ColourMap::Dusk, std::clamp(fraction, 0.0, 1.0));
    const auto paler = [](int channel) { return static_cast<int>(std::lround(channel * 0.68 + 255 * 0.32)); };
    return {paler(c[0]), paler(c[1]), paler(c[2])};
}

QColor fieldInk(double fraction) {
    const auto c = fieldColour(fraction);
    return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF() > 0.5 ? ink::kBlack : ink::kWhite;
}

QImage fieldImage(const std::vector<double>& values, int columns, int rows, const ValueRange& range) {
    if (columns < 1 || rows < 1 || values.size() != static_cast<std::size_t>(columns) * rows) return {};
    const int fine = std::clamp(480 / std::max(columns, rows), 1, 32);  // pixels a cell
    QImage picture(columns * fine, rows * fine, QImage::Format_RGB32);
    for (int j = 0; j < picture.height(); ++j) {
        auto* pixels = reinterpret_cast<QRgb*>(picture.scanLine(j));
        for (int i = 0; i < picture.width(); ++i) {
            const double value = sampleField(values, columns, rows, (i + 0.5) / fine - 0.5, (j + 0.5) / fine - 0.5);
            pixels[i] = std::isfinite(value) ? fieldColour(range.fraction(value)).rgb() : ink::kPale.rgb();
        }
    }
    return picture;
}

void drawColourBar(Canvas& canvas, double x, double y, double widthMm, const ValueRange& range, const QString& unit) {
    constexpr int kSteps = 256;
    QImage bar(kSteps, 1, QImage::Format_RGB32);
    for (int i = 0; i < kSteps; ++i) bar.setPixel(i, 0, fieldColour((i + 0.5) / kSteps).rgb());
    const double height = 3;
    canvas.image({x, y}, {widthMm, 0}, {0, height}, bar, false);
    const TextStyle label{6.5, QFont::Normal, ink::kGrey, Align::Centre};
    for (const double tick : tonemap::roundLevels(range.low, range.high, 6, false)) {
        const double at = x + widthMm * range.fraction(tick);
        canvas.stroke(at, y + height, at, y + height + 1, ink::kGrey, 0.2);
        canvas.text(at, y + height + 3.8, line(formatNumber(tick)), label);
    }
    canvas.text(x + widthMm + 3, y + 2.5, unit, {7, QFont::Medium, ink::kGrey});
}

}  // namespace luxdeck::report

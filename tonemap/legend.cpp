#include "tonemap/legend.h"

#include "tonemap/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

constexpr Colour8 kPaper{255, 255, 255};
constexpr Colour8 kInk{30, 32, 36};
constexpr const char* kNoValue = "no value";
// Heights, in capitals' heights.
constexpr double kHeadRows = 4.6;        // title and unit
constexpr double kNotANumberRows = 3;    // the entry below the bar
constexpr double kTickRows = 1.9;        // a number's share of the bar

}  // namespace

Legend::Legend(int pictureHeight, const ScaleRange& range, const FalseColourSettings& settings)
    : map_(settings.map),
      title_(settings.quantity),
      unit_(settings.unit),
      capHeight_(std::clamp(pictureHeight / 50.0, 8.0, 28.0)),
      margin_(static_cast<int>(std::lround(1.8 * capHeight_))),
      barWidth_(static_cast<int>(std::lround(2.2 * capHeight_))),
      tickLength_(static_cast<int>(std::lround(0.6 * capHeight_))) {
    addTicks(range, settings.logarithmic, pictureHeight - (kHeadRows + kNotANumberRows) * capHeight_ - 2.0 * margin_);
    double widest = 0;
    for (const auto& t : ticks_) widest = std::max(widest, Canvas::textWidth(capHeight_, t.label));
    const double scale = barWidth_ + 2 * tickLength_ + widest;
    const double heading = std::max(Canvas::textWidth(capHeight_, title_), Canvas::textWidth(capHeight_, unit_));
    const double noValue = barWidth_ + 0.7 * tickLength_ + Canvas::textWidth(capHeight_, kNoValue);
    width_ = 2 * margin_ + static_cast<int>(std::ceil(std::max({scale, heading, noValue})));
}

int Legend::leastHeight() const {
    const auto numbers = std::ranges::count_if(ticks_, &Tick::strong);
    return static_cast<int>(2 * margin_ +
                            (kHeadRows + kNotANumberRows + 1.7 * static_cast<double>(numbers)) * capHeight_);
}

void Legend::addTicks(const ScaleRange& range, bool logarithmic, double barHeight) {
    const auto at = [&](double v) {
        return logarithmic ? std::log(v / range.low) / std::log(range.high / range.low)
                           : (v - range.low) / (range.high - range.low);
    };
    const int rows = static_cast<int>(std::clamp(barHeight / (kTickRows * capHeight_), 4.0, logarithmic ? 18.0 : 10.0));
    const auto numbers = roundLevels(range.low, range.high, rows, logarithmic);
    for (const double v : numbers) ticks_.push_back({at(v), labelOf(v), true});
    if (!logarithmic) return;
    // The units of each decade, as on logarithmic paper, unless they would only be grey.
    if (barHeight / std::log10(range.high / range.low) < 5 * capHeight_) return;
    for (int d = static_cast<int>(std::floor(std::log10(range.low))); d <= std::log10(range.high); ++d)
        for (int m = 1; m <= 9; ++m) {
            const double v = m * std::pow(10.0, d);
            const bool numbered = std::ranges::any_of(numbers, [&](double n) { return std::abs(n - v) < 1e-6 * v; });
            if (!numbered && v > range.low && v < range.high) ticks_.push_back({at(v), "", false});
        }
}

void Legend::drawBar(DisplayImage& image, int x, int top, int bottom) const {
    Canvas canvas(image);
    for (int y = top; y < bottom; ++y) {
        const double t = (bottom - 0.5 - y) / (bottom - top);
        canvas.fill(x, y, x + barWidth_, y + 1, colourAt(map_, t));
    }
    for (const auto& tick : ticks_) {
        const double y = std::clamp(bottom - tick.position * (bottom - top), top + 0.5, bottom - 0.5);
        const double line = std::floor(y) + 0.5, right = x + barWidth_;  // on the pixels' rows: a crisp line
        const std::array<std::array<double, 2>, 2> points{
            {{right, line}, {right + tickLength_ * (tick.strong ? 1.0 : 0.5), line}}};
        canvas.polyline(points, false, 1, kInk);
        canvas.text(right + 1.7 * tickLength_, y - 0.5 * capHeight_, capHeight_, tick.label, kInk);
    }
}

void Legend::draw(DisplayImage& image, int x, bool showsNotANumber) const {
    Canvas canvas(image);
    canvas.fill(x, 0, x + width_, image.height, kPaper);
    const double left = x + margin_;
    canvas.text(left, margin_, capHeight_, title_, kInk);
    canvas.text(left, margin_ + 1.7 * capHeight_, capHeight_, unit_, kInk);
    const int top = margin_ + static_cast<int>(std::lround(kHeadRows * capHeight_));
    int bottom = image.height - margin_;
    if (showsNotANumber) {
        bottom -= static_cast<int>(std::lround(kNotANumberRows * capHeight_));
        const int box = static_cast<int>(std::lround(capHeight_ * 1.2)), y = image.height - margin_ - box;
        canvas.fill(x + margin_, y, x + margin_ + barWidth_, y + box, kNotANumber);
        canvas.text(left + barWidth_ + 0.7 * tickLength_, y + 0.1 * capHeight_, capHeight_, kNoValue, kInk);
    }
    drawBar(image, x + margin_, top, std::max(bottom, top + 1));
}

}  // namespace luxdeck::tonemap

#include "tonemap/falsecolor.h"

#include "tonemap/isolines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

constexpr int kMostSamples = 400;  // a side

/// Means over whole boxes of samples; a box with a sample that is not finite has no mean.
struct Averaged {
    Field field;
    int boxSize = 1;
};

Averaged averaged(const Field& field) {
    Averaged out;
    out.boxSize = std::max(1, (std::max(field.width, field.height) + kMostSamples - 1) / kMostSamples);
    const int n = out.boxSize;
    out.field.width = (field.width + n - 1) / n;
    out.field.height = (field.height + n - 1) / n;
    for (int y = 0; y < out.field.height; ++y)
        for (int x = 0; x < out.field.width; ++x) {
            double sum = 0;
            int count = 0;
            for (int sy = y * n; sy < std::min((y + 1) * n, field.height); ++sy)
                for (int sx = x * n; sx < std::min((x + 1) * n, field.width); ++sx, ++count)
                    sum += field.values[static_cast<std::size_t>(sy) * static_cast<std::size_t>(field.width) +
                                        static_cast<std::size_t>(sx)];
            out.field.values.push_back(sum / count);
        }
    return out;
}

/// A binomial filter, 1-2-1 each way: takes the stairs of single noisy samples off. Not finite stays where it is.
Field smoothed(const Field& field) {
    Field out = field;
    const auto at = [&](int x, int y) {
        return field.values[static_cast<std::size_t>(std::clamp(y, 0, field.height - 1)) *
                                static_cast<std::size_t>(field.width) +
                            static_cast<std::size_t>(std::clamp(x, 0, field.width - 1))];
    };
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            if (!std::isfinite(at(x, y))) continue;
            double sum = 0, weights = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const double v = at(x + dx, y + dy), w = (2 - std::abs(dx)) * (2 - std::abs(dy));
                    if (!std::isfinite(v)) continue;
                    sum += w * v;
                    weights += w;
                }
            out.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width) +
                       static_cast<std::size_t>(x)] = sum / weights;
        }
    return out;
}

struct Box {
    double x0, y0, x1, y1;
    [[nodiscard]] bool meets(const Box& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
};

double lengthOf(const Isoline& line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        length += std::hypot(line.points[i + 1][0] - line.points[i][0], line.points[i + 1][1] - line.points[i][1]);
    return length;
}

/// Puts numbers on lines that are long enough, where they are inside and clear of each other.
class Labels {
public:
    Labels(Canvas& canvas, const Field& field, const IsolineStyle& style)
        : canvas_(canvas),
          width_(field.width),
          height_(field.height),
          style_(style),
          capHeight_(std::clamp(field.height / 65.0, 7.0, 20.0)) {}

    void add(const Isoline& line, double level) {
        const std::string text = labelOf(level);
        const double width = Canvas::textWidth(capHeight_, text);
        if (lengthOf(line) < 4 * width) return;
        for (const double along : {0.5, 0.35, 0.65, 0.2, 0.8}) {
            const auto& p = line.points[static_cast<std::size_t>(along * static_cast<double>(line.points.size() - 1))];
            const Box box{p[0] - 0.5 * width - 3, p[1] - 0.5 * capHeight_ - 3, p[0] + 0.5 * width + 3,
                          p[1] + 0.5 * capHeight_ + 3};
            const bool inside = box.x0 >= 0 && box.y0 >= 0 && box.x1 <= width_ && box.y1 <= height_;
            if (!inside || std::ranges::any_of(taken_, [&](const Box& o) { return o.meets(box); })) continue;
            taken_.push_back(box);
            const double thickness = Canvas::strokeThickness(capHeight_);
            canvas_.text(box.x0 + 3, box.y0 + 3, capHeight_, text, style_.halo, thickness + 4);
            canvas_.text(box.x0 + 3, box.y0 + 3, capHeight_, text, style_.colour, thickness);
            return;
        }
    }

private:
    Canvas& canvas_;
    double width_, height_;
    const IsolineStyle& style_;
    double capHeight_;
    std::vector<Box> taken_;
};

}  // namespace

Result<void> drawIsolines(DisplayImage& image, const Field& field, const IsolineStyle& style, bool logarithmic) {
    const bool fits =
        field.width > 0 && field.height > 0 && image.width >= field.width && image.height >= field.height &&
        field.values.size() == static_cast<std::size_t>(field.width) * static_cast<std::size_t>(field.height);
    if (!fits)
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("a field of {} x {} samples ({} values) over a picture of {} x {}", field.width,
                                 field.height, field.values.size(), image.width, image.height),
                     ""};
    auto levels = style.levels;
    if (levels.empty()) {
        const auto range = roundedRange(field, logarithmic);
        levels = roundLevels(range.low, range.high, 8, logarithmic);
    }
    auto [coarse, boxSize] = averaged(field);
    coarse = smoothed(coarse);
    if (logarithmic) {  // lines are straight between samples on the scale that is shown
        for (double& v : coarse.values) v = v > 0 ? std::log10(v) : (v <= 0 ? -30 : v);
        std::erase_if(levels, [](double l) { return !(l > 0); });
        for (double& l : levels) l = std::log10(l);
    }
    auto lines = isolines(coarse.values, coarse.width, coarse.height, levels);
    for (auto& line : lines)
        for (auto& p : line.points) p = {(p[0] + 0.5) * boxSize, (p[1] + 0.5) * boxSize};

    Canvas canvas(image);
    const double thickness = std::clamp(field.height / 500.0, 1.0, 2.5);
    for (const auto& line : lines) canvas.polyline(line.points, line.closed, thickness + 1.4, style.halo);
    for (const auto& line : lines) canvas.polyline(line.points, line.closed, thickness, style.colour);
    if (!style.labels) return {};
    Labels labels(canvas, field, style);
    for (const auto& line : lines) labels.add(line, logarithmic ? std::pow(10.0, line.level) : line.level);
    return {};
}

}  // namespace luxdeck::tonemap

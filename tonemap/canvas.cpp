#include "tonemap/canvas.h"

#include "tonemap/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace luxdeck::tonemap {

struct Canvas::Line {
    double x0, y0, x1, y1;
};

namespace {

double distance(double px, double py, double x0, double y0, double x1, double y1) {
    const double dx = x1 - x0, dy = y1 - y0, length2 = dx * dx + dy * dy;
    const double t = length2 > 0 ? std::clamp(((px - x0) * dx + (py - y0) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(px - (x0 + t * dx), py - (y0 + t * dy));
}

}  // namespace

void Canvas::fill(int x0, int y0, int x1, int y1, const Colour8& colour) {
    for (int y = std::max(y0, 0); y < std::min(y1, image_.height); ++y)
        for (int x = std::max(x0, 0); x < std::min(x1, image_.width); ++x)
            std::ranges::copy(colour, image_.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image_.width + x));
}

/// Coverage is collected over all lines first, its maximum counts: joints are not painted twice.
void Canvas::strokes(std::span<const Line> lines, double thickness, const Colour8& colour) {
    const double half = 0.5 * thickness, reach = half + 1;
    std::unordered_map<std::size_t, double> coverage;
    for (const auto& l : lines) {
        const int x0 = std::max(static_cast<int>(std::floor(std::min(l.x0, l.x1) - reach)), 0);
        const int x1 = std::min(static_cast<int>(std::ceil(std::max(l.x0, l.x1) + reach)), image_.width);
        const int y0 = std::max(static_cast<int>(std::floor(std::min(l.y0, l.y1) - reach)), 0);
        const int y1 = std::min(static_cast<int>(std::ceil(std::max(l.y0, l.y1) + reach)), image_.height);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const double covered =
                    std::clamp(half + 0.5 - distance(x + 0.5, y + 0.5, l.x0, l.y0, l.x1, l.y1), 0.0, 1.0);
                if (covered <= 0) continue;
                double& most = coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                                        static_cast<std::size_t>(x)];
                most = std::max(most, covered);
            }
    }
    for (const auto& [pixel, covered] : coverage)
        for (std::size_t c = 0; c < 3; ++c) {
            auto& value = image_.rgb[3 * pixel + c];
            value = static_cast<std::uint8_t>(std::lround(value + covered * (colour[c] - value)));
        }
}

void Canvas::polyline(std::span<const std::array<double, 2>> points, bool closed, double thickness,
                      const Colour8& colour) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        lines.push_back({points[i][0], points[i][1], points[i + 1][0], points[i + 1][1]});
    if (closed && points.size() > 2)
        lines.push_back({points.back()[0], points.back()[1], points.front()[0], points.front()[1]});
    strokes(lines, thickness, colour);
}

double Canvas::strokeThickness(double capHeight) { return std::max(1.0, 0.13 * capHeight); }

void Canvas::text(double x, double y, double capHeight, std::string_view utf8, const Colour8& colour,
                  double thickness) {
    const double scale = capHeight / 10;
    std::vector<Line> lines;
    for (const auto& s : strokeText(utf8).strokes)
        lines.push_back({x + s.x0 * scale, y + s.y0 * scale, x + s.x1 * scale, y + s.y1 * scale});
    strokes(lines, thickness > 0 ? thickness : strokeThickness(capHeight), colour);
}

double Canvas::textWidth(double capHeight, std::string_view utf8) { return strokeText(utf8).width * capHeight / 10; }

}  // namespace luxdeck::tonemap

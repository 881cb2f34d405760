#pragma once

#include "engine/core/image.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace luxdeck::tonemap {

using Colour8 = std::array<std::uint8_t, 3>;  ///< sRGB

/// Draws on an 8-bit picture, antialiased. Coordinates are pixels from the upper left corner, pixel centres at
/// halves; what is outside is cut off.
class Canvas {
public:
    explicit Canvas(DisplayImage& image) : image_(image) {}

    void fill(int x0, int y0, int x1, int y1, const Colour8& colour);
    /// A line of round ends and joints; `closed` adds the one from the last point to the first.
    void polyline(std::span<const std::array<double, 2>> points, bool closed, double thickness, const Colour8& colour);
    /// Text whose capitals are `capHeight` pixels tall, their top left corner at x, y.
    void text(double x, double y, double capHeight, std::string_view utf8, const Colour8& colour, double thickness = 0);
    /// Width of such a text [pixels].
    static double textWidth(double capHeight, std::string_view utf8);
    /// The thickness of strokes that text has unless told.
    static double strokeThickness(double capHeight);

private:
    struct Line;
    void strokes(std::span<const Line> lines, double thickness, const Colour8& colour);

    DisplayImage& image_;
};

}  // namespace luxdeck::tonemap

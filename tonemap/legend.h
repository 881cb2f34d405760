#pragma once

#include "tonemap/falsecolor.h"

#include <string>
#include <vector>

namespace luxdeck::tonemap {

/// The scale beside a false-colour picture: a title, a bar of the map's colours, ticks with numbers.
class Legend {
public:
    /// pictureHeight  [pixels]: text and bar grow with it
    Legend(int pictureHeight, const ScaleRange& range, const FalseColourSettings& settings);

    [[nodiscard]] int width() const { return width_; }
    /// A lower panel would not hold its numbers.
    [[nodiscard]] int leastHeight() const;
    /// Draws into the panel right of column x, over the picture's whole height.
    void draw(DisplayImage& image, int x, bool showsNotANumber) const;

private:
    struct Tick {
        double position = 0;  // 0 at the bottom, 1 at the top
        std::string label;
        bool strong = true;   // has a number
    };
    void addTicks(const ScaleRange& range, bool logarithmic, double barHeight);
    void drawBar(DisplayImage& image, int x, int top, int bottom) const;

    ColourMap map_;
    std::string title_, unit_;
    std::vector<Tick> ticks_;
    double capHeight_;
    int margin_, barWidth_, tickLength_, width_;
};

}  // namespace luxdeck::tonemap

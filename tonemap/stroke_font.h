#pragma once

#include <string_view>
#include <vector>

namespace luxdeck::tonemap {

/// A line of text as strokes, in units of a tenth of a capital's height: x from the text's left, y downwards
/// from the capitals' top (10 is the base line, descenders reach 13).
struct StrokeText {
    struct Stroke {
        double x0, y0, x1, y1;
    };
    std::vector<Stroke> strokes;
    double width = 0;
};

/// Lays out UTF-8 text in our own stroke font: ASCII letters, digits, common punctuation, superscript two, degree.
/// "^2" becomes a superscript; what the font does not have shows as a box.
StrokeText strokeText(std::string_view utf8);

}  // namespace luxdeck::tonemap

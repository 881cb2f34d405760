#include "gui/view3d/view_colours.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

float encodedSrgb(float linear) {
    const float v = std::clamp(linear, 0.0F, 1.0F);
    return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
}

ViewColours ViewColours::of(const QPalette& palette) {
    ViewColours colours;
    colours.dark = palette.color(QPalette::Window).lightnessF() < 0.5;
    colours.accent = palette.color(QPalette::Highlight);
    if (colours.dark) {
        colours.backgroundTop = QColor(24, 27, 32);
        colours.backgroundBottom = QColor(52, 57, 66);
        colours.edge = QColor(12, 13, 16);
        colours.ink = QColor(236, 239, 244);
        colours.paper = QColor(30, 33, 39);
    } else {
        colours.backgroundTop = QColor(222, 229, 237);
        colours.backgroundBottom = QColor(250, 251, 252);
        colours.edge = QColor(38, 44, 54);
        colours.ink = QColor(28, 32, 38);
        colours.paper = QColor(255, 255, 255);
    }
    return colours;
}

}  // namespace luxdeck::gui

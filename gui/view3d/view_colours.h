#pragma once

#include <QColor>
#include <QPalette>

#include <array>

namespace luxdeck::gui {

/// The colours of a view on a light or a dark desktop.
struct ViewColours {
    bool dark = false;
    QColor backgroundTop, backgroundBottom;
    QColor edge;         ///< lines of the geometry
    QColor ink, paper;   ///< text over the view, and what lies under it
    QColor accent;       ///< what is selected

    static ViewColours of(const QPalette& palette);
};

/// A linear value as screens have it (IEC 61966-2-1), clamped to 0 .. 1.
float encodedSrgb(float linear);

inline std::array<double, 3> rgbOf(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

}  // namespace luxdeck::gui

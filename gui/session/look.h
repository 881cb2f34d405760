#pragma once

#include "analysis/pictures/show.h"
#include "engine/core/image.h"
#include "engine/core/result.h"
#include "tonemap/falsecolor.h"
#include "tonemap/histogram.h"
#include "tonemap/operators.h"

#include <optional>
#include <string>

namespace luxdeck::gui {

/// How a picture's numbers become colours on a screen.
struct Look {
    bool falseColour = false;             ///< numbers as colours instead of tone mapping
    tonemap::ToneMapSettings tone;
    ShowSettings how;
    tonemap::ColourMap map = tonemap::ColourMap::Dusk;
    bool logarithmic = true;              ///< false colour and isolines in equal ratios
    std::optional<tonemap::ScaleRange> range;  ///< of false colour [cd/m², lx]; none: round numbers about the picture's own
    bool isolines = false;
    bool legend = false;                  ///< drawn beside the false colours; the window has one of its own
};

/// A picture as a screen shows it, and what was decided on the way.
struct Developed {
    DisplayImage image;
    std::optional<tonemap::ToneMapRecord> record;  ///< of tone mapping
    std::string transform;                ///< OpenColorIO's config, display and view
    tonemap::ScaleRange range;            ///< of false colour and isolines
    tonemap::LogHistogram histogram;      ///< of the luminance of all pixels
};

/// errors  of show() and tonemap::falseColour()
Result<Developed> develop(const Image& picture, const Look& look);

}  // namespace luxdeck::gui

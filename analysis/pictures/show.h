#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "tonemap/operators.h"

#include <string>

namespace luxdeck {

/// A picture made for people, and how.
struct Shown {
    DisplayImage image;
    tonemap::ToneMapRecord record;
    std::string transform;  // OpenColorIO config, display and view
};

/// How a picture is made for people, beside the operator.
struct ShowSettings {
    bool whiteBalance = true;  // adapt to the light sources' white, which the picture's header names
    std::string ocioDisplay;   // empty: the config's default
    std::string ocioView;      // empty: the view that only encodes for our own config, else the config's default
};

/// Adapts, tone maps and encodes by OpenColorIO.
///
/// errors  of tonemap::toneMap(), tonemap::DisplayTransform
Result<Shown> show(const Image& scene, const tonemap::ToneMapSettings& settings, const ShowSettings& how = {});

/// What the operator did, in a sentence.
std::string operatorText(const tonemap::ToneMapRecord& record);

}  // namespace luxdeck

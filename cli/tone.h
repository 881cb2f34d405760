#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "tonemap/operators.h"

#include <string>

namespace luxdeck::cli {

/// A picture made for people, and how.
struct Shown {
    DisplayImage image;
    tonemap::ToneMapRecord record;
    std::string transform;  // OpenColorIO config, display and view
};

/// Tone maps and then encodes by OpenColorIO. `ocioView` empty: the view that only encodes for our own
/// config (the operators are the tone curve), else the config's default.
Result<Shown> show(const Image& scene, const tonemap::ToneMapSettings& settings, const std::string& ocioView = {});

/// What the operator did, in a sentence.
std::string operatorText(const tonemap::ToneMapRecord& record);

}  // namespace luxdeck::cli

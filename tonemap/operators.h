#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "tonemap/histogram.h"
#include "tonemap/view_geometry.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::tonemap {

enum class Operator {
    Linear,  ///< one exposure for the whole picture
    Camera,  ///< histogram adjustment that never raises contrast: everything is recorded
    Human    ///< histogram adjustment that shows what an eye in the scene would see, and no more
};

/// "linear", "camera", "human".
std::string_view name(Operator op);
/// errors  InvalidArgument: not one of these
Result<Operator> operatorNamed(std::string_view name);

/// What the eye does to a picture. Unset: on for Operator::Human, off for the others.
struct Effects {
    std::optional<bool> veil;    ///< light scattered in the eye
    std::optional<bool> acuity;  ///< blur where it is too dark to see sharply
    std::optional<bool> colour;  ///< no colours at night
};

struct ToneMapSettings {
    Operator op = Operator::Human;
    std::optional<double>
        exposure;  ///< Operator::Linear: display over world luminance, > 0; unset: log-mean shows as 18 % of white
    double exposureEv = 0;    ///< Operator::Linear: stops over the exposure that is given or automatic
    DisplayModel display;
    Effects effects;
    std::optional<ViewGeometry> view;  ///< unset: the picture's own header tells (viewGeometryOf)
};

/// One effect, and why it was or was not applied.
struct EffectDecision {
    std::string effect;  ///< "veil", "acuity", "colour"
    bool applied = false;
    std::string why;
};

struct CurvePoint {
    double worldCdM2 = 0;
    double displayCdM2 = 0;
};

/// Everything that was decided on the way, for reports and JSON.
struct ToneMapRecord {
    Operator op = Operator::Human;
    std::string mapping;                  ///< "linear", "histogram, linear ceiling", "histogram, human ceiling"
    std::string why;                      ///< that mapping
    double factor = 0;                    ///< display over world luminance when the mapping is linear; else 0
    DisplayModel display;
    ViewGeometry view;                    ///< as used
    bool viewAssumed = false;             ///< the picture does not tell its angle of view
    int fovealWidth = 0, fovealHeight = 0;
    double worldMinCdM2 = 0;              ///< of the pixels above 0
    double worldMaxCdM2 = 0;
    double worldLogMeanCdM2 = 0;
    std::vector<EffectDecision> effects;
    std::vector<CurvePoint> curve;        ///< over the foveal samples' range; empty for a black picture
    int passes = 0;                       ///< of histogram adjustment
    double keptFraction = 1;              ///< of the histogram's counts
    std::size_t nonFinitePixels = 0;      ///< NaN, infinite: replaced by their neighbours' mean
    std::size_t negativePixels = 0;       ///< negative channels were set to 0
    std::size_t clippedPixels = 0;        ///< colours beyond the display, brought to its border
};

struct ToneMapped {
    Image image;           ///< R, G, B linear Rec.709 for the display: 1 is its white, 0 its black; all within 0..1
    ToneMapRecord record;
};

/// Maps a picture of the scene to a display.
///
/// scene    R, G, B in its weights' space, or Y [cd/m^2]; NaN, infinite and negative values are allowed and counted
/// errors   InvalidArgument: no pixels or no such channels, display not 0 < min < max, exposure or view out of range
/// source   Larson, Rushmeier & Piatko 1997 (Camera, Human); README.md says where this differs
/// threads  parallel inside, the same bits at any thread count
Result<ToneMapped> toneMap(const Image& scene, const ToneMapSettings& settings);

/// The record as short lines for a picture's header: "luxdeck:operator", "luxdeck:mapping" ...
std::map<std::string, std::string> headerText(const ToneMapRecord& record);

}  // namespace luxdeck::tonemap

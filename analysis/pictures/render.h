#pragma once

#include "engine/core/image.h"
#include "engine/core/progress.h"
#include "engine/io/project.h"
#include "engine/transport/lit_scene.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

enum class Quantity {
    Luminance,   // of what is seen [cd/m^2]
    Illuminance  // on the surfaces that are seen [lx]
};

struct RenderSettings {
    std::string algorithm = "path";
    AlgorithmSettings algorithmSettings;
    Quantity quantity = Quantity::Luminance;
    std::uint64_t seed = 1;
    double targetError = 0.1;            // of the picture, see RenderResult::relativeError; 0: until the time is up
    std::optional<double> timeSeconds;
    std::optional<std::uint32_t> samples;  // paths a pixel, instead
    double showEverySeconds = 5;         // how often the picture so far is handed out
    std::string stage;                   // what the progress calls it; empty: "rendering" and the view's name
};

struct RenderResult {
    /// R, G, B [cd/m^2 or lx], "stderr.Y": the standard error of the luminance, "Z": the distance to what
    /// is seen [m]. The header names unit, view, algorithm, seed, hashes, seconds, samples, completeness.
    Image image;
    double seconds = 0;
    std::uint32_t samplesPerPixel = 0;
    double relativeError = 0;   // root mean square over the pixels of the 95 % half-width, over the mean luminance
    bool complete = true;       // false: interrupted, or too much of it has no value
    bool targetReached = true;
    TransportCounters counters;
    std::size_t valuelessPixels = 0;    // of more than a hundredth of their samples a part is missing; some: not complete
    std::vector<std::string> warnings;  // of what has no value
};

/// Whether a view can be rendered so: it has a size, and something ends the work.
///
/// errors  InvalidArgument
Result<void> checkRender(const View& view, const RenderSettings& settings);

/// Renders a view in passes over the whole picture, so that an interrupted one is noisy, not cut off.
///
/// afterPass  called with the picture so far now and then (showEverySeconds), for showing or saving it; may be empty
/// errors     InvalidArgument: no such algorithm, no size, nothing that ends the work
Result<RenderResult> render(const Project& project, const LitScene& lit, const View& view,
                            const RenderSettings& settings, const Progress& progress,
                            const std::function<void(const RenderResult&)>& afterPass = {});

/// The same by an estimator that is there already; of a view and settings that checkRender() lets pass.
RenderResult render(const Project& project, const LitScene& lit, const View& view, const RadianceEstimator& estimator,
                    const RenderSettings& settings, const Progress& progress, const std::function<void(const RenderResult&)>& afterPass = {});

}  // namespace luxdeck

#pragma once

#include "analysis/grids/grid_points.h"
#include "analysis/grids/measurement.h"
#include "analysis/grids/solve_result.h"
#include "engine/core/result.h"
#include "engine/scene/scene.h"

#include <map>
#include <string>
#include <vector>

namespace luxdeck {

/// A part of the light that can be dimmed by itself: luminaires of one name, or sky, surfaces, the ambient term.
struct Layer {
    std::string name;
    double dimming = 1;        // as it was solved; > 0
};

/// Which light belongs to which layer. Luminaires of one name and dimming make one layer; those that are off make none.
struct LayerMap {
    std::vector<Layer> layers;
    std::vector<std::uint32_t> ofLuminaire;  // #luminaires, index into layers; 0 of one that is off
    std::uint32_t sky = 0, surfaces = 0, ambient = 0;

    static LayerMap of(const Scene& scene);
    [[nodiscard]] std::uint32_t layerOf(LightSource source) const;
};

/// What a solve by layers keeps: every replicate of every layer at every point, so that any dimming of them has the
/// interval that a solve of its own would have had.
struct LayeredSums {
    std::vector<Layer> layers;
    std::vector<PointSums> points;  // of all grids, grid after grid, PointSums::layers filled
    std::string sceneHash;

    /// Illuminance of one layer at one point [lx].
    [[nodiscard]] Interval value(std::size_t point, std::size_t layer) const;
    /// The sums as if the layers had been dimmed by these factors.
    ///
    /// factors  #layers, on what was solved: 1 leaves a layer as it is
    [[nodiscard]] std::vector<PointSums> combined(const std::vector<double>& factors) const;
};

/// Points, statistics and verdicts for other dimmings, without tracing a ray.
///
/// dimmings  by a layer's name, or the beginning of names and a *: the new dimming, 0 .. 1 of a luminaire; of sky,
///           surfaces and ambient a factor >= 0
/// errors    InvalidArgument: no such layer (the message lists them), a value out of range; layers of another scene
Result<SolveResult> recombine(const Project& project, const LayeredSums& layers, const std::map<std::string, double>& dimmings);

/// The file of `solve --layers-out`, schema "luxdeck-layers/1": compact JSON of 64 numbers with nine digits a point
/// and layer, about 0.7 kB; a layer that gives a point nothing takes 5 bytes.
std::string layersJson(const LayeredSums& layers);
/// errors  Parse naming the key, what was seen and what was expected
Result<LayeredSums> readLayersJson(const std::string& text, const std::string& where);

}  // namespace luxdeck

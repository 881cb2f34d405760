#include "analysis/grids/layers.h"

#include "analysis/grids/condition.h"
#include "analysis/grids/grid_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace luxdeck {

namespace {

bool matches(const std::string& wanted, const std::string& name) {
    if (!wanted.empty() && wanted.back() == '*') return name.starts_with(wanted.substr(0, wanted.size() - 1));
    return wanted == name;
}

bool isLuminaire(const Layer& layer) { return layer.name != "sky" && layer.name != "surfaces" && layer.name != "ambient"; }

Result<std::vector<double>> factorsOf(const std::vector<Layer>& layers, const std::map<std::string, double>& dimmings) {
    std::vector<double> factors(layers.size(), 1.0);
    for (const auto& [wanted, dimming] : dimmings) {
        bool found = false;
        for (std::size_t i = 0; i < layers.size(); ++i) {
            if (!matches(wanted, layers[i].name)) continue;
            if (!(dimming >= 0 && std::isfinite(dimming)) || (isLuminaire(layers[i]) && dimming > 1))
                return Error{ErrorCode::InvalidArgument, fmt::format("dimming of \"{}\" is {}, expected 0 .. 1", wanted, dimming)};
            factors[i] = dimming / layers[i].dimming, found = true;
        }
        if (found) continue;
        std::string known;
        for (const auto& layer : layers) known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", layer.name);
        return Error{ErrorCode::InvalidArgument, fmt::format("no layer \"{}\" (a luminaire that was off when solving has none), expected one of: {}", wanted, known)};
    }
    return factors;
}

}  // namespace

LayerMap LayerMap::of(const Scene& scene) {
    LayerMap out;
    std::map<std::pair<std::string, double>, std::uint32_t> known;
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        const auto& l = scene.luminaires[i];
        out.ofLuminaire.push_back(0);
        if (!(l.dimming > 0)) continue;
        const std::string name = l.name.empty() ? fmt::format("luminaire {}", i + 1) : l.name;
        const auto [entry, isNew] = known.try_emplace({name, l.dimming}, static_cast<std::uint32_t>(out.layers.size()));
        if (isNew) out.layers.push_back({name, l.dimming});
        out.ofLuminaire.back() = entry->second;
    }
    for (auto* other : {&out.sky, &out.surfaces, &out.ambient}) {
        *other = static_cast<std::uint32_t>(out.layers.size());
        out.layers.push_back({other == &out.sky ? "sky" : other == &out.surfaces ? "surfaces" : "ambient", 1});
    }
    return out;
}

std::uint32_t LayerMap::layerOf(LightSource source) const {
    if (source == kFromSky) return sky;
    if (source == kFromSurfaces) return surfaces;
    if (source == kFromAmbient) return ambient;
    return ofLuminaire[source];
}

Interval LayeredSums::value(std::size_t point, std::size_t layer) const {
    const auto& sums = points[point];
    if (sums.perReplicate == 0) return {0, std::numeric_limits<double>::infinity()};
    const auto* own = &sums.layers[layer * 2 * kReplicates];
    std::array<double, kReplicates> means{};
    for (std::size_t r = 0; r < kReplicates; ++r) means[r] = (own[r] + own[kReplicates + r]) / sums.perReplicate;
    return sums.interval(means);  // what was not seen may be of this layer
}

std::vector<PointSums> LayeredSums::combined(const std::vector<double>& factors) const {
    std::vector<PointSums> out;
    out.reserve(points.size());
    double brightest = 1;  // what was not seen may be of any layer
    for (const double factor : factors) brightest = std::max(brightest, factor);
    for (const auto& point : points) {
        PointSums sums;
        sums.perReplicate = point.perReplicate, sums.backFaces = point.backFaces, sums.rejected = point.rejected;
        sums.lost = brightest * point.unseen() * static_cast<double>(point.samples());
        for (std::size_t layer = 0; layer < factors.size() && !point.layers.empty(); ++layer) {
            const auto* own = &point.layers[layer * 2 * kReplicates];
            for (std::size_t r = 0; r < kReplicates; ++r) {
                sums.direct[r] += factors[layer] * own[r];
                sums.indirect[r] += factors[layer] * own[kReplicates + r];
            }
        }
        out.push_back(std::move(sums));
    }
    return out;
}

Result<SolveResult> recombine(const Project& project, const LayeredSums& layers, const std::map<std::string, double>& dimmings) {
    if (layers.sceneHash != project.scene.hash)
        return Error{ErrorCode::InvalidArgument, fmt::format("the layers are of scene {}, expected {}: solve again, the project has changed", layers.sceneHash, project.scene.hash)};
    const auto factors = factorsOf(layers.layers, dimmings);
    if (!factors) return factors.error();
    std::vector<GridLayout> layouts;
    std::size_t points = 0;
    for (const auto& grid : project.grids) {
        auto layout = layOut(grid);
        if (!layout) return layout.error();
        points += layout->points.size();
        layouts.push_back(*std::move(layout));
    }
    if (points != layers.points.size())
        return Error{ErrorCode::InvalidArgument, fmt::format("the layers have {} points, expected {} of the project's grids: solve again", layers.points.size(), points)};
    SolveResult result;
    result.project = project.info.name;
    const auto sums = layers.combined(*factors);
    result.grids = gridResults(project, layouts, sums);
    result.condition = conditionOf(project.scene, sums);
    result.algorithm = "layers";
    for (const auto& point : layers.points) result.samples += point.samples();
    result.sceneHash = project.scene.hash, result.projectHash = project.fileHash;
    return result;
}

}  // namespace luxdeck

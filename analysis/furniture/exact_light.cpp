#include "analysis/furniture/taken_light.h"

#include "analysis/grids/sampling_run.h"
#include "engine/transport/surface/surface_point.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

Result<ExactTaken> solveTaken(const Project& project, const LitScene& lit, Scene furnished, const SolveSettings& settings, const Progress& progress) {
    auto empty = solve(project, lit, settings, progress);
    if (!empty) return empty.error();
    Project with = project;
    with.scene = std::move(furnished);
    const auto litWith = LitScene::create(with.scene);
    if (!litWith) return litWith.error();
    auto full = solve(with, *litWith, settings, progress);
    if (!full) return full.error();
    ExactTaken out{*std::move(empty), *std::move(full), {}};
    for (std::size_t i = 0; i < out.empty.grids.size(); ++i) {
        const auto &a = out.empty.grids[i], &b = out.furnished.grids[i];
        const auto &before = a.mean.interval, &after = b.mean.interval;
        out.grids.push_back({a.name, a.mean, b.mean, a.minimum, b.minimum, {before.value - after.value, std::hypot(before.ci95, after.ci95)}});
    }
    return out;
}

FullSolution solveVertices(const LitScene& furnished, const RadianceEstimator& estimator, const FurnitureLighting& lighting, std::size_t vertices,
                           std::uint32_t samples, std::uint64_t seed, const Progress& progress) {
    FullSolution out;
    const auto& object = lighting.object();
    const auto& weights = lighting.volume().weights;
    const auto& place = lighting.placement();
    const std::size_t step = std::max<std::size_t>(1, object.positions.size() / std::max<std::size_t>(1, vertices));
    std::vector<Target> targets;
    for (std::size_t v = 0; v < object.positions.size(); v += step) {
        if (!isFinite(lighting.lux()[v])) continue;
        Target t;
        t.stream = v;
        t.sensor.normal = place.direction(object.normals[v]);
        t.sensor.position = place.point(object.positions[v]);
        t.sensor.position += t.sensor.normal * (16 * spacingAt(t.sensor.position));
        targets.push_back(t);
        out.vertices.push_back(static_cast<std::uint32_t>(v));
    }
    SamplingRun run(estimator, furnished.transport().scene.weights, std::move(targets), seed);
    ProgressState state;
    state.stage = "solving the vertices";
    const std::vector<std::uint32_t> request(out.vertices.size(), std::max(1U, samples / kReplicates));
    run.round(request, progress, state, {});
    double off2 = 0, off = 0, sum = 0;
    std::size_t inside = 0, count = 0;
    for (std::size_t i = 0; i < out.vertices.size(); ++i) {
        const auto value = run.sums()[i].perReplicate > 0 ? run.sums()[i].total() : Interval{std::nan(""), 0};
        out.lux.push_back(value);
        if (!std::isfinite(value.value)) continue;
        const double d = luminance(lighting.lux()[out.vertices[i]], weights) - value.value;
        const double noise = value.ci95 / 2;
        off2 += d * d - noise * noise, off += d, sum += value.value;
        inside += std::abs(d) <= std::hypot(double{lighting.halfWidths()[out.vertices[i]]}, value.ci95) ? 1U : 0U;
        ++count;
    }
    const auto n = static_cast<double>(std::max<std::size_t>(count, 1));
    out.rms = std::sqrt(std::max(0.0, off2 / n)), out.bias = off / n, out.inside = static_cast<double>(inside) / n;
    out.relativeRms = sum > 0 ? out.rms / (sum / n) : 0;
    return out;
}

}  // namespace luxdeck

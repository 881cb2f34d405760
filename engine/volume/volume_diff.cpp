#include "engine/volume/volume_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace luxdeck {

namespace {

Result<void> checkSameShape(const IrradianceVolume& a, const IrradianceVolume& b) {
    if (a.settings.side != b.settings.side)
        return Error{ErrorCode::InvalidArgument, fmt::format("the volumes have {} and {} bins along a hemisphere's side, expected the same", a.settings.side, b.settings.side)};
    if (a.vertexCount() != b.vertexCount() || a.lattice.vertices() != b.lattice.vertices())
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("the volumes have other vertices ({} and {}): build both with the same grid, of the same bounds, and without --refine", a.vertexCount(), b.vertexCount())};
    if (a.origin != b.origin) return Error{ErrorCode::InvalidArgument, "the volumes have other origins of their coordinates"};
    return {};
}

Result<FieldDifference> comparePart(const IrradianceVolume& first, const IrradianceVolume& second, const FieldSettings& settings, const MomentWeights& weights) {
    const auto a = VolumeField::make(first, settings, &weights), b = VolumeField::make(second, settings, &weights);
    if (!a) return a.error();
    if (!b) return b.error();
    FieldDifference out;
    std::vector<double> differences;
    double square = 0, lux2 = 0, noise2 = 0;
    for (std::uint32_t v = 0; v < first.vertexCount(); ++v) {
        if (!first.quality[v].usable() || !second.quality[v].usable()) continue;
        ++out.vertices;
        const double ea = first.quality[v].standardError(), eb = second.quality[v].standardError();
        noise2 += ea * ea + eb * eb;
        for (int bin = 0; bin < first.bins().count(); ++bin) {
            const auto look = a->look(first.bins().centre(bin));
            const double x = luminance(a->atVertex(v, look), first.weights), y = luminance(b->atVertex(v, look), first.weights);
            differences.push_back(std::abs(x - y));
            square += (x - y) * (x - y), lux2 += x * x;
            out.meanFirst += x, out.meanSecond += y;
        }
    }
    if (differences.empty()) return Error{ErrorCode::InvalidArgument, "the volumes have no vertex that both know"};
    const auto n = static_cast<double>(differences.size());
    out.meanFirst /= n, out.meanSecond /= n;
    out.rmsLux = std::sqrt(square / n);
    const double scale = std::sqrt(lux2 / n);
    const auto at99 = differences.begin() + static_cast<std::ptrdiff_t>(0.99 * (n - 1));
    std::nth_element(differences.begin(), at99, differences.end());
    const double p99 = *at99;
    out.maxLux = *std::max_element(at99, differences.end());
    if (scale > 0) out.rms = out.rmsLux / scale, out.p99 = p99 / scale, out.max = out.maxLux / scale, out.noise = std::sqrt(noise2 / static_cast<double>(out.vertices)) / scale;
    return out;
}

}  // namespace

Result<VolumeDifferences> compareVolumes(const IrradianceVolume& first, const IrradianceVolume& second, int order) {
    if (const auto same = checkSameShape(first, second); !same) return same.error();
    FieldSettings settings;
    settings.order = order;
    const MomentWeights weights(first.bins(), order, settings.quadrature);
    VolumeDifferences out;
    for (const auto& [part, difference] : {std::pair{LightPart::Total, &out.total}, {LightPart::Direct, &out.direct}, {LightPart::Indirect, &out.indirect}}) {
        settings.part = part;
        const auto compared = comparePart(first, second, settings, weights);
        if (!compared) return compared.error();
        *difference = *compared;
    }
    return out;
}

Result<IrradianceVolume> volumeDifference(const IrradianceVolume& first, const IrradianceVolume& second) {
    if (const auto same = checkSameShape(first, second); !same) return same.error();
    IrradianceVolume out = first;
    out.algorithm = fmt::format("{} - {}", first.algorithm, second.algorithm);
    out.complete = first.complete && second.complete;
    out.seconds += second.seconds, out.rays += second.rays;
    for (std::size_t i = 0; i < out.direct.size(); ++i) out.direct[i] = first.direct[i] - second.direct[i], out.indirect[i] = first.indirect[i] - second.indirect[i];
    for (std::size_t v = 0; v < out.vertexCount(); ++v) {
        for (auto ray : second.sources[v]) ray.lux *= -1.0F, out.sources[v].push_back(ray);
        auto& q = out.quality[v];
        const auto& o = second.quality[v];
        for (std::size_t i = 0; i < q.lux.size(); ++i) q.lux[i] -= o.lux[i], q.spread[i] += o.spread[i];
        if (!o.usable()) q.samples = 0;
    }
    return out;
}

}  // namespace luxdeck

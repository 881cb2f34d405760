#include "engine/volume/volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace luxdeck {

double VertexQuality::standardError() const {
    if (samples < 2) return std::numeric_limits<double>::infinity();
    const double sum = std::accumulate(spread.begin(), spread.end(), 0.0);
    const double n = samples;
    return std::sqrt(sum / 6 / (n * (n - 1)));
}

double VertexQuality::meanLux() const { return std::accumulate(lux.begin(), lux.end(), 0.0) / 6; }

std::size_t IrradianceVolume::bytes() const {
    std::size_t found = 0;
    for (const auto& list : sources) found += list.size();
    return (direct.size() + indirect.size()) * sizeof(Rgb) + found * sizeof(SourceRay) + quality.size() * sizeof(VertexQuality) +
           lattice.cells().size() * sizeof(Lattice::Cell) + lattice.vertices().size() * sizeof(Vec3);
}

double IrradianceVolume::relativeError() const {
    double error2 = 0, lux2 = 0;
    for (const auto& q : quality) {
        if (!q.usable()) continue;
        error2 += q.standardError() * q.standardError();
        lux2 += q.meanLux() * q.meanLux();
    }
    if (error2 == 0) return 0;
    return lux2 > 0 ? std::sqrt(error2 / lux2) : std::numeric_limits<double>::infinity();
}

std::size_t IrradianceVolume::unusable() const {
    return static_cast<std::size_t>(std::count_if(quality.begin(), quality.end(), [](const auto& q) { return !q.usable(); }));
}

}  // namespace luxdeck

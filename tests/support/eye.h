#pragma once

#include "engine/core/statistics.h"
#include "tests/support/scenes.h"

#include <vector>

namespace luxdeck::test {

/// Mean radiance along one ray by `count` samples of the algorithm `path`, with its standard error.
struct Seen {
    double value = 0;          // green, which grey scenes have in all channels [cd/m^2]
    double standardError = 0;  // [cd/m^2]
    std::uint64_t rejected = 0;
};

inline Seen seenBy(const Lit& lit, const Vec3& from, const Vec3& direction, std::uint32_t count = 4096,
                   std::uint64_t seed = 1) {
    std::vector<RadianceQuery> queries(count);
    std::vector<RadianceSample> samples(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        // Sets of their own, so that the samples are independent and their variance can be told from them.
        queries[i].ray = {from, 0, direction.normalized(), kInfinity};
        queries[i].numbers = SamplePath(streamSeed(seed, i), 0);
    }
    const auto counters = lit.estimator("path")->radiance(queries, samples);
    MeanVariance mean;
    for (const auto& s : samples)
        if (s.failure == RayFailure::None) mean.add(s.total().g);
    return {mean.mean(), std::sqrt(mean.meanVariance()), counters.rejected};
}

}  // namespace luxdeck::test

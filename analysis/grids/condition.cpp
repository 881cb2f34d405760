#include "analysis/grids/condition.h"

#include "analysis/grids/solver.h"
#include "engine/transport/enclosure.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck {

namespace {

/// (sum m)^2 / sum m^2 of the replicates' means: all of them when they agree, 1 when one holds all the light [-].
double effectiveReplicates(const PointSums& sums) {
    double sum = 0, squares = 0;
    for (const double mean : sums.totalMeans()) sum += mean, squares += mean * mean;
    return squares > 0 ? sum * sum / squares : kReplicates;
}

}  // namespace

Condition conditionOf(const Scene& scene, const std::vector<PointSums>& sums) {
    Condition out;
    out.meanReflectance = meanReflectance(scene);
    // In a room that gives back all, light grows without bound: as far as a double goes.
    out.amplification = 1 / std::max(1 - out.meanReflectance, 1e-9);
    double mean = 0;
    std::size_t known = 0;
    for (const auto& s : sums)
        if (s.perReplicate > 0) mean += s.total().value, ++known;
    if (known > 0) mean /= static_cast<double>(known);
    out.effectiveReplicates = kReplicates;
    for (const auto& s : sums)
        if (s.perReplicate > 0 && s.total().value >= kDarkPoint * mean)
            out.effectiveReplicates = std::min(out.effectiveReplicates, effectiveReplicates(s));
    return out;
}

std::vector<std::string> conditionWarnings(const Condition& c, double truncatedFraction) {
    std::vector<std::string> out;
    if (c.amplification > kBadAmplification)
        out.push_back(fmt::format("the surfaces reflect {:.1f} % on average, so reflections multiply light up to {:.0f} times: an error of 0.01 in the "
                                  "reflectances shifts values by up to {:.0f} %", 100 * c.meanReflectance, c.amplification, c.amplification));
    if (truncatedFraction > kBadTruncation)
        out.push_back(fmt::format("up to {:.2g} % of the light was not followed to its end: values are too low by up to as much", 100 * truncatedFraction));
    if (c.effectiveReplicates < kBadReplicates)
        out.push_back(fmt::format("at the worst point a few bright paths carry the value ({:.1f} of {} replicates count): its interval is wide for that, "
                                  "more time narrows it", c.effectiveReplicates, kReplicates));
    return out;
}

}  // namespace luxdeck

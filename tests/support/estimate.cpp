#include "tests/support/estimate.h"

#include <cmath>

namespace luxdeck::test {

namespace {

Estimate estimateOf(const std::vector<PointSums>& sums, bool direct, bool indirect) {
    double value = 0, variance = 0;
    for (const auto& s : sums) {
        MeanVariance mv;
        const auto d = s.directMeans(), i = s.indirectMeans();
        for (std::size_t r = 0; r < kReplicates; ++r) mv.add((direct ? d[r] : 0) + (indirect ? i[r] : 0));
        value += mv.mean(), variance += mv.meanVariance();
    }
    const auto n = static_cast<double>(sums.size());
    return {value / n, std::sqrt(variance) / n};
}

}  // namespace

SensorEstimate meanIlluminance(const Lit& lit, const RadianceEstimator& estimator, const std::vector<SensorQuery>& sensors,
                               double relative, std::uint64_t seed) {
    std::vector<Target> targets(sensors.size());
    for (std::size_t i = 0; i < sensors.size(); ++i) targets[i].sensor = sensors[i], targets[i].stream = i;
    SamplingRun run(estimator, lit.scene.weights, std::move(targets), seed);
    std::vector<std::uint32_t> request(sensors.size(), 16);
    ProgressState state;
    const Progress progress;
    SensorEstimate out;
    for (std::uint32_t perReplicate = 16; perReplicate <= (1U << 17); perReplicate *= 2) {
        run.round(request, progress, state, std::nullopt);
        out = {estimateOf(run.sums(), true, false), estimateOf(run.sums(), false, true), estimateOf(run.sums(), true, true)};
        if (1.96 * out.total.standardError <= relative * out.total.value) break;
        request.assign(sensors.size(), perReplicate);
    }
    return out;
}

SensorEstimate illuminance(const Lit& lit, const RadianceEstimator& estimator, const SensorQuery& sensor, double relative,
                           std::uint64_t seed) {
    return meanIlluminance(lit, estimator, {sensor}, relative, seed);
}

}  // namespace luxdeck::test

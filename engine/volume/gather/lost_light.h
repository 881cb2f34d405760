#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// Answers with the most that another estimator's samples lack, as indirect light: what a volume of it holds bounds what a
/// volume of that estimator lacks. Where nothing is known the answer is infinite.
class LostLight final : public RadianceEstimator {
public:
    /// Takes paths that keep what they find and say what they lack.
    explicit LostLight(std::unique_ptr<const RadianceEstimator> paths) : paths_(std::move(paths)) {}

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        const auto counters = paths_->radiance(queries, samples);
        for (auto& s : samples) {
            s.indirect = s.lost;
            s.emitted = s.direct = s.lost = Rgb{};
            s.failure = RayFailure::None;
        }
        return counters;
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        const auto counters = paths_->irradiance(queries, samples);
        for (auto& s : samples) {
            s.indirect = s.lost;
            s.direct = s.lost = Rgb{};
            s.failure = RayFailure::None;
        }
        return counters;
    }

private:
    std::unique_ptr<const RadianceEstimator> paths_;
};

}  // namespace luxdeck

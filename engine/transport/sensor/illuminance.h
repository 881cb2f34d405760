#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/path_batch.h"

#include <span>

namespace luxdeck {

/// How sensors look for light.
struct SensorSettings {
    int lightSamples = 1;  // shadow rays to chosen lights for every path
    float goesOn = 1;      // with share: the part of the paths that go on from a matte surface that the group sees
    bool share = false;    // sensors of a group take what each other's paths found on matte surfaces
    const IrradianceField* control = nullptr;  // with share: TracerSettings::control
    float controlWeight = 1;
};

/// Illuminance by shadow rays to chosen lights and one path from a direction chosen by the sensor's own
/// weighting (cosine, or sine for a cylinder): direct light is what both see without a reflection, indirect
/// what the path gathers. Light that both can find is shared by multiple importance sampling.
///
/// settings   maxReflections 0: direct alone; else light reflected up to that often
TransportCounters gatherIlluminance(const TransportScene& scene, const TracerSettings& settings,
                                    std::span<const SensorQuery> queries, std::span<SensorSample> samples,
                                    const SensorSettings& sensors = {});

}  // namespace luxdeck

#include "engine/algorithms/registry.h"

#include "engine/transport/ambient/ambient_estimator.h"
#include "engine/transport/control/controlled_estimator.h"
#include "engine/transport/direct/direct_estimator.h"
#include "engine/transport/enclosure.h"
#include "engine/transport/irradiance_cache/irradiance_cache_estimator.h"
#include "engine/transport/path/path_estimator.h"
#include "engine/transport/photon_map/photon_map_estimator.h"
#include "engine/transport/radiosity/radiosity_estimator.h"
#include "engine/transport/shared/shared_estimator.h"
#include "engine/volume/gather/volume_gather_estimator.h"

#include <fmt/format.h>

#include <memory>

namespace luxdeck {

const std::vector<Algorithm>& algorithms() {
    static const std::vector<Algorithm> all{
        {"path", "unbiased path tracing: all interreflection, error by time alone", true, makePathEstimator},
        {"shared", "unbiased path tracing whose neighbouring sensors share the light that their paths found", true, makeSharedEstimator},
        {"volume_gather", "one bounce from surfaces that an irradiance volume lights: quick after its set-up, biased in corners", true, makeVolumeGatherEstimator,
         0.04, {{"sensor inside a solid", "a thousandth of the room's light leaks into a closed box at its edges"}}},
        {"controlled", "unbiased: neighbouring sensors share paths, whose missing ends a coarse radiosity solution stands for", true,
         makeControlledEstimator},
        {"direct", "light straight from luminaires and sky, no interreflection", false, makeDirectEstimator},
        {"ambient", "direct light and a constant ambient illuminance (--ambient LX, zero by default)", false,
         makeAmbientEstimator},
        {"radiosity", "light between the elements of a mesh of the matte surfaces, seen by final gather", true, makeRadiosityEstimator, 0.01},
        {"irradiance_cache", "indirect light interpolated between records on the surfaces (Ward 1988): prepared first, little noise, small bias", true,
         makeIrradianceCacheEstimator, 0.02},
        {"photon_map", "photons followed from the lights, their density on matte surfaces seen by final gather", true, makePhotonMapEstimator, 0.02},
    };
    return all;
}

const Algorithm* algorithmNamed(const std::string& name) {
    for (const auto& a : algorithms())
        if (a.name == name) return &a;
    return nullptr;
}

Result<std::unique_ptr<RadianceEstimator>> makeEstimator(const std::string& algorithm, const TransportScene& scene,
                                                         const AlgorithmSettings& settings) {
    if (const auto* found = algorithmNamed(algorithm)) {
        if (found->interreflection)
            if (const auto ends = checkThatLightIsLost(scene); !ends) return ends.error();
        return found->create(scene, settings);
    }
    std::string known;
    for (const auto& a : algorithms()) known += (known.empty() ? "" : ", ") + a.name;
    return Error{ErrorCode::InvalidArgument, fmt::format("no algorithm \"{}\", expected one of: {}", algorithm, known)};
}

Result<std::unique_ptr<RadianceEstimator>> makeEstimator(const std::string& algorithm, const TransportScene& scene, AlgorithmSettings settings,
                                                         std::uint64_t seed, const Progress& progress) {
    settings.seed = seed, settings.progress = &progress;
    return makeEstimator(algorithm, scene, settings);
}

}  // namespace luxdeck

#pragma once

#include "engine/transport/radiance_estimator.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck {

/// A registered algorithm. Registering it enrols it in every analytic, statistical and stability case, in
/// `--algorithm`, in `compare` and in the documentation.
struct Algorithm {
    std::string name;           // letters, digits and underscores
    std::string summary;        // one line, for --help and the report
    bool interreflection;       // claims the exact indirect light of diffuse rooms
    Result<std::unique_ptr<RadianceEstimator>> (*create)(const TransportScene&, const AlgorithmSettings&);
    double bias = 0;            // of what it claims, relative: what no number of samples cures at effort 1; 0: unbiased
    std::map<std::string, std::string> limits;  // stability cases that it fails by its nature, and why
};

const std::vector<Algorithm>& algorithms();
/// The one of a name; null when there is none.
const Algorithm* algorithmNamed(const std::string& name);

/// errors  InvalidArgument: no such algorithm (the message lists them), a setting out of range, light never lost (enclosure.h);
///         Cancelled, OutOfResources: of algorithms that prepare something
Result<std::unique_ptr<RadianceEstimator>> makeEstimator(const std::string& algorithm, const TransportScene& scene,
                                                         const AlgorithmSettings& settings = {});

/// The same with what a command knows: the preparation uses its seed, and tells and obeys its progress.
Result<std::unique_ptr<RadianceEstimator>> makeEstimator(const std::string& algorithm, const TransportScene& scene, AlgorithmSettings settings,
                                                         std::uint64_t seed, const Progress& progress);

}  // namespace luxdeck

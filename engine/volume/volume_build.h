#pragma once

#include "engine/core/progress.h"
#include "engine/io/project.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/volume/vertex_sampler.h"
#include "engine/volume/volume.h"

#include <functional>
#include <optional>
#include <string>

namespace luxdeck {

/// Where finished vertices are kept while a volume is built, and found again by the next session.
class VertexStore {
public:
    virtual ~VertexStore() = default;
    /// What an earlier session knew of a place; empty: nothing.
    virtual std::optional<VertexState> find(const Vec3& position) = 0;
    /// Keeps finished vertices. Called from one thread, a few times a second.
    ///
    /// errors  OutOfResources (disk)
    virtual Result<void> keep(std::span<const Vec3> positions, std::span<const VertexState> states) = 0;
};

struct BuildOptions {
    std::string algorithm = "path";      // what the estimator is called, for the record
    std::uint64_t seed = 1;
    double targetError = 0;              // relative standard error times 1.96; above 0: samples are doubled until it is met
    std::optional<double> timeSeconds;   // no new samples after that
    VertexStore* store = nullptr;
};

/// Builds the volume of a scene: lays the lattice out, looks around from each of its vertices, divides further where the
/// settings ask for it. Cancelled or out of time it comes back incomplete, vertices without samples being unusable.
///
/// errors  InvalidArgument: settings out of range, a scene without extent; OutOfResources: memory, the store
Result<IrradianceVolume> buildVolume(const TransportScene& scene, const RadianceEstimator& estimator, const VolumeSettings& settings,
                                     const BuildOptions& options, const Progress& progress);

/// What a project's [[volume]] of this name asks for; with an empty name the first one, or the defaults where there is none.
///
/// errors  InvalidArgument: no such volume (the message lists them)
Result<VolumeSettings> volumeSettingsOf(const Project& project, const std::string& name);

/// The lattice that buildVolume() begins with: all of it, unless cells are divided by light.
///
/// errors  InvalidArgument: settings out of range, a scene without extent
Result<Lattice> volumeLattice(const Scene& scene, const VolumeSettings& settings);

/// Bounds of a volume: those asked for, or those of the scene drawn in by the inset.
///
/// errors  InvalidArgument: nothing has an extent
Result<Box3> volumeBounds(const Scene& scene, const VolumeSettings& settings);

}  // namespace luxdeck

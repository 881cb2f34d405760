#pragma once

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/raycast/raycaster.h"
#include "engine/sampling/light_sampler.h"
#include "engine/sampling/mirrors.h"
#include "engine/sampling/sobol.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace luxdeck {

class SkySampler;

/// One ray to find the radiance along.
struct RadianceQuery {
    Ray ray;
    SamplePath numbers;        // the sample's own; continued along the path
    /// When the caller also samples lights by next-event estimation at `origin`: the density of this
    /// direction, so that light seen directly comes back weighted by multiple importance sampling
    /// (balance heuristic). 0: light that is seen comes back in full.
    float pdfSolidAngle = 0;   // [1/sr]
    Receiver origin;           // used when pdfSolidAngle > 0
};

enum class RayFailure : std::uint8_t { None, BadRay, NotFinite, Negative };

/// Light that next-event estimation does not seek, since a curved mirror or a solid that bends it stands between: what a
/// path's own directions found of it, and what there may be. Luminances or illuminances, of one sample.
struct ChanceLight {
    float diffused = 0;  // what the sample would have got if those surfaces spread their light evenly, times how uneven it
                         // may be (docs/decisions/0012)
    float peak = 0;      // the most that one such find may be; infinite: points without extent are never found
    float found = 0;     // a part of the sample

    void add(const ChanceLight& o, float factor) {
        diffused += o.diffused * factor, found += o.found * factor;
        peak = peak > o.peak * factor ? peak : o.peak * factor;
    }
};

/// The radiance along one ray, in parts, and what the ray met first.
struct RadianceSample {
    Rgb emitted;               // from luminaires, sky and emitting surfaces, without any reflection [cd/m^2]
    Rgb direct;                // after one reflection
    Rgb indirect;              // after two or more
    float distance = kInfinity;         // to what was met first, panes and mirrors included [m]
    float virtualDistance = kInfinity;  // to the first thing that is neither flat mirror nor pane [m]
    Vec3 normal{0, 0, 0};      // geometric, towards the viewer; zero when nothing was met
    std::uint32_t object = kNothing;    // index into Scene::objects of what was met first
    bool backFace = false;     // it was met from behind, as its triangles are wound
    RayFailure failure = RayFailure::None;  // not None: a part is missing, and what was found before it is there
    Rgb lost;                  // failed: the most that the missing part may be (docs/decisions/0011) [cd/m^2]; infinite:
                               // nothing is known of it
    std::uint32_t lostAt = kNothing;    // index into Scene::materials of the surface without a value that was met first
    ChanceLight chance;

    [[nodiscard]] Rgb total() const { return emitted + direct + indirect; }
};

enum class SensorKind : std::uint8_t { Planar, Cylindrical };

/// One sample of the light that falls on a point.
struct SensorQuery {
    Vec3 position{0, 0, 0};    // [m], re-based
    Vec3 normal{0, 0, 1};      // unit; of a cylindrical sensor: its axis
    SensorKind kind = SensorKind::Planar;
    SamplePath numbers;
    /// Neighbours asked together: consecutive queries of one group may help each other where the algorithm
    /// shares light between sensors.
    std::uint32_t group = kNothing;
};

struct SensorSample {
    Rgb direct;                // straight from luminaires and sky, panes in between allowed [lx]
    Rgb indirect;              // after one reflection or more [lx]
    bool sawBackFace = false;  // the ray met a triangle from behind: the sensor may be inside a solid
    RayFailure failure = RayFailure::None;  // not None: a part is missing, and what was found before it is there
    Rgb lost;                  // failed: the most that the missing part may be [lx]; infinite: nothing is known of it
    std::uint32_t lostAt = kNothing;  // as RadianceSample::lostAt
    ChanceLight chance;

    [[nodiscard]] Rgb total() const { return direct + indirect; }
};

/// One contribution to one sample, and the light that it comes from. The contributions of a sample add up to
/// its parts, up to the rounding of their sums.
struct SourceShare {
    Rgb light;                 // as the sample's parts
    std::uint32_t query = 0;   // index into the batch
    LightSource source = kFromSky;
    bool direct = false;       // a part of SensorSample::direct, else of indirect
};

/// What a batch cost and what it lost. Sums of integers, and of one float per batch in index order.
struct TransportCounters {
    std::uint64_t rays = 0;        // closest-hit and occlusion queries
    std::uint64_t paths = 0;
    std::uint64_t rejected = 0;    // samples with a failure: a part of them is missing
    std::uint64_t truncated = 0;   // paths that the depth cap ended
    double truncatedWeight = 0;    // sum of their throughputs: over `paths` a bound on the relative loss

    TransportCounters& operator+=(const TransportCounters& o) {
        rays += o.rays, paths += o.paths, rejected += o.rejected, truncated += o.truncated;
        truncatedWeight += o.truncatedWeight;
        return *this;
    }
};

/// Answers the one question of the whole system: how much light. Immutable after creation, safe to call
/// from any number of threads; the answer to a query depends on the query alone, or on those of its group.
class RadianceEstimator {
public:
    virtual ~RadianceEstimator() = default;

    /// samples[i] becomes one estimate for queries[i]; both #Q.
    virtual TransportCounters radiance(std::span<const RadianceQuery> queries,
                                       std::span<RadianceSample> samples) const = 0;
    /// samples[i] becomes one estimate of the illuminance at queries[i]; both #Q.
    virtual TransportCounters irradiance(std::span<const SensorQuery> queries,
                                         std::span<SensorSample> samples) const = 0;

    /// Memory of what was prepared before the first query [bytes].
    [[nodiscard]] virtual std::size_t bytes() const { return 0; }

    /// How many neighbouring sensors are best asked together as a group.
    [[nodiscard]] virtual std::size_t groupSize() const { return 1; }

    /// Whether irradianceBySource() does its work.
    [[nodiscard]] virtual bool knowsSources() const { return false; }
    /// irradiance(), the same bits, with what each light gave in `shares` (cleared first).
    virtual TransportCounters irradianceBySource(std::span<const SensorQuery> queries, std::span<SensorSample> samples,
                                                 std::vector<SourceShare>& shares) const {
        shares.clear();
        return irradiance(queries, samples);
    }
};

/// What every algorithm works on. All must outlive the estimators made from it.
struct TransportScene {
    const Scene& scene;
    const SceneNeeds& needs;
    const Raycaster& raycaster;
    const LightSampler& lights;
    const Mirrors& mirrors;
    const SkySampler* sky = nullptr;  // none: no sky, or it is left to the receivers' own directions
};

/// Settings of the algorithms; each reads those that its card names.
struct AlgorithmSettings {
    double ambientLux = 0;    // ambient: the constant term [lx], 0 .. 1e6
    int maxVertices = 20000;  // path: the cap that ends paths Russian roulette leaves alive, 2 .. 10^6

    // Of algorithms that prepare something before the first query (a cache, a mesh, photons):
    double effort = 1;        // of the preparation: its time is about proportional, its error falls, 1e-3 .. 1e3
    std::uint64_t seed = 1;   // of what is random in it
    const Progress* progress = nullptr;  // hears how it goes and may cancel it; none: silent
};

}  // namespace luxdeck

#pragma once

#include "engine/core/rng.h"
#include "engine/transport/photon_map/light_emission.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/transport/surface/surface_elements.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/transport/tracer/media.h"

#include <cstdint>
#include <vector>

namespace luxdeck {

/// Light that arrived on an element.
struct Deposit {
    std::uint32_t element = 0;
    Rgb power;                    // [lm], to be divided by the number emitted
    bool lost = false;            // beyond a surface without a value: it may be missing
};

/// Follows photons from their sources through the scene by the materials' own scattering, and notes what arrives on
/// matte surfaces of the light that a field holds: what was reflected at least once. Light that only went straight
/// through panes and holes, or was only refracted, is found by the paths that ask the field; but for refracted light of a
/// luminaire without extent, which no path meets.
class PhotonTracer {
public:
    PhotonTracer(const TransportScene& scene, const LightEmission& emission, const SurfaceElements& elements, const AlgorithmSettings& settings)
        : scene_(scene), emission_(emission), elements_(elements), seed_(settings.seed), maxVertices_(settings.maxVertices) {}

    struct Arrived {
        std::vector<Deposit> deposits;
        TransportCounters counters;   // rejected: photons that met a pattern without a value
        bool unbounded = false;       // a light itself has no value: anything may be missing
    };
    /// Photons first .. first + count - 1.
    [[nodiscard]] Arrived trace(std::uint32_t first, std::uint32_t count) const;

private:
    struct Photon {
        Ray ray;
        Rgb power;
        RandomStream random{0};       // of its own: over a thousand reflections quasi-random numbers are no longer even
        Media media;
        int vertices = 0;
        bool reflected = false;
        bool bent = false;            // refracted, of a luminaire without extent
        bool fromPoint = false;
        bool lost = false;            // it met a surface without a value
        bool ended = false;
    };
    void meet(Photon& photon, const Hit& hit, Arrived& arrived) const;
    void scatter(Photon& photon, const Hit& hit, const SurfacePoint& point, Arrived& arrived) const;
    void deposit(const Photon& photon, const Hit& hit, const SurfacePoint& point, Arrived& arrived) const;
    static void loseSight(Photon& photon, SurfacePoint& point, Arrived& arrived);
    static void loseLight(Photon& photon, Arrived& arrived);
    static float next1D(Photon& photon) { return static_cast<float>(photon.random.next64() >> 40) * 0x1.0p-24F; }

    const TransportScene& scene_;
    const LightEmission& emission_;
    const SurfaceElements& elements_;
    std::uint64_t seed_;
    int maxVertices_;
};

}  // namespace luxdeck

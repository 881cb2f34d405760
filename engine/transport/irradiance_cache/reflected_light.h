#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/irradiance_field.h"
#include "engine/transport/tracer/mirrored_light.h"
#include "engine/transport/tracer/path_batch.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace luxdeck {

/// Asks for light that reaches surfaces after one reflection or more, a direction at a time, and traces all that was
/// asked in one batch. As a sensor does (sensor/illuminance.cpp), lamps mirrored in flat mirrors and panes are sought
/// apart from the directions.
class ReflectedLight {
public:
    /// Of one direction.
    struct Answer {
        Rgb radiance;               // from there, but for what is in `mirrored` [cd/m^2]
        Rgb mirrored;               // one sample of all lamps in mirrors [lx]
        Vec3 mirroredFrom{0, 0, 1}; // where that sample came from, unit
        float distance = kInfinity; // to the first thing that is no flat mirror or pane [m]
        Rgb lost;                   // the most that may be missing of it all, as radiance; infinite: nothing is known of it
    };

    /// settings  how paths go on; a field where they may end
    ReflectedLight(const TransportScene& scene, const TracerSettings& settings) : scene_(scene), settings_(settings) {}

    /// Directions asked from now on leave this point.
    void stand(const FieldPoint& point);
    /// A direction of the hemisphere about the shading normal, chosen with density cos / pi.
    void ask(const Vec3& direction, SamplePath numbers);

    /// #asked, in their order. May be called once.
    std::vector<Answer> trace();
    [[nodiscard]] const TransportCounters& counters() const { return counters_; }

private:
    struct Mirrored {
        MirrorPath path;
        Rgb lux;
        Vec3 origin;
        std::size_t asked;
    };
    const TransportScene& scene_;
    TracerSettings settings_;
    FieldPoint point_;
    Receiver at_;
    std::unique_ptr<MirrorTable> mirrors_;  // as the point sees them; none: no lamps, or no mirrors
    std::vector<RadianceQuery> queries_;
    std::vector<std::size_t> asked_;        // by query; directions below the surface itself are not traced
    std::vector<Mirrored> mirrored_;
    std::vector<Answer> answers_;
    TransportCounters counters_;
};

}  // namespace luxdeck

#pragma once

#include "engine/transport/irradiance_cache/record.h"
#include "engine/transport/tracer/irradiance_field.h"

#include <array>

namespace luxdeck {

/// Whether a record's light may be a point's too, beyond what the weights say.
enum class Sight {
    Hidden,  // behind the record, on a step above or below it, or something stands on the surface between them
    Open,
    Asked    // on a bent surface: the rays tell
};

/// Rays that are free when point and record see each other: straight where the surface between them is hollow, by the
/// meeting of their tangent planes where it bulges.
struct SightRays {
    std::array<Ray, 2> rays;
    int count = 0;
};

/// In one plane the record's horizon decides, without a ray. Otherwise Ward's test of which is in front of the other, made
/// stricter: the way between them must lie along both surfaces, or a shelf would lend its light to the shelf below.
Sight sightOf(const IrradianceRecord& record, const FieldPoint& point, SightRays& rays);

}  // namespace luxdeck

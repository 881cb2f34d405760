#pragma once

#include "analysis/furniture/movable_object.h"
#include "analysis/furniture/triangle_stream.h"
#include "engine/core/progress.h"
#include "engine/raycast/raycaster.h"
#include "engine/volume/field.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace luxdeck {

struct StreamSettings {
    double metresPerUnit = 1;
    bool yUp = false;             // the model's y is up
    Vec3 at{0, 0, 0};             // where the model's origin goes, re-based [m]
    double turnDeg = 0;           // about the vertical through it
};

struct StreamCounts {
    std::uint64_t triangles = 0;
    std::uint64_t skipped = 0;    // without an area, or not finite
    std::uint64_t unknown = 0;    // vertices that no vertex of the volume sees: NaN
    double shadingSeconds = 0;    // without reading and writing
    double minimumLux = 0, maximumLux = 0;  // of what is known
};

/// Hears of shaded triangles, in the file's order: their vertices (re-based [m]) and the illuminance of each, three each [lx].
using ShadedSink = std::function<Result<void>(std::span<const Vec3> positions, std::span<const Rgb> lux)>;

/// Lights a model that is not in the scene, of any size: triangles are read, lit flat at their three vertices, given away
/// and forgotten (thesis 5.2). A few MB whatever the model's size.
///
/// field   irradiance (order 1), bins blended
/// room    stops interpolation at walls; null: plain interpolation, for models that replace a surface of the room
/// errors  of the stream and the sink; Cancelled
Result<StreamCounts> shadeStream(TriangleStream& stream, const VolumeField& field, const Raycaster* room, const StreamSettings& settings,
                                 const ShadedSink& sink, const Progress& progress);

}  // namespace luxdeck

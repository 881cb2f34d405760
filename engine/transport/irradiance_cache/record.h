#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/transport/irradiance_cache/hemisphere.h"
#include "engine/transport/irradiance_cache/surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace luxdeck {

struct CacheAccuracy;

/// Indirect irradiance at one place of a matte surface, and how it goes on from there.
struct IrradianceRecord {
    Vec3 position{0, 0, 0};         // just off the surface [m]
    Vec3 normal{0, 0, 1};           // of shading, unit
    Vec3 geometricNormal{0, 0, 1};
    float distance = 0;             // mean to what surrounds it, clamped by its neighbours' [m]
    Rgb irradiance;                 // [lx]
    Rgb gap;                        // the most that it may lack, as RadianceSample::lost [lx]
    ColourGradient rotation;        // [lx]
    ColourGradient translation;     // [lx/m]
    Horizon horizon;

    /// E at a place near it, each channel at least 0. `clamped` grows when one was below.
    [[nodiscard]] Rgb at(const Vec3& place, const Vec3& facing, std::uint64_t& clamped) const {
        const Rgb e = irradiance + rotation.along(facing) + translation.along(place - position);
        if (e.min() >= 0) return e;
        ++clamped;
        return {std::max(e.r, 0.0F), std::max(e.g, 0.0F), std::max(e.b, 0.0F)};
    }

    /// Cuts changes over the reach of the record to half of its irradiance: what is steeper is mostly noise, or an edge that
    /// no gradient follows.
    void limitGradients(const CacheAccuracy& accuracy);
};

/// How far records may be used. Ward's error estimate, with the angle's part bounded by itself: in a coarse cache a
/// record reaches far, but not around an edge.
struct CacheAccuracy {
    float place = 0.2F;   // of the way over the mean distance
    float facing = 0.2F;  // of sqrt(1 - n . n')

    explicit CacheAccuracy(float accuracy) : place(accuracy), facing(std::min(accuracy, 0.35F)) {}

    /// 1 at the record, falling to 0 where its error is as large as the accuracy; not positive beyond.
    /// Source: Ward, Rubinstein & Clear 1988 for the error, Krivanek et al. 2005 for the fall to zero.
    [[nodiscard]] float weight(const IrradianceRecord& record, const Vec3& position, const Vec3& normal) const {
        const float away = (position - record.position).length() / (place * record.distance);
        if (away >= 1) return 0;
        return 1 - away - std::sqrt(std::max(0.0F, 1 - dot(normal, record.normal))) / facing;
    }
    [[nodiscard]] CacheAccuracy scaled(float factor) const {
        CacheAccuracy out(*this);
        out.place *= factor, out.facing *= factor;
        return out;
    }
    [[nodiscard]] float reach(const IrradianceRecord& record) const { return place * record.distance; }
};

inline void IrradianceRecord::limitGradients(const CacheAccuracy& accuracy) {
    const auto limit = [](Vec3& gradient, float most) {
        const float length = gradient.length();
        if (length > most) gradient *= most / length;
    };
    const float perMetre = 0.5F / accuracy.reach(*this);
    limit(translation.r, irradiance.r * perMetre), limit(translation.g, irradiance.g * perMetre), limit(translation.b, irradiance.b * perMetre);
    limit(rotation.r, irradiance.r / accuracy.facing), limit(rotation.g, irradiance.g / accuracy.facing), limit(rotation.b, irradiance.b / accuracy.facing);
}

}  // namespace luxdeck

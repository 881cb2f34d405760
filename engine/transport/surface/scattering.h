#pragma once

#include "engine/core/vec.h"
#include "engine/transport/spectrum.h"

namespace luxdeck {

/// What a surface does with light from one direction, all parts but the perfectly specular ones.
template <Spectrum S>
struct ScatterValue {
    S cosineWeighted{0.0F};  // f |cos wi|
    float pdf = 0;           // of sampling wi [1/sr]
    S diffuse{0.0F};         // the part of cosineWeighted that depends on wo by a factor of its cosine alone
};

/// A direction that a surface chose. Directions point away from it.
template <Spectrum S>
struct ScatterSample {
    Vec3 wi;
    S weight;                    // f |cos| / pdf, or the specular throughput over its chance
    float pdf = 0;               // [1/sr]; 0: specular
    bool passedThrough = false;  // straight on
    bool refracted = false;      // into the solid on the other side, or out of it
    bool absorbed = false;
    S diffuse{0.0F};             // the part of weight that depends on wo by a factor of its cosine alone

    /// Weighs wi by the value that the surface has there.
    void weighBy(const ScatterValue<S>& value) {
        pdf = value.pdf;
        absorbed = !(pdf > 0);
        if (absorbed) return;
        weight = value.cosineWeighted * (1 / pdf);
        diffuse = value.diffuse * (1 / pdf);
    }
};

}  // namespace luxdeck

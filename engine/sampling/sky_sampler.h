#pragma once

#include "engine/core/rgb.h"
#include "engine/sampling/receiver.h"
#include "engine/sampling/sky_cells.h"
#include "engine/sampling/sky_map.h"
#include "engine/scene/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace luxdeck {

/// A direction towards sky or sun, chosen by next-event estimation.
struct SkySample {
    Vec3 direction{0, 0, 1};   // unit
    Rgb radiance;              // [cd/m^2]
    float pdfSolidAngle = 0;   // [1/sr]
    bool shared = false;       // the receiver's own directions look for this light too
};

/// Chooses directions towards the sky by its luminance and, indoors, by what of it can be seen, and towards suns.
///
/// A part of the choices goes by luminance alone, so that no visible piece of sky is found only by luck. The
/// receivers' own directions find the sky as well: both share it by the balance heuristic. A sun is left to
/// choosing alone, but for glossy receivers.
class SkySampler {
public:
    explicit SkySampler(const Scene& scene);

    /// Looks for the sky from inside the scene; until then luminance alone counts.
    void findVisible(std::unique_ptr<const SkyVisibility> visibility);

    [[nodiscard]] bool black() const { return plain_.back().black() && suns_.empty(); }
    [[nodiscard]] SkySample sample(const Receiver& at, float uSelect, Vec2 u) const;
    /// Density with which sample() chooses a unit direction of the sky.
    [[nodiscard]] float pdf(const Receiver& at, const Vec3& direction) const;
    /// The same of a direction within a sun; infinite where suns are left to sample().
    [[nodiscard]] float pdfSun(const Receiver& at, std::size_t sun) const;
    /// The part of all choices of a light that the sky should have, lamps taking the rest: 1 where there are none.
    [[nodiscard]] float share(const Receiver& at) const;
    [[nodiscard]] const SkyCells* cells() const { return cells_.get(); }

private:
    /// What is known where light is asked for.
    struct Place {
        const SkyView* view = nullptr;  // none: outdoors
        const SkyTable* plain = nullptr;
        float skyLux = 0;
        float sunLux = 0;               // of all suns
        float sunProbability = 0;       // that one of them is chosen
        float viewProbability = 0;      // of the sky: that its view decides
    };
    [[nodiscard]] Place placeOf(const Receiver& at) const;
    [[nodiscard]] float sunLux(const Receiver& at, const SkyView* view, std::size_t sun) const;
    [[nodiscard]] float sunChance(const Receiver& at, const Place& place, std::size_t sun) const;
    [[nodiscard]] float texelPdf(const Place& place, std::uint32_t texel) const;
    [[nodiscard]] SkySample sampleSun(const Receiver& at, const Place& place, float uSelect, Vec2 u) const;

    const Scene* scene_;
    float lampLux_ = 0;                           // what lamps and emitting surfaces give, very roughly [lx]
    std::vector<float> luminances_;               // of the texels [cd/m^2]
    std::array<SkyTable, kFacings> plain_;
    std::array<float, kFacings> plainLux_{};
    std::vector<float> suns_;                     // their normal illuminances [lx]
    std::unique_ptr<SkyCells> cells_;
};

}  // namespace luxdeck

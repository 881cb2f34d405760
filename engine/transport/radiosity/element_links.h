#pragma once

#include "engine/core/result.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/transport/radiosity/link_matrix.h"
#include "engine/transport/surface/surface_elements.h"
#include "engine/transport/tracer/irradiance_field.h"

#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// A place on an element from which light is gathered.
struct ElementPlace {
    Vec3 position{0, 0, 0}, normal{0, 0, 1};
};

/// What the samples of one element found, as sums until divided.
struct ElementLight {
    Rgb straight;                    // without a reflection [lx]
    Rgb reflected;                   // reflected once, or by what is not matte [lx]
    Rgb lost;                        // the most that `reflected` may lack [lx]
    std::vector<ElementLink> links;  // for all that was reflected more often
    std::vector<ElementLink> lostLinks;  // likewise of what may be lacking
    std::uint32_t linked = 0;        // samples that met a matte surface
    std::uint32_t samples = 0;
    std::uint32_t rejected = 0;      // of which a part is missing

    [[nodiscard]] Rgb mean(const Rgb& sum) const { return sum / static_cast<float>(samples); }
};

/// What a first look tells of an element.
struct ElementLook {
    Rgb straight;                       // mean over its whole area, without a reflection [lx]
    float open = 0;                     // the part of its area that light reaches, roughly
    std::vector<ElementPlace> places;   // where paths from lit places met it
};

/// Gathers the light of elements by paths that end at the first matte surface they meet: the direct light there is
/// sampled by next-event estimation, all other becomes a link to its element. Mirrors, panes, solids and gloss on
/// the way are followed as by path tracing.
class LinkGatherer {
public:
    LinkGatherer(const TransportScene& scene, const SurfaceElements& elements, const AlgorithmSettings& settings)
        : scene_(scene), elements_(elements), settings_(settings) {}

    /// A look from a few places all over each element. Elements are never the size of what hides a part of them, and
    /// what is hidden nobody sees: from here on light is gathered where paths met them, as often as they did, and where
    /// none did there is no light to ask for.
    ///
    /// errors  Cancelled
    Result<std::vector<ElementLook>> look();

    /// Light from the places that were found, `samples` each; of the elements that have light, or exchange it with such.
    ///
    /// errors  Cancelled
    Result<std::vector<ElementLight>> gather(std::span<const ElementLook> looks, std::uint32_t samples);

private:
    struct Batch;
    template <class Work>
    Result<void> inBatches(std::size_t count, const char* stage, const Work& work) const;
    Batch trace(std::vector<SensorQuery> queries) const;
    void lookAt(std::uint32_t element, ElementLook& look, std::vector<FieldPoint>& met) const;
    void gatherAt(std::uint32_t element, const ElementLook& look, std::uint32_t samples, ElementLight& light) const;

    const TransportScene& scene_;
    const SurfaceElements& elements_;
    const AlgorithmSettings& settings_;
};

/// Makes elements dark that have, with all that they exchange light with, less light for their area than this part of
/// the brightest: where surfaces meet, one path in a million starts beyond the edge and finds light that does not
/// belong there.
inline constexpr double kDark = 1e-6;
void dropStrayLight(const SurfaceElements& elements, std::span<ElementLight> lights);

}  // namespace luxdeck

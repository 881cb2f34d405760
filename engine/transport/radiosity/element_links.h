#pragma once

#include "engine/core/result.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/transport/radiosity/link_matrix.h"
#include "engine/transport/radiosity/surface_elements.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace luxdeck {

/// What the samples of one element found, as sums until divided.
struct ElementLight {
    Rgb straight;                    // without a reflection [lx]
    Rgb reflected;                   // reflected once, or by what is not matte [lx]
    std::vector<ElementLink> links;  // for all that was reflected more often
    std::uint32_t linked = 0;        // samples that met a matte surface
    std::uint32_t samples = 0;       // good ones
    std::uint32_t rejected = 0;

    [[nodiscard]] Rgb mean(const Rgb& sum) const { return sum / static_cast<float>(samples); }
};

/// Gathers the light of elements by paths that end at the first matte surface they meet: the direct light there is
/// sampled by next-event estimation, all other becomes a link to its element. Mirrors, panes, solids and gloss on
/// the way are followed as by path tracing.
class LinkGatherer {
public:
    LinkGatherer(const TransportScene& scene, const SurfaceElements& elements, const AlgorithmSettings& settings)
        : scene_(scene), elements_(elements), settings_(settings), lights_(elements.size()) {}

    /// Samples first .. first + count - 1 of the elements asked for.
    ///
    /// errors  Cancelled
    Result<void> gather(std::span<const std::uint32_t> asked, std::uint32_t first, std::uint32_t count);

    /// Elements that have light, or exchange it with such: the inside of a closed desk and the back of a wall are not.
    [[nodiscard]] std::vector<std::uint32_t> lit() const;
    void forgetAllBut(std::span<const std::uint32_t> kept);
    [[nodiscard]] std::vector<ElementLight>& lights() { return lights_; }

private:
    void gatherElements(std::span<const std::uint32_t> asked, std::uint32_t first, std::uint32_t count);

    const TransportScene& scene_;
    const SurfaceElements& elements_;
    const AlgorithmSettings& settings_;
    std::vector<ElementLight> lights_;
};

}  // namespace luxdeck

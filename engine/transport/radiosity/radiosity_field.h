#pragma once

#include "engine/core/result.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/transport/radiosity/element_links.h"
#include "engine/transport/surface/surface_elements.h"
#include "engine/transport/tracer/irradiance_field.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace luxdeck {

/// Where the light on matte surfaces came from and went, summed over all elements in luminance [lm].
struct RadiosityBalance {
    double straight = 0;   // from lamps, sky and emitting surfaces, panes in between allowed
    double absorbed = 0;   // by matte surfaces
    double lost = 0;       // reflected by them to where none is met: out of openings, into what is not matte
    double remaining = 0;  // bound on what the iteration left out

    /// What else they took: of mirrors, panes and gloss, and the noise of the links. Only noise where all is matte.
    [[nodiscard]] double byOthers() const { return absorbed + lost - straight; }
};

/// Light on the matte surfaces by radiosity: constant on each element, exchanged between them over links that were traced.
class RadiosityField final : public IrradianceField {
public:
    /// settings  effort: elements and links of each grow with its square root; seed, progress, maxVertices
    /// errors    Cancelled; OutOfResources: more links than memory should hold; Internal: the iteration does not end
    static Result<std::unique_ptr<RadiosityField>> create(const TransportScene& scene, const AlgorithmSettings& settings);

    void indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;

    [[nodiscard]] const SurfaceElements& elements() const { return elements_; }
    [[nodiscard]] const RadiosityBalance& balance() const { return balance_; }
    [[nodiscard]] bool hasGaps() const override { return !gaps_.empty(); }
    void gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;
    /// Samples of which a part is missing, of those that it was made from.
    [[nodiscard]] std::uint64_t rejected() const { return rejected_; }
    [[nodiscard]] std::size_t bytes() const { return elements_.bytes() + (lux_.size() + gaps_.size()) * sizeof(Rgb); }

private:
    explicit RadiosityField(SurfaceElements elements) : elements_(std::move(elements)) {}

    Result<void> solve(std::vector<ElementLight>& lights);
    Result<double> solveFor(const std::vector<Rgb>& constant, std::span<const std::vector<ElementLink>> rows, std::vector<Rgb>& lux) const;
    void look(std::span<const FieldPoint> points, std::span<const Rgb> of, std::span<Rgb> lux) const;

    SurfaceElements elements_;
    std::vector<Rgb> lux_;   // by element
    std::vector<Rgb> gaps_;  // by element: the most that lux_ may lack; empty: nothing
    RadiosityBalance balance_;
    std::uint64_t rejected_ = 0;
};

}  // namespace luxdeck

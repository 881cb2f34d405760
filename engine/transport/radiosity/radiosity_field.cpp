#include "engine/transport/radiosity/radiosity_field.h"

#include "engine/transport/radiosity/element_links.h"
#include "engine/transport/surface/bsdf.h"
#include "engine/transport/surface/straight.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace luxdeck {

namespace {

constexpr double kPieces = 4096;         // at effort 1
constexpr double kLinksEach = 96;        // of an element at effort 1
constexpr std::uint32_t kFirstLook = 16; // samples that tell whether an element has light at all
constexpr double kMostLinks = 1e8;       // 1.6 GB
constexpr int kPlaces = 4;               // of an element at which its reflectance is asked

/// Mean of what an element reflects.
Rgb reflectance(const TransportScene& scene, const SurfaceElements& elements, std::uint32_t element) {
    Rgb sum;
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
        SamplePath numbers(element, i);
        auto at = elements.place(element, numbers.next2D());
        at.material = meetMaterial(scene.scene, at, numbers.next1D());
        if (at.material == nullptr) continue;
        const Rgb albedo = Bsdf<Rgb>(scene.scene, scene.needs, at).albedo(1);
        if (isFinite(albedo)) sum += albedo;
    }
    return sum / kPlaces;
}

/// Divides sums by the samples; what has none is taken as dark here.
std::vector<Rgb> takeMeans(std::vector<ElementLight>& lights) {
    std::vector<Rgb> constant(lights.size());
    for (std::size_t e = 0; e < lights.size(); ++e) {
        auto& light = lights[e];
        if (light.samples == 0) continue;
        constant[e] = light.mean(light.reflected);
        for (auto& link : light.links) link.weight = light.mean(link.weight);
    }
    return constant;
}

std::vector<std::vector<ElementLink>> takeLinks(std::vector<ElementLight>& lights) {
    std::vector<std::vector<ElementLink>> rows(lights.size());
    for (std::size_t e = 0; e < lights.size(); ++e) rows[e] = std::exchange(lights[e].links, {});
    return rows;
}

RadiosityBalance balanceOf(const TransportScene& scene, const SurfaceElements& elements, std::span<const ElementLight> lights,
                           std::span<const Rgb> lux) {
    RadiosityBalance balance;
    for (std::uint32_t e = 0; e < lights.size(); ++e) {
        const auto& light = lights[e];
        if (light.samples == 0) continue;
        const Rgb straight = light.mean(light.straight), arrived = straight + lux[e];
        const Rgb reflected = arrived * reflectance(scene, elements, e);
        const double area = elements.areaM2(e), met = static_cast<double>(light.linked) / light.samples;
        const auto lumens = [&](const Rgb& c) { return area * double{luminance(c, scene.scene.weights)}; };
        balance.straight += lumens(straight);
        balance.absorbed += lumens(arrived - reflected);
        balance.lost += lumens(reflected) * (1 - met);
    }
    return balance;
}

}  // namespace

Result<std::unique_ptr<RadiosityField>> RadiosityField::create(const TransportScene& scene, const AlgorithmSettings& settings) {
    const double finer = std::sqrt(settings.effort);
    const double pieces = std::ceil(kPieces * finer), linksEach = std::ceil(kLinksEach * finer);
    if (2 * pieces * linksEach > kMostLinks)
        return Error{ErrorCode::OutOfResources, fmt::format("an effort of {} takes {:.3g} links between surfaces, expected at most {:.3g}: {} GB",
                                                            settings.effort, 2 * pieces * linksEach, kMostLinks, 16e-9 * kMostLinks)};
    std::unique_ptr<RadiosityField> field(new RadiosityField(SurfaceElements(scene.scene, scene.needs, static_cast<std::size_t>(pieces))));
    const auto& elements = field->elements_;
    LinkGatherer gatherer(scene, elements, settings);
    std::vector<std::uint32_t> all(elements.size());
    std::iota(all.begin(), all.end(), 0U);
    if (auto ok = gatherer.gather(all, 0, kFirstLook); !ok) return ok.error();
    const auto lit = gatherer.lit();
    gatherer.forgetAllBut(lit);
    const auto each = static_cast<std::uint32_t>(linksEach);
    if (each > kFirstLook)
        if (auto ok = gatherer.gather(lit, kFirstLook, each - kFirstLook); !ok) return ok.error();

    auto& lights = gatherer.lights();
    const auto constant = takeMeans(lights);
    std::vector<float> areas(elements.size());
    for (std::size_t e = 0; e < areas.size(); ++e) areas[e] = elements.areaM2(e);
    field->lux_.resize(elements.size());
    const double left = LinkMatrix(takeLinks(lights)).solve(constant, areas, field->lux_);
    if (!(left <= LinkMatrix::kEnough))
        return Error{ErrorCode::Internal, fmt::format("radiosity does not converge: {:.2g} of the light is left, expected {:.2g}", left, LinkMatrix::kEnough)};
    field->balance_ = balanceOf(scene, elements, lights, field->lux_);
    for (std::size_t e = 0; e < lights.size(); ++e) {
        field->rejected_ += lights[e].rejected;
        field->balance_.remaining += left * areas[e] * double{luminance(field->lux_[e], scene.scene.weights)};
        if (lights[e].samples == 0 && lights[e].rejected > 0) field->lux_[e] = Rgb(std::numeric_limits<float>::quiet_NaN());
    }
    return field;
}

void RadiosityField::indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& p = points[i];
        const auto element = elements_.at(p.mesh, p.triangle, p.u, p.v, p.frontFace);
        lux[i] = element == SurfaceElements::kNone ? Rgb{} : lux_[element];
    }
}

}  // namespace luxdeck

#include "engine/transport/radiosity/radiosity_field.h"

#include "engine/transport/radiosity/element_links.h"
#include "engine/transport/surface/bsdf.h"
#include "engine/transport/surface/straight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace luxdeck {

namespace {

constexpr double kPieces = 4096;         // at effort 1
constexpr double kLinksEach = 96;        // of an element at effort 1
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

RadiosityBalance balanceOf(const TransportScene& scene, const SurfaceElements& elements, std::span<const ElementLook> looks,
                           std::span<const ElementLight> lights, std::span<const Rgb> lux) {
    RadiosityBalance balance;
    for (std::uint32_t e = 0; e < lights.size(); ++e) {
        const auto& light = lights[e];
        if (light.samples == 0) continue;
        const Rgb arrived = looks[e].straight + lux[e] * looks[e].open, reflected = arrived * reflectance(scene, elements, e);
        const double area = elements.areaM2(e), met = static_cast<double>(light.linked) / light.samples;
        const auto lumens = [&](const Rgb& c) { return area * double{luminance(c, scene.scene.weights)}; };
        balance.straight += lumens(looks[e].straight);
        balance.absorbed += lumens(arrived - reflected);
        balance.lost += lumens(reflected) * (1 - met);
    }
    return balance;
}

/// What an effort asks for.
struct Plan {
    std::size_t pieces;
    std::uint32_t samples;  // of each element
};
Result<Plan> planFor(double effort) {
    if (!(effort >= 1e-3 && effort <= 1e3)) return Error{ErrorCode::InvalidArgument, fmt::format("effort is {}, expected 0.001 .. 1000", effort)};
    const double finer = std::sqrt(effort), pieces = std::ceil(kPieces * finer), samples = std::ceil(kLinksEach * finer);
    if (2 * pieces * samples > kMostLinks)
        return Error{ErrorCode::OutOfResources, fmt::format("an effort of {} takes {:.3g} links between surfaces, expected at most {:.3g}: {} GB",
                                                            effort, 2 * pieces * samples, kMostLinks, 16e-9 * kMostLinks)};
    return Plan{static_cast<std::size_t>(pieces), static_cast<std::uint32_t>(samples)};
}

}  // namespace

Result<std::unique_ptr<RadiosityField>> RadiosityField::create(const TransportScene& scene, const AlgorithmSettings& settings) {
    const auto plan = planFor(settings.effort);
    if (!plan) return plan.error();
    std::unique_ptr<RadiosityField> field(new RadiosityField(SurfaceElements(scene.scene, scene.needs, plan->pieces)));
    LinkGatherer gatherer(scene, field->elements_, settings);
    const auto looks = gatherer.look();
    if (!looks) return looks.error();
    auto lights = gatherer.gather(*looks, plan->samples);
    if (!lights) return lights.error();
    dropStrayLight(field->elements_, *lights);
    if (auto ok = field->solve(*lights); !ok) return ok.error();
    const double remaining = field->balance_.remaining;
    field->balance_ = balanceOf(scene, field->elements_, *looks, *lights, field->lux_);
    field->balance_.remaining = remaining;
    for (const auto& light : *lights) field->rejected_ += light.rejected;
    return field;
}

Result<double> RadiosityField::solveFor(const std::vector<Rgb>& constant, std::span<const std::vector<ElementLink>> rows,
                                        std::vector<Rgb>& lux) const {
    std::vector<float> areas(elements_.size());
    for (std::size_t e = 0; e < areas.size(); ++e) areas[e] = elements_.areaM2(e);
    lux.resize(elements_.size());
    const double left = LinkMatrix(rows).solve(constant, areas, lux);
    if (left <= LinkMatrix::kEnough) return left;
    return Error{ErrorCode::Internal, fmt::format("radiosity does not converge: {:.2g} of the light is left, expected {:.2g}", left, LinkMatrix::kEnough)};
}

/// Twice where something had no value: with what was found, and with the most that may be. The equations are linear in no
/// one element's gap, since gaps see each other: so both are solved and their difference taken.
Result<void> RadiosityField::solve(std::vector<ElementLight>& lights) {
    const auto constant = takeMeans(lights);
    auto rows = takeLinks(lights);
    const auto left = solveFor(constant, rows, lux_);
    if (!left) return left.error();
    for (std::size_t e = 0; e < lux_.size(); ++e) balance_.remaining += *left * double{elements_.areaM2(e)} * double{lux_[e].max()};
    if (std::ranges::none_of(lights, [](const auto& light) { return light.rejected > 0; })) return {};
    std::vector<Rgb> most = constant;
    for (std::size_t e = 0; e < lights.size(); ++e) {
        const auto& light = lights[e];
        if (light.samples == 0) continue;
        if (!isFinite(light.lost)) {  // of a lamp: anything, and everywhere by way of reflections
            gaps_.assign(lux_.size(), Rgb(std::numeric_limits<float>::infinity()));
            return {};
        }
        most[e] += light.mean(light.lost);
        for (const auto& link : light.lostLinks) rows[e].push_back({link.to, light.mean(link.weight)});
    }
    if (const auto solved = solveFor(most, rows, gaps_); !solved) return solved.error();
    for (std::size_t e = 0; e < lux_.size(); ++e) {
        const Rgb more = gaps_[e] - lux_[e];
        gaps_[e] = {std::max(more.r, 0.0F), std::max(more.g, 0.0F), std::max(more.b, 0.0F)};
    }
    return {};
}

void RadiosityField::indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const { look(points, lux_, lux); }

void RadiosityField::gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const { look(points, gaps_, lux); }

void RadiosityField::look(std::span<const FieldPoint> points, std::span<const Rgb> of, std::span<Rgb> lux) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& p = points[i];
        const auto element = elements_.at(p.mesh, p.triangle, p.u, p.v, p.frontFace);
        lux[i] = element == SurfaceElements::kNone || of.empty() ? Rgb{} : of[element];
    }
}

}  // namespace luxdeck

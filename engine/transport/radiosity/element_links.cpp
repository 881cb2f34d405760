#include "engine/transport/radiosity/element_links.h"

#include "engine/core/parallel.h"
#include "engine/transport/radiosity/element_groups.h"
#include "engine/transport/sensor/illuminance.h"
#include "engine/transport/tracer/path_batch.h"

#include <algorithm>

namespace luxdeck {

namespace {

constexpr std::size_t kBetweenReports = 512;  // elements
/// Samples from one place: lights are weighed once for all of them.
constexpr std::uint32_t kFromOnePlace = 8;
constexpr std::uint32_t kLookPlaces = 3;
constexpr std::uint32_t kLookSamples = kLookPlaces * kFromOnePlace;

/// All indirect light is left to the links.
class DarkField final : public IrradianceField {
public:
    void indirect(std::span<const FieldPoint>, std::span<Rgb> lux) const override { std::fill(lux.begin(), lux.end(), Rgb{}); }
};

}  // namespace

/// Sensors of one element, what they found and where their paths ended.
struct LinkGatherer::Batch {
    std::vector<SensorSample> samples;
    std::vector<FieldLink> links;  // in the samples' order
};

LinkGatherer::Batch LinkGatherer::trace(std::vector<SensorQuery> queries) const {
    Batch batch;
    batch.samples.resize(queries.size());
    const DarkField dark;
    TracerSettings tracer;
    tracer.maxVertices = settings_.maxVertices, tracer.field = &dark, tracer.links = &batch.links;
    gatherIlluminance(scene_, tracer, queries, batch.samples);
    std::stable_sort(batch.links.begin(), batch.links.end(), [](const FieldLink& a, const FieldLink& b) { return a.query < b.query; });
    return batch;
}

template <class Work>
Result<void> LinkGatherer::inBatches(std::size_t count, const char* stage, const Work& work) const {
    const auto* progress = settings_.progress;
    for (std::size_t done = 0; done < count; done += kBetweenReports) {
        parallelFor(std::min(kBetweenReports, count - done), [&](std::size_t i) {
            if (progress == nullptr || !progress->cancelled()) work(static_cast<std::uint32_t>(done + i));
        });
        if (progress == nullptr) continue;
        if (progress->cancelled()) return Error{ErrorCode::Cancelled, "cancelled while radiosity was prepared"};
        ProgressState state;
        state.stage = stage, state.fraction = static_cast<double>(done) / static_cast<double>(count);
        progress->report(state);
    }
    return {};
}

Result<std::vector<ElementLook>> LinkGatherer::look() {
    std::vector<ElementLook> looks(elements_.size());
    std::vector<std::vector<FieldPoint>> met(elements_.size());
    const auto ok = inBatches(elements_.size(), "looking for light", [&](std::uint32_t e) { lookAt(e, looks[e], met[e]); });
    if (!ok) return ok.error();
    for (const auto& points : met)
        for (const auto& p : points) {
            const auto element = elements_.at(p.mesh, p.triangle, p.u, p.v, p.frontFace);
            if (element != SurfaceElements::kNone) looks[element].places.push_back({p.position, p.normal});
        }
    return looks;
}

void LinkGatherer::lookAt(std::uint32_t element, ElementLook& look, std::vector<FieldPoint>& met) const {
    std::vector<SensorQuery> queries;
    for (std::uint32_t i = 0; i < kLookSamples; ++i) {
        SamplePath places(streamSeed(settings_.seed, element, 1), i / kFromOnePlace);
        const auto at = elements_.place(element, places.next2D());
        queries.push_back({at.position, at.shadingNormal, SensorKind::Planar, SamplePath(streamSeed(settings_.seed, element, 2), i)});
    }
    const auto batch = trace(std::move(queries));
    std::array<bool, kLookPlaces> lit{};
    for (std::uint32_t i = 0; i < kLookSamples; ++i) {
        const auto& sample = batch.samples[i];
        look.straight += sample.direct * (1.0F / kLookSamples);
        if (!(sample.total() + sample.lost).isBlack()) lit[i / kFromOnePlace] = true;
    }
    look.open = static_cast<float>(std::count(lit.begin(), lit.end(), true)) / kLookPlaces;
    for (const auto& link : batch.links)
        if (lit[link.query / kFromOnePlace]) met.push_back(link.point);
}

Result<std::vector<ElementLight>> LinkGatherer::gather(std::span<const ElementLook> looks, std::uint32_t samples) {
    std::vector<ElementLight> lights(elements_.size());
    const auto ok = inBatches(elements_.size(), "linking surfaces", [&](std::uint32_t e) {
        if (looks[e].open > 0 || !looks[e].places.empty()) gatherAt(e, looks[e], samples, lights[e]);
    });
    if (!ok) return ok.error();
    return lights;
}

void LinkGatherer::gatherAt(std::uint32_t element, const ElementLook& look, std::uint32_t count, ElementLight& light) const {
    std::vector<SensorQuery> queries;
    const std::uint32_t wanted = (count + kFromOnePlace - 1) / kFromOnePlace;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t which = i / kFromOnePlace;
        ElementPlace place;
        if (!look.places.empty()) {  // evenly over what there is, again from the first when more are wanted
            const std::size_t n = look.places.size();
            place = look.places[n > wanted ? which * n / wanted : which % n];
        } else {
            const auto at = elements_.place(element, SamplePath(streamSeed(settings_.seed, element, 1), which).next2D());
            place = {at.position, at.shadingNormal};
        }
        queries.push_back({place.position, place.normal, SensorKind::Planar, SamplePath(streamSeed(settings_.seed, element, 3), i)});
    }
    const auto batch = trace(std::move(queries));
    for (const auto& sample : batch.samples) {
        light.rejected += sample.failure != RayFailure::None ? 1 : 0;
        ++light.samples, light.straight += sample.direct, light.reflected += sample.indirect, light.lost += sample.lost;
    }
    for (const auto& link : batch.links) {
        const auto& p = link.point;
        const auto to = elements_.at(p.mesh, p.triangle, p.u, p.v, p.frontFace);
        if (to == SurfaceElements::kNone) continue;
        if (!link.lost) ++light.linked;
        (link.lost ? light.lostLinks : light.links).push_back({to, link.weight * kPi});
    }
}

void dropStrayLight(const SurfaceElements& elements, std::span<ElementLight> lights) {
    ElementGroups groups(lights.size());
    for (std::uint32_t e = 0; e < lights.size(); ++e)
        for (const auto* links : {&lights[e].links, &lights[e].lostLinks})
            for (const auto& link : *links) groups.join(e, link.to);
    std::vector<double> light(lights.size()), area(lights.size());
    for (std::uint32_t e = 0; e < lights.size(); ++e) {
        const double m2 = elements.areaM2(e);
        area[groups.of(e)] += m2;
        const auto& own = lights[e];
        const Rgb found = own.straight + own.reflected + (isFinite(own.lost) ? own.lost : Rgb{});
        if (own.samples > 0) light[groups.of(e)] += m2 * double{own.mean(found).max()};
    }
    double most = 0;
    for (std::uint32_t e = 0; e < lights.size(); ++e)
        if (light[e] > 0) most = std::max(most, light[e] / area[e]);
    for (std::uint32_t e = 0; e < lights.size(); ++e) {
        const auto group = groups.of(e);
        if (light[group] > kDark * most * area[group]) continue;
        lights[e].straight = lights[e].reflected = Rgb{};
        if (isFinite(lights[e].lost)) lights[e].lost = Rgb{};  // else nothing is known: that is no stray light
    }
}

}  // namespace luxdeck

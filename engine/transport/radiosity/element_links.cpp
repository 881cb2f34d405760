#include "engine/transport/radiosity/element_links.h"

#include "engine/core/parallel.h"
#include "engine/transport/radiosity/element_groups.h"
#include "engine/transport/sensor/illuminance.h"
#include "engine/transport/tracer/path_batch.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr std::size_t kTask = 16;            // elements gathered in one batch
constexpr std::size_t kBetweenReports = 64;  // tasks
/// Samples from one point of an element: lights are weighed once for all of them.
constexpr std::uint32_t kFromOnePoint = 8;
/// A group with less light for its area than this part of the brightest's is dark: where surfaces meet, one path in
/// a million starts beyond the edge and finds light that does not belong there.
constexpr double kDark = 1e-7;

/// All indirect light is left to the links.
class DarkField final : public IrradianceField {
public:
    void indirect(std::span<const FieldPoint>, std::span<Rgb> lux) const override { std::fill(lux.begin(), lux.end(), Rgb{}); }
};

SensorQuery sensorOn(const SurfaceElements& elements, std::uint32_t element, std::uint64_t seed, std::uint32_t sample) {
    SamplePath places(streamSeed(seed, element, 1), sample / kFromOnePoint);
    const auto at = elements.place(element, places.next2D());
    return {at.position, at.shadingNormal, SensorKind::Planar, SamplePath(streamSeed(seed, element, 2), sample)};
}

}  // namespace

Result<void> LinkGatherer::gather(std::span<const std::uint32_t> asked, std::uint32_t first, std::uint32_t count) {
    const auto* progress = settings_.progress;
    const std::size_t tasks = (asked.size() + kTask - 1) / kTask;
    for (std::size_t done = 0; done < tasks; done += kBetweenReports) {
        parallelFor(std::min(kBetweenReports, tasks - done), [&](std::size_t i) {
            if (progress != nullptr && progress->cancelled()) return;
            const std::size_t begin = (done + i) * kTask;
            gatherElements(asked.subspan(begin, std::min(kTask, asked.size() - begin)), first, count);
        });
        if (progress == nullptr) continue;
        if (progress->cancelled()) return Error{ErrorCode::Cancelled, "cancelled while radiosity was prepared"};
        ProgressState state;
        state.stage = "linking surfaces", state.fraction = static_cast<double>(done) / static_cast<double>(tasks);
        progress->report(state);
    }
    return {};
}

void LinkGatherer::gatherElements(std::span<const std::uint32_t> asked, std::uint32_t first, std::uint32_t count) {
    std::vector<SensorQuery> queries;
    queries.reserve(asked.size() * count);
    for (const auto element : asked)
        for (std::uint32_t i = 0; i < count; ++i) queries.push_back(sensorOn(elements_, element, settings_.seed, first + i));
    std::vector<SensorSample> samples(queries.size());
    std::vector<FieldLink> links;
    const DarkField dark;
    TracerSettings tracer;
    tracer.maxVertices = settings_.maxVertices, tracer.field = &dark, tracer.links = &links;
    gatherIlluminance(scene_, tracer, queries, samples);

    for (std::size_t i = 0; i < samples.size(); ++i) {
        auto& light = lights_[asked[i / count]];
        if (samples[i].failure != RayFailure::None) ++light.rejected;
        else ++light.samples, light.straight += samples[i].direct, light.reflected += samples[i].indirect;
    }
    // By query, since the tracer drops what ended: links of one element are then in the order of its samples.
    std::stable_sort(links.begin(), links.end(), [](const FieldLink& a, const FieldLink& b) { return a.query < b.query; });
    for (const auto& link : links) {
        if (samples[link.query].failure != RayFailure::None) continue;
        const auto& p = link.point;
        auto& light = lights_[asked[link.query / count]];
        const auto to = elements_.at(p.mesh, p.triangle, p.u, p.v, p.frontFace);
        if (to == SurfaceElements::kNone) continue;
        ++light.linked;
        light.links.push_back({to, link.weight * kPi});
    }
}

std::vector<std::uint32_t> LinkGatherer::lit() const {
    ElementGroups groups(lights_.size());
    for (std::uint32_t e = 0; e < lights_.size(); ++e)
        for (const auto& link : lights_[e].links) groups.join(e, link.to);
    std::vector<double> light(lights_.size()), area(lights_.size());
    for (std::uint32_t e = 0; e < lights_.size(); ++e) {
        const auto& own = lights_[e];
        const double m2 = elements_.areaM2(e);
        area[groups.of(e)] += m2;
        if (own.samples > 0) light[groups.of(e)] += m2 * double{own.mean(own.straight + own.reflected).max()};
    }
    double most = 0;
    for (std::uint32_t e = 0; e < lights_.size(); ++e)
        if (light[e] > 0) most = std::max(most, light[e] / area[e]);
    std::vector<std::uint32_t> out;
    for (std::uint32_t e = 0; e < lights_.size(); ++e)
        if (light[groups.of(e)] > kDark * most * area[groups.of(e)] || lights_[e].rejected > 0) out.push_back(e);
    return out;
}

void LinkGatherer::forgetAllBut(std::span<const std::uint32_t> kept) {
    std::vector<ElementLight> lights(lights_.size());
    for (const auto e : kept) lights[e] = std::move(lights_[e]);
    lights_ = std::move(lights);
}

}  // namespace luxdeck

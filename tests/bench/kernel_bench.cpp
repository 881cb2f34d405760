// The engine's ray rates, and those of `path`, against the bare kernel's on the same rays.

#include "analysis/pictures/camera.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/sampling/warp.h"
#include "engine/transport/lit_scene.h"
#include "tests/bench/bare_kernel.h"
#include "tests/bench/measuring.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::bench {

namespace {

constexpr int kPairs = 7;

/// The office with both sides' structures built.
struct Sides {
    LitScene lit = LitScene::create(office().scene).value();
    BareKernel surfaces{office().scene, BareKernel::Holds::Surfaces};
    BareKernel opaque{office().scene, BareKernel::Holds::OpaqueSurfaces};
};
const Sides& sides() {
    static const Sides s;
    return s;
}

std::vector<Ray> cameraRays() {
    View view = office().views.front();
    view.width = 600, view.height = 400;
    const Camera camera(view, office().scene);
    std::vector<Ray> rays;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            if (const auto ray = camera.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F)) rays.push_back(*ray);
    return rays;
}

struct Departure {
    Vec3 position, normal;
};
/// Where rays meet surfaces, just off them.
std::vector<Departure> departures(const std::vector<Ray>& rays) {
    const auto& scene = office().scene;
    std::vector<Hit> hits(rays.size());
    sides().lit.raycaster().closestHits(rays, hits, Targets::Surfaces);
    std::vector<Departure> out;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].surface()) continue;
        const auto& mesh = scene.meshes[hits[i].mesh];
        const auto& [a, b, c] = mesh.triangles[hits[i].triangle];
        Vec3 n = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).normalized();
        if (dot(n, rays[i].direction) > 0) n = -n;
        out.push_back({rays[i].origin + rays[i].direction * hits[i].distance + n * 1e-4F, n});
    }
    return out;
}

std::vector<Ray> diffuseRays(const std::vector<Departure>& from) {
    RandomStream random(7);
    std::vector<Ray> rays;
    for (const auto& d : from) {
        const Vec2 u{static_cast<float>(random.uniform()), static_cast<float>(random.uniform())};
        rays.push_back({d.position, 0, Frame::about(d.normal).toWorld(cosineHemisphere(u)), kInfinity});
    }
    return rays;
}

/// To one luminaire, or to a random one from each.
std::vector<Ray> shadowRays(const std::vector<Departure>& from, bool toOne) {
    const auto& luminaires = office().scene.luminaires;
    RandomStream random(11);
    std::vector<Ray> rays;
    for (const auto& d : from) {
        const Vec3 towards = luminaires[toOne ? 0 : random.below(luminaires.size())].position - d.position;
        const float distance = towards.length();
        rays.push_back({d.position, 0, towards / distance, distance * 0.999F});
    }
    return rays;
}

std::size_t ourClosest(const std::vector<Ray>& rays, std::vector<Hit>& hits) {
    sides().lit.raycaster().closestHits(rays, hits, Targets::Surfaces);
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [](const Hit& h) { return h.surface(); }));
}

std::size_t ourOccluded(const std::vector<Ray>& rays, std::vector<std::uint8_t>& out) {
    sides().lit.raycaster().occluded(rays, out, Targets::Opaque);
    return static_cast<std::size_t>(std::count(out.begin(), out.end(), std::uint8_t{1}));
}

enum class Question { Closest, Occluded };

void compareWithKernel(benchmark::State& state, const std::string& name, const std::vector<Ray>& rays, Question question) {
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> shadowed(rays.size());
    std::size_t ours = 0, bare = 0;
    Contest times;
    for (auto _ : state)
        times = question == Question::Closest
                    ? contest(threadSeconds, kPairs, [&] { ours = ourClosest(rays, hits); }, [&] { bare = sides().surfaces.closestHits(rays); })
                    : contest(threadSeconds, kPairs, [&] { ours = ourOccluded(rays, shadowed); }, [&] { bare = sides().opaque.occluded(rays); });
    // Both see the same triangles; where two lie at the same place, or a ray starts on one, the order of the
    // kernel's tree may decide: one ray in 10,000 is far above what was seen (none).
    if (std::max(ours, bare) - std::min(ours, bare) > rays.size() / 10000) {
        state.SkipWithError("the answers differ from the bare kernel's");
        return;
    }
    state.counters["ratio"] = times.ratio();
    state.counters["Mray/s"] = static_cast<double>(rays.size()) / median(times.first) * 1e-6;
    state.counters["kernel Mray/s"] = static_cast<double>(rays.size()) / median(times.second) * 1e-6;
    record(name, times.ratio(), "", 0.9);
}

void closestCoherent(benchmark::State& state) {
    compareWithKernel(state, "closest hit, camera rays / kernel", cameraRays(), Question::Closest);
}
void closestIncoherent(benchmark::State& state) {
    compareWithKernel(state, "closest hit, diffuse bounces / kernel", diffuseRays(departures(cameraRays())), Question::Closest);
}
void occludedCoherent(benchmark::State& state) {
    compareWithKernel(state, "occlusion, to one luminaire / kernel", shadowRays(departures(cameraRays()), true), Question::Occluded);
}
void occludedIncoherent(benchmark::State& state) {
    compareWithKernel(state, "occlusion, from bounces to all luminaires / kernel",
                      shadowRays(departures(diffuseRays(departures(cameraRays()))), false), Question::Occluded);
}
BENCHMARK(closestCoherent)->Name("kernel/office/closest/camera")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(closestIncoherent)->Name("kernel/office/closest/bounces")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(occludedCoherent)->Name("kernel/office/occluded/one_luminaire")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(occludedIncoherent)->Name("kernel/office/occluded/bounces")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Notes every ray that an estimator asks about. Questions about panes alone are not noted: they belong
/// to the shadow ray before them, and their cost stays on the estimator's side.
class RecordingRaycaster final : public Raycaster {
public:
    explicit RecordingRaycaster(const Raycaster& inner) : inner_(inner) {}

    void closestHits(std::span<const Ray> rays, std::span<Hit> hits, Targets targets) const override {
        inner_.closestHits(rays, hits, targets);
        if (targets != Targets::Panes) closest.insert(closest.end(), rays.begin(), rays.end());
    }
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> out, Targets targets) const override {
        inner_.occluded(rays, out, targets);
        shadow.insert(shadow.end(), rays.begin(), rays.end());
    }
    [[nodiscard]] std::string kernel() const override { return inner_.kernel(); }
    [[nodiscard]] std::size_t bytes() const override { return inner_.bytes(); }

    mutable std::vector<Ray> closest, shadow;

private:
    const Raycaster& inner_;
};

/// All that `path` does to solve the office's grids on one thread, against the bare kernel on the very same rays.
void pathAgainstKernel(benchmark::State& state) {
    constexpr std::uint32_t kSamples = 16;  // of each replicate: 512 paths for each point, the batches of a solve
    constexpr std::size_t kEvery = 12;      // points of the grids
    const auto& lit = sides().lit;
    const auto all = gridTargets(office());
    std::vector<Target> targets;
    for (std::size_t i = 0; i < all.size(); i += kEvery) targets.push_back(all[i]);
    const auto solveWith = [&](const TransportScene& scene) {
        const auto estimator = makeEstimator("path", scene).value();
        TransportCounters counters;
        for (const auto& target : targets)
            benchmark::DoNotOptimize(measure(*estimator, office().scene.weights, target, 1, 0, kSamples, counters));
        return counters;
    };
    const RecordingRaycaster recorder(lit.raycaster());
    const auto t = lit.transport();
    const auto counters = solveWith({t.scene, t.needs, recorder, t.lights, t.mirrors, t.sky});
    if (counters.paths == 0 || counters.rejected > 0) {
        state.SkipWithError("paths were rejected");
        return;
    }
    Contest times;
    for (auto _ : state)
        times = contest(threadSeconds, kPairs, [&] { solveWith(t); },
                        [&] {
                            benchmark::DoNotOptimize(sides().surfaces.closestHits(recorder.closest));
                            benchmark::DoNotOptimize(sides().opaque.occluded(recorder.shadow));
                        });
    const auto rays = static_cast<double>(recorder.closest.size() + recorder.shadow.size());
    state.counters["ratio"] = times.ratio();
    state.counters["rays/path"] = rays / static_cast<double>(counters.paths);
    state.counters["Mray/s"] = rays / median(times.first) * 1e-6;
    state.counters["kernel Mray/s"] = rays / median(times.second) * 1e-6;
    record("path, office grids, all its rays / kernel", times.ratio(), "", 0.6);
    record("path, office grids, one thread", rays / median(times.first) * 1e-6, "Mray/s");
}
BENCHMARK(pathAgainstKernel)->Name("kernel/office/path")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace luxdeck::bench

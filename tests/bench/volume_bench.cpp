// volume/<what>: the irradiance volume of Greger's thesis (7^3 vertices, 3^3 in cells with geometry, 2 x 17^2 bins) in
// projects/office: rays a second while it is built against the estimator's own, queries a second against random access to
// as much memory, reading the file against reading its bytes. Beside each the thesis' own figure, of 1996.

#include "engine/algorithms/registry.h"
#include "engine/core/file.h"
#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/transport/lit_scene.h"
#include "engine/volume/field.h"
#include "engine/volume/vertex_sampler.h"
#include "engine/volume/visible_lookup.h"
#include "engine/volume/volume_build.h"
#include "engine/volume/volume_file.h"
#include "tests/bench/measuring.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::bench {

namespace {

constexpr int kPairs = 5;

/// The office, lit, with the volume of the thesis' size.
struct Built {
    LitScene lit = LitScene::create(office().scene).value();
    std::unique_ptr<RadianceEstimator> path = makeEstimator("path", lit.transport()).value();
    double seconds = 0;
    IrradianceVolume volume;
    VolumeField field;

    Built() : volume(build(seconds)), field(VolumeField::make(volume, {}).value()) {
        record("volume: vertices of 7^3 and 3^3 in the office (thesis: 2,287)", static_cast<double>(volume.vertexCount()), "");
        record("volume: seconds to build, one sample of 578 bins (thesis: 24 minutes)", seconds, "s");
        record("volume: memory of the field asked (thesis: 18 MB)", static_cast<double>(field.bytes()) / 1e6, "MB");
    }

private:
    IrradianceVolume build(double& took) {
        VolumeSettings settings;
        settings.samplesPerBin = 1;
        const double start = wallSeconds();
        auto out = buildVolume(lit.transport(), *path, settings, {}, Progress{}).value();
        took = wallSeconds() - start;
        return out;
    }
};

const Built& built() {
    static const Built one;
    return one;
}

/// The same rays with and without the volume about them.
void buildRate(benchmark::State& state) {
    const auto& b = built();
    const VolumeSettings settings;
    const auto sampler = VertexSampler::create(b.lit.transport(), *b.path, settings, 1).value();
    const auto& vertices = b.volume.lattice.vertices();
    TransportCounters fromVolume, bare;
    const auto withVolume = [&] {
        fromVolume = {};
        for (std::size_t v = 0; v < vertices.size(); v += 20) {
            VertexState vertex;
            sampler.sample(vertices[v], settings.samplesPerBin, vertex, fromVolume);
        }
    };
    const auto alone = [&] {
        bare = {};
        std::vector<RadianceQuery> queries(b.volume.binCount());
        std::vector<RadianceSample> samples(queries.size());
        for (std::size_t v = 0; v < vertices.size(); v += 20)
            for (std::uint32_t s = 0; s < settings.samplesPerBin; ++s) {
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    queries[i].ray.origin = vertices[v], queries[i].origin = {vertices[v]};
                    queries[i].numbers = SamplePath(streamSeed(1, v, i), s);
                    queries[i].ray.direction = b.volume.bins().direction(static_cast<int>(i), queries[i].numbers.next2D());
                    queries[i].pdfSolidAngle = 0.7F;
                }
                bare += b.path->radiance(queries, samples);
            }
    };
    for (auto _ : state) {
        const auto times = contest(threadSeconds, kPairs, withVolume, alone);
        const double ratio = times.ratio() * static_cast<double>(fromVolume.rays) / static_cast<double>(bare.rays);
        record("volume: rays/s while building over the estimator's own", ratio, "x", 0.95);
        state.counters["ratio"] = ratio;
    }
}

struct Questions {
    std::vector<Vec3> positions, directions;
    std::vector<std::uint32_t> anywhere;  // indices into as much memory
};

Questions questions(const IrradianceVolume& volume, std::size_t count, std::size_t memory) {
    Questions out;
    RandomStream random(1);
    const auto box = volume.lattice.bounds();
    for (std::size_t i = 0; i < count; ++i) {
        const auto between = [&](int axis) { return box.min[axis] + static_cast<float>(random.uniform()) * (box.max[axis] - box.min[axis]); };
        out.positions.emplace_back(between(0), between(1), between(2));
        out.directions.push_back(Vec3(Vec3d(random.normal(), random.normal(), random.normal()).normalized()));
        for (int c = 0; c < 8; ++c) out.anywhere.push_back(static_cast<std::uint32_t>(random.below(memory)));
    }
    return out;
}

void queryRate(benchmark::State& state) {
    const auto& b = built();
    constexpr std::size_t kCount = 500'000;  // as many as the thesis asked
    const std::size_t memory = b.field.bytes() / sizeof(Rgb);
    const auto asked = questions(b.volume, kCount, memory);
    const std::vector<Rgb> plain(memory, Rgb(1));
    std::vector<Rgb> values(kCount);
    const auto queries = [&] { b.field.at(asked.positions, asked.directions, values); };
    const auto access = [&] {
        for (std::size_t i = 0; i < kCount; ++i) {
            Rgb sum;
            for (std::size_t c = 0; c < 8; ++c) sum += plain[asked.anywhere[8 * i + c]];
            values[i] = sum;
        }
        benchmark::ClobberMemory();
    };
    for (auto _ : state) {
        const auto times = contest(threadSeconds, 4 * kPairs, queries, access);
        record("volume: queries/s a core at random positions and directions (thesis: 27,600)", static_cast<double>(kCount) / median(times.first) / 1e6, "M/s", 20);
        record("volume: queries over eight random reads each of as much memory", times.ratio(), "x", 0.5);
        state.counters["M/s"] = static_cast<double>(kCount) / median(times.first) / 1e6;
    }
}

void lookupRate(benchmark::State& state) {
    const auto& b = built();
    constexpr std::size_t kCount = 50'000;
    const auto asked = questions(b.volume, kCount, 1);
    std::vector<Rgb> values(kCount);
    const VisibleLookup lookup(b.field, b.lit.raycaster());
    for (auto _ : state) {
        const double seconds = secondsOf(threadSeconds, [&] { lookup.at(asked.positions, asked.directions, {}, values); });
        record("volume: queries/s a core that walls stop", static_cast<double>(kCount) / seconds / 1e6, "M/s");
    }
}

void loadRate(benchmark::State& state) {
    const auto& b = built();
    const auto file = std::filesystem::temp_directory_path() / fmt::format("luxdeck_bench_{}.vtu", b.volume.sceneHash);
    if (!writeVolume(file, b.volume)) {
        state.SkipWithError("the volume could not be written");
        return;
    }
    for (auto _ : state) {
        const auto times = contest(wallSeconds, kPairs, [&] { benchmark::DoNotOptimize(readVolume(file)); }, [&] { benchmark::DoNotOptimize(readFile(file)); });
        record("volume: reading a volume over reading its bytes", times.ratio(), "x", 0.3);
    }
    std::error_code ec;
    std::filesystem::remove(file, ec);
}

BENCHMARK(buildRate)->Name("volume/build")->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(queryRate)->Name("volume/query")->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(lookupRate)->Name("volume/lookup")->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(loadRate)->Name("volume/load")->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace

}  // namespace luxdeck::bench

// What it takes to load a model and to build its structures: seconds, and peak bytes for each triangle.

#include "engine/io/scene_files.h"
#include "engine/transport/lit_scene.h"
#include "tests/bench/measuring.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <malloc.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace luxdeck::bench {

namespace {

/// A field of /proc/self/status [bytes].
double memoryOf(const std::string& field) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(field + ":")) return std::stod(line.substr(field.size() + 1)) * 1024;
    return 0;
}

/// The most memory beyond what was held before, while something runs. Linux lets a process reset its peak.
class PeakMemory {
public:
    PeakMemory() {
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << 5;
        before_ = memoryOf("VmRSS");
    }
    [[nodiscard]] double bytes() const { return memoryOf("VmHWM") - before_; }

private:
    double before_;
};

/// A hilly field of a million triangles, deleted when the program ends.
class MillionTriangles {
public:
    static constexpr int kSide = 708;
    static constexpr std::size_t kTriangles = std::size_t{2} * (kSide - 1) * (kSide - 1);

    MillionTriangles() : path_(std::filesystem::temp_directory_path() / fmt::format("luxdeck_bench_{}.obj", getpid())) {
        std::ofstream file(path_);
        fmt::memory_buffer text;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                fmt::format_to(std::back_inserter(text), "v {:.4f} {:.4f} {:.4f}\n", 0.02 * x, 0.02 * y, 0.2 * std::sin(0.05 * x) * std::cos(0.07 * y));
        for (int y = 0; y + 1 < kSide; ++y)
            for (int x = 0; x + 1 < kSide; ++x) {
                const int a = y * kSide + x + 1, b = a + kSide;
                fmt::format_to(std::back_inserter(text), "f {} {} {}\nf {} {} {}\n", a, a + 1, b + 1, a, b + 1, b);
            }
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
    ~MillionTriangles() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    MillionTriangles(const MillionTriangles&) = delete;
    MillionTriangles& operator=(const MillionTriangles&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

const std::filesystem::path& millionTriangles() {
    static const MillionTriangles file;
    return file.path();
}

/// Loads a file and builds its structures, once; the expected count of triangles is its answer.
void setUp(benchmark::State& state, const std::string& name, const std::filesystem::path& file, std::size_t triangles) {
    double loadSeconds = 0, buildSeconds = 0, loadBytes = 0, buildBytes = 0;
    std::size_t seen = 0;
    for (auto _ : state) {
        const PeakMemory loading;
        auto part = readSceneFile(file, {});
        loadBytes = loading.bytes();
        if (!part) {
            state.SkipWithError(part.error().text().c_str());
            return;
        }
        auto scene = std::move(part->scene);
        seen = scene.triangleCount();
        const PeakMemory building;
        buildSeconds = secondsOf(wallSeconds, [&] {
            const auto lit = LitScene::create(scene);
            buildBytes = building.bytes();
        });
    }
    loadSeconds = secondsOf(wallSeconds, [&] { benchmark::DoNotOptimize(readSceneFile(file, {})); });
    if (triangles != 0 && seen != triangles) state.SkipWithError(fmt::format("{} triangles, expected {}", seen, triangles).c_str());
    const auto n = static_cast<double>(seen);
    state.counters["triangles"] = n;
    state.counters["load s"] = loadSeconds, state.counters["build s"] = buildSeconds;
    state.counters["load B/tri"] = loadBytes / n, state.counters["build B/tri"] = buildBytes / n;
    record(fmt::format("set-up, {}: load {:.0f} k triangles", name, n * 1e-3), loadSeconds, "s");
    record(fmt::format("set-up, {}: build", name), buildSeconds, "s");
    record(fmt::format("set-up, {}: peak while loading", name), loadBytes / n, "B/tri");
    record(fmt::format("set-up, {}: peak while building", name), buildBytes / n, "B/tri");
}

void setUpOffice(benchmark::State& state) {
    setUp(state, "office.glb", std::string(LUXDECK_SOURCE_DIR) + "/projects/office/office.glb", 0);
}
void setUpMillion(benchmark::State& state) {
    setUp(state, "OBJ", millionTriangles(), MillionTriangles::kTriangles);
}
BENCHMARK(setUpMillion)->Name("setup/obj_1M")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(setUpOffice)->Name("setup/office_glb")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace luxdeck::bench

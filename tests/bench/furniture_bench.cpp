// A desk that is dragged, and a wall of 612,000 polygons that is not in the scene (Greger 1996, 5.2).

#include "analysis/furniture/furniture_lighting.h"
#include "analysis/furniture/stream_shade.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/transport/lit_scene.h"
#include "engine/volume/volume_build.h"
#include "tests/bench/measuring.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace luxdeck::bench {

namespace {

constexpr int kUpdates = 40;

/// The office with a volume as coarse in its samples as the bench has time for: what lookups cost does not depend on them.
struct Room {
    Scene scene = office().scene;
    LitScene lit = LitScene::create(scene).value();
    IrradianceVolume volume;

    Room() {
        VolumeSettings settings;
        settings.samplesPerBin = 1;
        const Progress progress;
        const auto direct = makeEstimator("direct", lit.transport()).value();
        volume = buildVolume(lit.transport(), *direct, settings, {}, progress).value();
    }
};
const Room& room() {
    static const Room r;
    return r;
}

/// A desk of 1.6 x 0.8 m with panels and a modesty board, in boxes: about 10,000 vertices.
Scene desk() {
    Scene scene;
    scene.materials.emplace_back();
    scene.objects.push_back({"desk", true});
    Mesh mesh;
    const auto box = [&](const Vec3& low, const Vec3& high) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int i = 0; i < 8; ++i) mesh.positions.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z);
        const std::array<std::array<std::uint32_t, 4>, 6> faces{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& f : faces) mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]}), mesh.triangles.push_back({first + f[0], first + f[2], first + f[3]});
    };
    box({-0.8F, -0.4F, 0.70F}, {0.8F, 0.4F, 0.73F});
    box({-0.78F, -0.38F, 0}, {-0.75F, 0.38F, 0.70F});
    box({0.75F, -0.38F, 0}, {0.78F, 0.38F, 0.70F});
    box({-0.75F, 0.34F, 0.3F}, {0.75F, 0.36F, 0.70F});
    scene.meshes.push_back(std::move(mesh));
    return scene;
}

/// Two bursts of random reads of the same memory as a full update asks for, at least: 32 values a vertex.
double plainReads(const IrradianceVolume& volume, std::size_t vertices) {
    static const std::vector<Rgb> values(volume.direct.size(), Rgb(1.0F));
    RandomStream random(3);
    float sum = 0;
    for (std::size_t i = 0; i < vertices; ++i) {
        const std::size_t at = random.below(values.size() - 32);
        for (std::size_t k = 0; k < 32; ++k) sum += values[at + k].g;
    }
    return sum;
}

void dragDesk(benchmark::State& state) {
    const auto object = makeMovableObject(desk(), {.longestEdgeM = 0.061}).value();
    const auto lighting = FurnitureLighting::create(object, room().volume, &room().lit.raycaster()).value();
    const Vec3d start = Vec3d(1.0, 1.0, 0) - room().scene.origin - object.pivot;
    double sum = 0, reads = 0;
    const auto drag = [&](std::size_t level) {
        for (int i = 0; i < kUpdates; ++i) {
            lighting->update({start + Vec3d(0.3 * i, 0.15 * i, 0), 0}, level);
            sum += lighting->workingSurface({500, {}}).mean.value;
        }
    };
    Contest times;
    double coarse = 0;
    for (auto _ : state) {
        times = contest(threadSeconds, 5, [&] { drag(0); }, [&] { for (int i = 0; i < kUpdates; ++i) reads += plainReads(room().volume, object.positions.size()); });
        coarse = secondsOf(threadSeconds, [&] { drag(object.levels.size() - 1); });
    }
    if (!std::isfinite(sum + reads)) state.SkipWithError("the desk's light is not a number");
    const double ms = 1e3 * median(times.first) / kUpdates;
    state.counters["vertices"] = static_cast<double>(object.positions.size());
    state.counters["ms"] = ms;
    record("updates a second and core, desk of " + std::to_string(object.positions.size()) + " vertices", 1e3 / ms, "1/s", 200);
    record("the same at its coarsest level", kUpdates / coarse, "1/s");
    record("update of the desk / 32 plain reads for each vertex", times.ratio(), "");
}
BENCHMARK(dragDesk)->Iterations(1)->Unit(benchmark::kMillisecond);

/// Cinder blocks of 0.4 x 0.2 m with a rough face, 612,000 triangles, made as they are asked for.
class BlockWall final : public TriangleStream {
public:
    Result<void> next(std::vector<Triangle>& out, std::size_t most) override {
        out.clear();
        for (; next_ < kTriangles && out.size() < most; ++next_) {
            const std::size_t cell = next_ / 2, column = cell % kColumns, row = cell / kColumns;
            const auto at = [&](std::size_t i, std::size_t j) {
                const float x = 14.0F * static_cast<float>(i) / kColumns, z = 2.8F * static_cast<float>(j) / kRows;
                const float along = std::fmod(x + (std::fmod(z, 0.4F) < 0.2F ? 0.2F : 0.0F), 0.4F), up = std::fmod(z, 0.2F);
                const bool joint = along < 0.01F || up < 0.01F;
                RandomStream rough(i * 4099 + j);
                return Vec3(0.2F + x, 8.8F - (joint ? 0.0F : 0.01F + 0.004F * static_cast<float>(rough.uniform())), 0.05F + z);
            };
            if (next_ % 2 == 0) out.push_back({at(column, row), at(column + 1, row), at(column + 1, row + 1)});
            else out.push_back({at(column, row), at(column + 1, row + 1), at(column, row + 1)});
        }
        return {};
    }
    static constexpr std::size_t kColumns = 1020, kRows = 300, kTriangles = 2 * kColumns * kRows;

private:
    std::size_t next_ = 0;
};

void shadeWall(benchmark::State& state) {
    FieldSettings settings;
    settings.blendBins = true;
    const auto field = VolumeField::make(room().volume, settings).value();
    const auto run = [&](const Raycaster* walls) {
        const ThreadLimit one(1);
        BlockWall wall;
        const Progress progress;
        StreamSettings placed;
        placed.at = room().scene.toRebased({0, 0, 0});
        const double start = threadSeconds();
        auto counts = shadeStream(wall, field, walls, placed, [](std::span<const Vec3>, std::span<const Rgb>) { return Result<void>(); }, progress).value();
        return std::pair(counts, threadSeconds() - start);
    };
    for (auto _ : state) {
        const auto [plain, seconds] = run(nullptr);
        const auto [visible, secondsWithWalls] = run(&room().lit.raycaster());
        if (plain.triangles != BlockWall::kTriangles || plain.unknown > 0 || !(plain.maximumLux > 0)) state.SkipWithError("the wall is not lit");
        record("cinder-block wall of 612,000 polygons made and lit, one core (31 s in 1996)", seconds, "s");
        record("polygons a second and core, plain", static_cast<double>(plain.triangles) / seconds * 1e-6, "million");
        record("polygons a second and core, walls stop light", static_cast<double>(visible.triangles) / secondsWithWalls * 1e-6, "million");
    }
}
BENCHMARK(shadeWall)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace luxdeck::bench

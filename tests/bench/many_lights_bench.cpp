// 10 luminaires against 10,000 that give the same light together: what a path costs, and what it is worth.

#include "engine/sampling/sobol.h"
#include "tests/bench/measuring.h"
#include "tests/support/scenes.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>

namespace luxdeck::bench {

namespace {

constexpr float kLengthM = 30, kWidthM = 20, kHeightM = 6;
constexpr double kTotalLumens = 4e5;  // some 600 lx
constexpr double kOpeningsM2 = 3.6;   // of all luminaires, so that their luminance stays too

/// A wide reflector as it is hung in halls, and a narrower one.
CandelaTable batwing() {
    return test::axialTable([](double v) { return v < 88 ? 300 + 500 * std::exp(-std::pow((v - 32) / 18, 2)) - 3 * v : 0.0; });
}
CandelaTable narrower() {
    return test::axialTable([](double v) { return v < 90 ? 600 * std::pow(std::cos(v * kDegree), 3) : 0.0; });
}

/// A hall with shelves and machines, and that many luminaires in rows.
Scene hall(int columns, int rows) {
    test::SceneBuilder b;
    b.quad({0, 0, 0}, {kLengthM, 0, 0}, {0, kWidthM, 0}, b.matte(0.2F), 4);
    b.quad({0, 0, kHeightM}, {0, kWidthM, 0}, {kLengthM, 0, 0}, b.matte(0.7F), 4);
    const auto wall = b.matte(0.5F);
    b.quad({0, 0, 0}, {0, 0, kHeightM}, {kLengthM, 0, 0}, wall).quad({0, kWidthM, 0}, {kLengthM, 0, 0}, {0, 0, kHeightM}, wall);
    b.quad({0, 0, 0}, {0, kWidthM, 0}, {0, 0, kHeightM}, wall).quad({kLengthM, 0, 0}, {0, 0, kHeightM}, {0, kWidthM, 0}, wall);
    const auto shelf = b.matte(0.4F);
    for (int i = 0; i < 6; ++i) {
        const float x = 2 + 4.8F * static_cast<float>(i);
        b.box({x, 3, 0}, {x + 0.8F, 11, 2.5F}, shelf, false).box({x, 13, 0}, {x + 2, 15, 1.5F}, shelf, false);
    }
    const int count = columns * rows;
    const double side = std::sqrt(kOpeningsM2 / count);
    b.luminaire({0, 0, 0}, batwing(), {OpeningShape::Rectangle, side, side, 0});
    b.luminaire({0, 0, 0}, narrower(), {OpeningShape::Disc, side, side, 0});
    Scene scene = b.build();
    scene.luminaires.clear();
    for (int i = 0; i < count; ++i) {
        Luminaire l;
        l.type = i % 2 == 0 ? 0 : 1;
        l.position = {kLengthM * (static_cast<float>(i % columns) + 0.5F) / static_cast<float>(columns),
                      kWidthM * (static_cast<float>(i / columns) + 0.5F) / static_cast<float>(rows), kHeightM - 0.5F};
        l.frame = Frame::about(Vec3(std::sin(static_cast<float>(i)) * 0.05F, 0.03F, 1).normalized());  // hung by hand
        l.fluxScale = kTotalLumens / count / scene.luminaireTypes[l.type].photometry.table.lumens();
        scene.luminaires.push_back(l);
    }
    return scene;
}

struct Figures {
    double setupSeconds = 0, secondsPerPath = 0;
    double variance = 0, directVariance = 0;  // of one path, relative to the squared mean; mean over the sensors
    double lux = 0;
};

/// 36 sensors between the shelves, 32 x 64 paths each: a variance from 32 replicates is known to 25 %, the mean of
/// 36 of them to 4 %.
Figures measured(int columns, int rows) {
    constexpr std::uint32_t kSamples = 64;
    Figures out;
    const Scene scene = hall(columns, rows);
    std::unique_ptr<test::Lit> lit;
    out.setupSeconds = secondsOf(threadSeconds, [&] { lit = std::make_unique<test::Lit>(scene); });
    const auto path = lit->estimator("path");
    std::vector<Target> targets(36);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        targets[i].sensor.position = {4.4F + 4.8F * static_cast<float>(i % 6), 1.3F + 3.4F * static_cast<float>(i / 6), 0.85F};
        targets[i].stream = i;
    }
    TransportCounters counters;
    std::vector<PointSums> sums(targets.size());
    const double seconds = secondsOf(threadSeconds, [&] {
        for (std::size_t i = 0; i < targets.size(); ++i)
            sums[i] = measure(*path, scene.weights, targets[i], 1, 0, kSamples, counters);
    });
    const double paths = double{kSamples} * kReplicates * static_cast<double>(targets.size());
    out.secondsPerPath = seconds / paths;
    for (const auto& s : sums) {
        MeanVariance total, direct;
        for (const double x : s.totalMeans()) total.add(x);
        for (const double x : s.directMeans()) direct.add(x);
        const double n = static_cast<double>(targets.size());
        out.variance += total.variance() * kSamples / (total.mean() * total.mean()) / n;
        out.directVariance += direct.variance() * kSamples / (total.mean() * total.mean()) / n;
        out.lux += total.mean() / n;
    }
    return out;
}

void manyLights(benchmark::State& state) {
    std::map<int, Figures> by;
    for (auto _ : state)
        for (const auto& [columns, rows] : {std::pair{5, 2}, {10, 10}, {40, 25}, {125, 80}}) by[columns * rows] = measured(columns, rows);
    const auto& few = by.at(10);
    fmt::print("{:>10} {:>9} {:>10} {:>10} {:>11} {:>9} {:>15}\n", "luminaires", "set-up s", "us/path", "variance", "direct var.", "mean lx", "time x variance");
    for (const auto& [count, f] : by)
        fmt::print("{:>10} {:>9.4f} {:>10.3f} {:>10.3f} {:>11.4f} {:>9.1f} {:>15.3f}\n", count, f.setupSeconds, f.secondsPerPath * 1e6,
                   f.variance, f.directVariance, f.lux, f.secondsPerPath * f.variance / (few.secondsPerPath * few.variance));
    const auto& many = by.at(10000);
    // The same lumens in the same hall; what shelves hide and walls swallow differs by where the luminaires hang.
    if (!(std::abs(many.lux / few.lux - 1) < 0.3)) state.SkipWithError(fmt::format("{} lx, with 10 {} lx", many.lux, few.lux).c_str());
    record("10,000 luminaires: time of a path over that with 10", many.secondsPerPath / few.secondsPerPath, "");
    record("10,000 luminaires: variance of a path over that with 10", many.variance / few.variance, "");
    record("10 luminaires over 10,000: time x variance", few.secondsPerPath * few.variance / (many.secondsPerPath * many.variance), "", 0.5);
}
BENCHMARK(manyLights)->Name("many_lights")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace luxdeck::bench

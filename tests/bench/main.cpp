#include "tests/bench/measuring.h"
#include "tests/bench/solve_bench.h"

#include "analysis/grids/grid_points.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>

namespace luxdeck::bench {

namespace {

struct Row {
    std::string what;
    double measured;
    std::string unit;
    double minimum;
};
std::vector<Row> rows;

void printRows() {
    if (rows.empty()) return;
    fmt::print("\n{:<58} {:>8} {:>18}  met?\n", "", "goal", "measured");
    for (const auto& row : rows) {
        const bool goal = row.minimum > 0;
        fmt::print("{:<58} {:>8} {:>10.4g} {:<8} {}\n", row.what, goal ? fmt::format(">= {:g}", row.minimum) : "-",
                   row.measured, row.unit, goal ? (row.measured >= row.minimum ? "yes" : "NO") : "");
    }
}

}  // namespace

void record(const std::string& what, double measured, const std::string& unit, double minimum) {
    rows.push_back({what, measured, unit, minimum});
}

const Project& office() {
    static const Project project = [] {
        auto loaded = loadProject(std::string(LUXDECK_SOURCE_DIR) + "/projects/office/project.toml");
        if (!loaded) {
            fmt::print(stderr, "luxdeck_bench: {}\n", loaded.error().text());
            std::exit(EXIT_FAILURE);
        }
        return *std::move(loaded);
    }();
    return project;
}

std::vector<Target> gridTargets(const Project& project) {
    std::vector<Target> targets;
    for (const auto& grid : project.grids) {
        const auto layout = layOut(grid).value();
        for (std::size_t i = 0; i < layout.points.size(); ++i) {
            Target target;
            target.sensor.position = project.scene.toRebased(layout.points[i]);
            target.sensor.normal = Vec3(layout.normals[i]);
            target.sensor.kind = grid.kind == GridKind::Cylindrical ? SensorKind::Cylindrical : SensorKind::Planar;
            target.stream = targets.size();
            targets.push_back(target);
        }
    }
    return targets;
}

}  // namespace luxdeck::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return EXIT_FAILURE;
    luxdeck::bench::registerSolves();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    luxdeck::bench::printRows();
    return EXIT_SUCCESS;
}

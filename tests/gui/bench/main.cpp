// How long a frame takes in each kind of view, while the room is turned and whole, as it comes to the screen, by Mesa's software
// renderer: the office at 1280 x 800.
#include "gui/view3d/graphics.h"
#include "gui/view3d/scene_view.h"
#include "gui/view3d/view_area.h"
#include "tests/gui/bench/gap_bench.h"
#include "tests/gui/open_session.h"
#include "tests/support/virtual_display.h"

#include <QApplication>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <vtkRenderWindow.h>

namespace luxdeck::gui {
namespace {

constexpr double kDegreesAFrame = 3;

/// The office, solved and with a volume of 2,300 vertices and more, in a window.
class Room {
public:
    Room() {
        SolveSettings solve;
        solve.samples = 64;
        VolumeRequest volume;
        if (!open_.open(std::string(LUXDECK_SOURCE_DIR) + "/projects/office/project.toml")) fail("the office cannot be opened");
        open_.session.solving.start(solve);
        if (!open_.untilIdle()) fail("the office cannot be solved");
        if (auto settings = volumeSettingsOf(open_.session.project()->project, {})) volume.settings = *settings;
        volume.settings.firstLevel = {9, 7, 7};
        volume.settings.samplesPerBin = 1, volume.settings.lightSamples = 16;
        open_.session.volumes.build(volume);
        if (!open_.untilIdle() || open_.session.volumes.shown() == nullptr) fail("the volume cannot be built");
        area_ = std::make_unique<ViewArea>(open_.session);
        area_->resize(1280, 800);
        area_->show();
        QApplication::processEvents();
    }

    void show(const ViewSettings& settings) {
        open_.session.setView(0, settings);
        if (!open_.untilIdle()) fail("what is to be shown does not come");
        frame(0);
    }
    /// Turned by so much, rendered, and on the screen.
    void frame(double turnDeg) {
        auto& view = area_->view(0);
        view.setPose(orbited(view.pose(), middle(), turnDeg, 0));
        view.renderWindow()->Render();
        view.renderWindow()->WaitForCompletion();
        QApplication::processEvents();
    }
    /// As it is when nothing moves.
    void wholeFrame(double turnDeg) {
        auto& view = area_->view(0);
        view.setPose(orbited(view.pose(), middle(), turnDeg, 0));
        view.finish();
        QApplication::processEvents();
    }
    [[nodiscard]] std::size_t vertices() const { return open_.session.volumes.shown()->volume->vertexCount(); }
    [[nodiscard]] std::size_t bins() const { return open_.session.volumes.shown()->volume->binCount(); }

private:
    [[noreturn]] void fail(const char* what) const {
        fmt::print(stderr, "luxdeck_bench_gui: {}\n{}", what, open_.errors());
        std::exit(EXIT_FAILURE);
    }
    [[nodiscard]] Vec3d middle() const { return Vec3d(open_.session.project()->project.scene.bounds().center()); }

    test::OpenSession open_;
    std::unique_ptr<ViewArea> area_;
};

void turn(benchmark::State& state, Room& room, const ViewSettings& settings, void (Room::*frame)(double)) {
    room.show(settings);
    benchmark::IterationCount frames = 0;
    for (auto _ : state) {
        (room.*frame)(kDegreesAFrame);
        ++frames;
    }
    state.counters["frames/s"] = benchmark::Counter(static_cast<double>(frames), benchmark::Counter::kIsRate);
}

/// Settings of each kind of view, nothing else in it.
std::vector<std::pair<std::string, ViewSettings>> kinds() {
    ViewSettings bare;
    bare.grids = false;
    std::vector<std::pair<std::string, ViewSettings>> all{{"room", bare}};
    const auto add = [&](const std::string& name, const auto& change) {
        auto settings = bare;
        change(settings);
        all.emplace_back(name, settings);
    };
    add("calculation surfaces", [](ViewSettings& v) { v.grids = true; });
    add("irradiance spheres", [](ViewSettings& v) { v.glyphs = true; });
    add("radiance spheres, large", [](ViewSettings& v) { v.glyphs = true, v.order = 0, v.glyphRadiusM = 0.2; });
    add("spheres alone", [](ViewSettings& v) { v.glyphs = true, v.surfaces = SurfaceLook::Hidden, v.luminaires = false; });
    add("grids of the volume", [](ViewSettings& v) { v.firstLevelGrid = v.secondLevelGrid = true; });
    add("slice", [](ViewSettings& v) { v.slice = {true, {0, 0, 1}, -0.5}; });
    add("iso-surface", [](ViewSettings& v) { v.isosurface = true; });
    return all;
}

}  // namespace
}  // namespace luxdeck::gui

int main(int argc, char** argv) {
    using namespace luxdeck;
    benchmark::Initialize(&argc, argv);
    test::VirtualDisplay display;
    if (!display.start()) {
        std::fputs("Xvfb cannot be started: install xvfb (./dev bench does)\n", stderr);
        return 1;
    }
    const test::OwnUser user;
    gui::prepareGraphics();
    QApplication application(argc, argv);
    gui::Room room;
    std::printf("%zu vertices of %zu bins each\n", room.vertices(), room.bins());
    const auto add = [&](const std::string& name, const gui::ViewSettings& settings, void (gui::Room::*frame)(double)) {
        benchmark::RegisterBenchmark(name.c_str(), [&room, settings, frame](benchmark::State& state) { gui::turn(state, room, settings, frame); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MinTime(2);
    };
    for (const auto& [name, settings] : gui::kinds()) add("turn/" + name, settings, &gui::Room::frame);
    for (const auto& [name, settings] : gui::kinds()) add("whole/" + name, settings, &gui::Room::wholeFrame);
    gui::addGapBenches();  // last: from then on all is on one core
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

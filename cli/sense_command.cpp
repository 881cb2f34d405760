#include "analysis/grids/sampling_run.h"
#include "cli/command.h"
#include "cli/json_text.h"
#include "cli/line_reader.h"
#include "cli/load.h"
#include "cli/ray_lines.h"
#include "cli/streams.h"
#include "engine/algorithms/registry.h"
#include "engine/transport/chance_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

struct Options {
    std::vector<std::string> scene;
    bool radiance = false;
    bool irradiance = false;
    bool cylindrical = false;
    Effort effort;
};

/// Lines answered together: enough to keep all threads busy, few enough to bound memory.
constexpr std::size_t kMostLines = 2048;
/// Without a fixed number, an answer may take this many paths at most.
constexpr std::uint32_t kMostPerReplicate = 8192;

Target targetOf(const RayLine& line, const Options& o, std::uint64_t stream) {
    Target t;
    t.radiance = o.radiance;
    t.stream = stream;
    t.ray.origin = line.position, t.ray.direction = line.direction;
    t.sensor.position = line.position, t.sensor.normal = line.direction;
    t.sensor.kind = o.cylindrical ? SensorKind::Cylindrical : SensorKind::Planar;
    return t;
}

/// Answers lines in their order, batch by batch.
class Sense {
public:
    Sense(const Loaded& loaded, const RadianceEstimator& estimator, const Options& o, Context& context)
        : loaded_(loaded), estimator_(estimator), o_(o), context_(context) {}

    /// returns the answers, a line each; sets badLine() when one could not be read
    std::string answer(const std::vector<std::string>& lines) {
        enum class Line { Good, Bad, Blank };
        std::vector<Target> targets;
        std::vector<Line> kinds;
        for (const auto& line : lines) {
            const auto ray = parseRayLine(line, loaded_.project.scene);
            kinds.push_back(isBlank(line) ? Line::Blank : ray ? Line::Good : Line::Bad);
            if (kinds.back() == Line::Good) targets.push_back(targetOf(*ray, o_, lineNumber_));
            ++lineNumber_;
            if (kinds.back() == Line::Bad) bad_ = true, complainOfRayLine(line, lineNumber_);
        }
        SamplingRun run(estimator_, loaded_.project.scene.weights, std::move(targets), context_.common.seed);
        sample(run);
        for (const auto& sums : run.sums()) withheld_ += sums.perReplicate > 0 && sums.withheld() ? 1 : 0;
        std::string out;
        std::size_t next = 0;
        for (const auto kind : kinds)
            out += kind == Line::Blank ? "\n" : text(kind == Line::Good ? run.sums()[next++] : PointSums{});
        return out;
    }

    [[nodiscard]] bool badLine() const { return bad_; }
    [[nodiscard]] bool missedTarget() const { return missed_; }
    /// Answers that are no numbers, as too much has no value.
    [[nodiscard]] std::uint64_t withheld() const { return withheld_; }

private:
    void sample(SamplingRun& run) {
        ProgressState state;
        state.stage = "sensing";
        const double target = o_.effort.targetError.value_or(0.02);
        std::vector<std::uint32_t> request(run.sums().size(), o_.effort.samples ? (*o_.effort.samples + kReplicates - 1) / kReplicates : 16);
        while (run.round(request, context_.progress, state, o_.effort.timeSeconds)) {
            if (o_.effort.samples) return;
            bool more = false;
            for (std::size_t i = 0; i < request.size(); ++i) {
                const auto& sums = run.sums()[i];
                const bool open = sums.total().relative() > target;
                const double asked = target * std::abs(sums.total().value);
                const bool helps = sums.unseen() < 0.8 * asked || sums.noise() > asked;  // is there room for noise?
                const bool room = sums.perReplicate < kMostPerReplicate && helps;
                missed_ = missed_ || (open && !room);
                request[i] = open && room ? sums.perReplicate : 0;
                more = more || request[i] > 0;
            }
            if (!more) return;
        }
        missed_ = true;
    }

    [[nodiscard]] std::string text(const PointSums& sums) const {
        const bool known = sums.perReplicate > 0 && !sums.withheld();
        const Rgb c = sums.rgbMean();
        const auto y = known ? sums.total() : Interval{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
        if (context_.common.json) {
            nlohmann::ordered_json out{{"schema", "luxdeck-sense/1"}};
            const auto number = [](double x) { return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr); };
            out["r"] = known ? number(c.r) : nullptr, out["g"] = known ? number(c.g) : nullptr, out["b"] = known ? number(c.b) : nullptr;
            out["y"] = number(y.value), out["ci95"] = number(y.ci95), out["samples"] = sums.samples();
            return jsonText(out, -1);
        }
        if (!known) return "nan nan nan nan inf\n";
        return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.3g}\n", c.r, c.g, c.b, y.value, y.ci95);
    }

    const Loaded& loaded_;
    const RadianceEstimator& estimator_;
    const Options& o_;
    Context& context_;
    std::uint64_t lineNumber_ = 0, withheld_ = 0;
    bool bad_ = false, missed_ = false;
};

Exit runSense(const Options& o, Context& context) {
    auto loaded = load(o.scene, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    auto estimator = makeEstimator(o.effort.algorithm, (*loaded)->lit.transport(), o.effort.settings(), context.common.seed, context.progress);
    if (!estimator) return complain(estimator.error());
    if (algorithmNamed(o.effort.algorithm)->interreflection)
        printWarnings(chanceLightWarnings((*loaded)->lit.transport()), context.common.quiet);
    Sense sense(**loaded, **estimator, o, context);
    LineReader reader(0, context.progress);
    std::vector<std::string> lines;
    while (reader.next(lines, kMostLines) && !context.progress.cancelled())  // an interrupted read may end amid a line
        if (const auto written = writeOutput("-", sense.answer(lines)); !written) return complain(written.error());
    if (context.progress.cancelled()) return Exit::Interrupted;
    if (reader.failed()) return complain({ErrorCode::Parse, "a line is longer than 64 KiB, expected six numbers", "stdin"});
    if (sense.withheld() > 0)
        printWarnings({fmt::format("{} answers are withheld: of more than {:.0f} % of their samples a part is missing, as something "
                                   "has no value", sense.withheld(), 100 * kMostLost)}, context.common.quiet);
    if (sense.badLine()) return Exit::BadInput;
    return sense.missedTarget() || sense.withheld() > 0 ? Exit::NotReached : Exit::Ok;
}

}  // namespace

Command addSense(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("sense", "Radiance along rays or illuminance at points: reads `x y z dx dy dz` a line, answers `R G B Y ci95` a line, in order, in cd/m² or lx. "
        "A line that is not six numbers is answered by nan nan nan nan inf (exit status 3 at the end), a blank line by a blank line. Lines are answered as they come");
    app->add_option("scene", o->scene, "project.toml or a scene file; several .rad and .mat files are one scene, in their order")->required()->type_name("SCENE");
    auto* radiance = app->add_flag("--radiance", o->radiance, "Radiance along the ray from x y z towards dx dy dz, in cd/m²");
    auto* irradiance = app->add_flag("--irradiance", o->irradiance, "Illuminance at x y z on a surface that faces dx dy dz, in lx (the default)");
    auto* cylindrical = app->add_flag("--cylindrical", o->cylindrical, "Illuminance of a small cylinder at x y z with axis dx dy dz, in lx");
    radiance->excludes(irradiance)->excludes(cylindrical);
    irradiance->excludes(cylindrical);
    addEffort(*app, o->effort);
    return {app, [o](Context& context) { return runSense(*o, context); }};
}

}  // namespace luxdeck::cli

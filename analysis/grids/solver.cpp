#include "analysis/grids/solver.h"

#include "analysis/grids/condition.h"
#include "analysis/grids/grid_results.h"
#include "analysis/grids/grid_targets.h"
#include "analysis/grids/layers.h"
#include "analysis/grids/sampling_run.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "engine/core/version.h"
#include "engine/transport/chance_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace luxdeck {

namespace {

constexpr std::uint32_t kPilot = 8;  // first samples of each replicate

/// Of the target, what may be missing where samples can still reach it: below kAim.
constexpr double kRoomForNoise = 0.8;

/// Aim a little below the target: a point that ends just above it would cost a round more.
constexpr double kAim = 0.93;

/// Layers of more than this are refused: what a point keeps of each is 512 bytes.
constexpr double kMostLayerBytes = 2e9;

Result<void> canKeepLayers(const Project& project, const RadianceEstimator& estimator, const SolveSettings& settings,
                           const std::vector<GridLayout>& layouts) {
    if (!estimator.knowsSources())
        return Error{ErrorCode::InvalidArgument, fmt::format("algorithm \"{}\" does not know which luminaire light comes from, expected path or direct", settings.algorithm)};
    std::size_t points = 0;
    for (const auto& layout : layouts) points += layout.points.size();
    const std::size_t layers = LayerMap::of(project.scene).layers.size();
    const double bytes = static_cast<double>(points * layers) * 2 * kReplicates * sizeof(double);
    if (bytes > kMostLayerBytes)
        return Error{ErrorCode::OutOfResources, fmt::format("{} points times {} layers take {:.1f} GB, expected at most {:.1f}: give luminaires that are switched together one name",
                                                            points, layers, bytes * 1e-9, kMostLayerBytes * 1e-9)};
    return {};
}

/// The solve of one project: rounds of samples, and after each what it is known to.
class Solve {
public:
    Solve(const Project& project, const LitScene& lit, const SolveSettings& settings, const RadianceEstimator& estimator,
          std::vector<GridLayout> layouts, const Progress& progress)
        : project_(project), settings_(settings), layouts_(std::move(layouts)), progress_(progress),
          layerMap_(settings.byLuminaire ? LayerMap::of(project.scene) : LayerMap{}),
          errors_(estimator.groupSize() > 1 ? PointErrors::GoTogether : PointErrors::Independent),
          run_(estimator, project.scene.weights, targets(), settings.seed) {
        state_.stage = "solving";
        result_.kernel = lit.raycaster().kernel();
        result_.leftOut = leftOut(lit.needs());
        if (algorithmNamed(settings.algorithm)->interreflection) metByChance_ = chanceLightWarnings(lit.transport());
    }

    SolveResult run(const std::function<void(const SolveResult&)>& afterRound) {
        std::vector<std::uint32_t> request(points_.size(), firstRequest());
        bool going = true;
        while (going) {
            going = run_.round(request, progress_, state_, settings_.timeSeconds);
            assess();
            predict();
            if (settings_.samples || reached()) break;
            if (afterRound) tellSoFar(afterRound);
            request = nextRequest();
            // What misses the target still will miss it however long it goes on.
            going = going && std::ranges::any_of(request, [](auto more) { return more > 0; });
        }
        finish();
        return std::move(result_);
    }

private:
    /// A point of a grid, in the order of all grids' points.
    struct Point {
        std::size_t grid, index;
    };

    std::vector<Target> targets() {
        auto all = gridTargets(project_, layouts_);
        if (settings_.byLuminaire)
            for (auto& target : all) target.layers = &layerMap_;
        for (std::size_t g = 0; g < layouts_.size(); ++g)
            for (std::size_t i = 0; i < layouts_[g].points.size(); ++i) points_.push_back({g, i});
        return all;
    }

    [[nodiscard]] std::uint32_t firstRequest() const {
        return settings_.samples ? std::max(1U, (*settings_.samples + kReplicates - 1) / kReplicates) : kPilot;
    }

    /// Turns the sums into results and enters the error into the trace.
    void assess() {
        result_.grids = gridResults(project_, layouts_, run_.sums(), errors_);
        lacking_.assign(result_.grids.size(), 0);
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (run_.sums()[i].unseen() > 0) lacking_[points_[i].grid] = 1;
        ErrorAtTime entry{run_.seconds(), largestStatisticError(result_.grids), rmsPointError(result_.grids),
                          run_.counters().paths};
        state_.errorPercent = 100 * std::max(entry.relativeError, entry.rmsPointError);
        result_.trace.push_back(entry);
    }

    [[nodiscard]] bool reached() const {
        if (!(settings_.targetError > 0)) return false;
        if (largestStatisticError(result_.grids) > settings_.targetError) return false;
        for (const auto& grid : result_.grids)
            for (const auto& point : grid.points)
                if (pointError(grid, point) > settings_.targetError) return false;
        return true;
    }

    /// The error a point must come to for its grid to reach the target: tighter for the darkest ones while
    /// Emin or Uo still miss it.
    [[nodiscard]] double aimOf(const GridResult& grid, const PointResult& point) const {
        double aim = kAim * settings_.targetError;
        const double statistic = std::max(relativeError(grid.minimum.interval), relativeError(grid.uniformity.interval));
        const bool darkest = point.total.low() <= grid.minimum.interval.high();
        if (darkest && statistic > settings_.targetError) aim = std::min(aim, pointError(grid, point) * aim / statistic);
        return aim;
    }

    /// How fast the error falls with the number of samples, as the last two rounds show it: 1/2 for noise,
    /// up to 1 while the quasi-random points pay.
    [[nodiscard]] double errorExponent() const {
        const auto& t = result_.trace;
        if (t.size() < 2) return 0.5;
        const auto &before = t[t.size() - 2], &now = t.back();
        const double work = static_cast<double>(now.samples) / static_cast<double>(before.samples);
        const double slope = std::log(before.rmsPointError / now.rmsPointError) / std::log(work);
        return work > 1.2 && std::isfinite(slope) ? std::clamp(slope, 0.5, 1.0) : 0.5;
    }

    [[nodiscard]] double needed(std::size_t i) const {
        const auto& grid = result_.grids[points_[i].grid];
        // Emin and Uo that miss the target by what is missing will miss it however well the darkest points are known.
        const bool lacking = lacking_[points_[i].grid] != 0;
        return needed(i, lacking ? kAim * settings_.targetError : aimOf(grid, grid.points[points_[i].index]));
    }

    /// What samples can bring down of a point's error: all but what is missing.
    [[nodiscard]] double noiseOf(std::size_t i) const {
        const auto& grid = result_.grids[points_[i].grid];
        auto point = grid.points[points_[i].index];
        const auto& sums = run_.sums()[i];
        const double scale = std::max(point.total.value, kDarkPoint * grid.mean.interval.value);
        // What is missing may leave room for noise: then the whole of the interval can come down to the target.
        if (sums.unseen() > kRoomForNoise * settings_.targetError * scale) point.total.ci95 = sums.noise();
        return pointError(grid, point);
    }

    /// Samples for each replicate that bring the point to an error.
    [[nodiscard]] double needed(std::size_t i, double aim) const {
        const double have = run_.sums()[i].perReplicate;
        if (have == 0) return kPilot;
        if (!(settings_.targetError > 0)) return std::numeric_limits<double>::infinity();
        const double ratio = noiseOf(i) / aim;
        return ratio <= 1 ? have : have * std::pow(ratio, 1 / errorExponent());
    }

    [[nodiscard]] std::vector<std::uint32_t> nextRequest() const {
        std::vector<std::uint32_t> request(points_.size(), 0);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const double have = run_.sums()[i].perReplicate;
            const double more = std::min(needed(i) - have, std::max(have, double{kPilot}));
            // Whole eights keep the tail of a stratified set small.
            request[i] = more > 0 ? static_cast<std::uint32_t>(std::ceil(more / 8) * 8) : 0;
        }
        return request;
    }

    /// How long it will take, told anew after each round. The second round's word, the first that has seen
    /// how fast the error falls, goes on record. Points alone are counted: what Emin and Uo still need is
    /// known only when the darkest points have been told apart.
    void predict() {
        if (!(settings_.targetError > 0) || settings_.samples) return;
        double paths = 0;
        for (std::size_t i = 0; i < points_.size(); ++i)
            paths += kReplicates * std::max(0.0, needed(i, kAim * settings_.targetError) - run_.sums()[i].perReplicate);
        state_.secondsLeft = paths / std::max(run_.pathsPerSecond(), 1.0);
        if (result_.trace.size() <= 2) result_.predictedSeconds = run_.seconds() + state_.secondsLeft;
        progress_.report(state_);
    }

    void tellSoFar(const std::function<void(const SolveResult&)>& afterRound) {
        finish();
        result_.complete = result_.targetReached = false;
        afterRound(result_);
    }

    void finish() {
        const auto& counters = run_.counters();
        auto& r = result_;
        r.project = project_.info.name;
        r.withheldPoints = static_cast<std::uint64_t>(std::ranges::count_if(run_.sums(), &PointSums::withheld));
        r.complete = !progress_.cancelled() && (!settings_.samples || allSampled()) && r.withheldPoints == 0;
        r.targetError = settings_.samples ? 0 : settings_.targetError;
        r.targetReached = !(r.targetError > 0) || reached();
        r.seconds = run_.seconds();
        r.samples = counters.paths, r.rays = counters.rays;
        r.algorithm = settings_.algorithm;
        r.ambientLux = settings_.algorithm == "ambient" ? settings_.algorithmSettings.ambientLux : 0;
        r.seed = settings_.seed, r.threads = threadCount();
        r.truncatedFraction = counters.paths > 0 ? counters.truncatedWeight / static_cast<double>(counters.paths) : 0;
        r.rejectedSamples = counters.rejected;
        r.condition = conditionOf(project_.scene, run_.sums());
        r.sceneHash = project_.scene.hash, r.projectHash = project_.fileHash;
        r.version = kVersion;
        r.warnings = project_.scene.warnings;
        if (settings_.byLuminaire)
            r.layers = std::make_shared<LayeredSums>(LayeredSums{layerMap_.layers, run_.sums(), project_.scene.hash});
        addWarnings(r);
        for (auto& warning : conditionWarnings(r.condition, r.truncatedFraction)) r.warnings.push_back(std::move(warning));
        r.warnings.insert(r.warnings.end(), metByChance_.begin(), metByChance_.end());
    }

    [[nodiscard]] bool allSampled() const {
        return std::all_of(run_.sums().begin(), run_.sums().end(), [](const auto& s) { return s.perReplicate > 0; });
    }

    /// What has no value: the first such surface, by name.
    [[nodiscard]] std::string valueless() const {
        std::uint32_t at = kNothing;
        for (const auto& s : run_.sums()) at = std::min(at, s.lostAt);
        if (at == kNothing) return "a light or what is before it";
        return fmt::format("material \"{}\"", project_.scene.materials[at].name);
    }

    void addWarnings(SolveResult& r) const {
        if (r.rejectedSamples > 0)
            r.warnings.push_back(fmt::format("{} of {} samples met something without a value ({}): what was found before is kept, "
                                             "the intervals hold what may be missing", r.rejectedSamples, r.samples, valueless()));
        if (r.withheldPoints > 0)
            r.warnings.push_back(fmt::format("the numbers of {} of {} points are withheld: of more than {:.0f} % of their "
                                             "samples a part is missing", r.withheldPoints, points_.size(), 100 * kMostLost));
        for (const auto& grid : r.grids) {
            std::size_t inside = 0;
            for (const auto& point : grid.points) inside += point.insideSolid ? 1 : 0;
            if (inside > 0 && inside < grid.points.size())
                r.warnings.push_back(fmt::format("grid \"{}\": {} of {} points see mostly the backs of surfaces: they may lie inside a solid",
                                                 grid.name, inside, grid.points.size()));
        }
    }

    const Project& project_;
    SolveSettings settings_;
    std::vector<GridLayout> layouts_;
    const Progress& progress_;
    LayerMap layerMap_;
    std::vector<Point> points_;  // before run_, which fills it
    PointErrors errors_;
    SamplingRun run_;
    ProgressState state_;
    SolveResult result_;
    std::vector<std::uint8_t> lacking_;  // by grid: light may be missing at some of its points
    std::vector<std::string> metByChance_;  // lights that paths meet by chance alone, for people
};

}  // namespace

Result<SolveResult> solve(const Project& project, const LitScene& lit, const SolveSettings& settings,
                          const Progress& progress, const std::function<void(const SolveResult&)>& afterRound) {
    const Stopwatch preparing;
    auto estimator = makeEstimator(settings.algorithm, lit.transport(), settings.algorithmSettings, settings.seed, progress);
    const double prepared = preparing.seconds();
    if (!estimator) return estimator.error();
    auto layouts = layOutAll(project);
    if (!layouts) return layouts.error();
    if (layouts->empty())
        return Error{ErrorCode::InvalidArgument, "has no calculation grid: add a [[grid]] (docs/project-format.md)", project.file.string()};
    if (!(settings.targetError > 0) && !settings.timeSeconds && !settings.samples)
        return Error{ErrorCode::InvalidArgument, "neither a target error nor a time: solving would never end"};
    if (settings.byLuminaire)
        if (const auto possible = canKeepLayers(project, **estimator, settings, *layouts); !possible) return possible.error();
    auto result = Solve(project, lit, settings, **estimator, *std::move(layouts), progress).run(afterRound);
    result.setupSeconds = prepared;
    return result;
}

}  // namespace luxdeck

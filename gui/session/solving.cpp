#include "gui/session/solving.h"

#include "analysis/grids/layers.h"
#include "engine/algorithms/registry.h"
#include "engine/core/stopwatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace luxdeck::gui {

namespace {

constexpr double kShowEverySeconds = 1;  // rounds come faster, and each is drawn everywhere

/// Everything of a scene that changes light but for how far its luminaires are dimmed, in hashes.
std::string hashWithoutDimming(const Scene& scene) {
    Scene undimmed = scene;
    for (auto& luminaire : undimmed.luminaires) luminaire.dimming = 1;
    return sceneHash(undimmed);
}

/// Luminaires of one name and dimming were one layer when they were solved, so they have to be dimmed alike still.
bool dimmingsByName(const Scene& solved, const Scene& now, std::map<std::string, double>& out) {
    for (std::size_t i = 0; i < now.luminaires.size(); ++i) {
        if (solved.luminaires[i].dimming == 0) {
            if (now.luminaires[i].dimming != 0) return false;  // it was off: its light is not known
            continue;
        }
        const auto [at, isNew] = out.emplace(now.luminaires[i].name, now.luminaires[i].dimming);
        if (!isNew && at->second != now.luminaires[i].dimming) return false;
    }
    return true;
}

/// Grids or requirements differ.
bool sameGrids(const Project& a, const Project& b) {
    const auto same = [](const CalculationGrid& x, const CalculationGrid& y) {
        return x.name == y.name && x.origin == y.origin && x.u == y.u && x.v == y.v && x.borderM == y.borderM && x.spacingM == y.spacingM &&
               x.counts == y.counts && x.points == y.points && x.kind == y.kind && x.requirements.size() == y.requirements.size();
    };
    return a.grids.size() == b.grids.size() && std::equal(a.grids.begin(), a.grids.end(), b.grids.begin(), same);
}

}  // namespace

void Solving::start(const SolveSettings& wanted) {
    if (!place_.project) return;
    cancel();
    auto project = place_.project;
    auto settings = wanted;
    place_.jobs.start(JobKind::Solve, "Solving", [this, project, settings](const Progress& progress, const Jobs::Tell& tell) -> Jobs::Delivery {
        // Long for large scenes, and asked for with layers alone.
        const std::string lightless = settings.byLuminaire ? hashWithoutDimming(project->project.scene) : std::string();
        auto use = [this, project, lightless](SolveResult result) {
            return [this, project, lightless, shared = std::make_shared<const SolveResult>(std::move(result))] {
                of_ = project;
                solved_ = result_ = shared;
                lightless_ = lightless;
                follow();
                place_.tell(Change::Solve);
            };
        };
        std::optional<Stopwatch> sinceShown;
        auto solved = luxdeck::solve(project->project, project->lit, settings, progress, [&](const SolveResult& soFar) {
            if (sinceShown && sinceShown->seconds() < kShowEverySeconds) return;
            sinceShown.emplace();
            tell(use(soFar));
        });
        if (!solved) return place_.complaint(solved.error());
        return use(*std::move(solved));
    });
    place_.tell(Change::Jobs);
}

bool Solving::current() const { return current_; }

void Solving::follow() {
    if (!solved_ || !place_.project) return;
    const auto& now = place_.project->project;
    current_ = now.scene.hash == of_->project.scene.hash && sameGrids(now, of_->project);
    if (current_) {
        result_ = solved_;
        return;
    }
    std::map<std::string, double> dimmings;
    if (!solved_->layers || !sameGrids(now, of_->project) || hashWithoutDimming(now.scene) != lightless_ ||
        !dimmingsByName(of_->project.scene, now.scene, dimmings))
        return place_.tell(Change::Solve);
    current_ = showDimmed(dimmings);
    place_.tell(Change::Solve);
}

void Solving::preview(const std::map<std::string, double>& dimmings) {
    if (!followsDimming() || !current_) return;
    std::map<std::string, double> known;
    for (const auto& layer : solved_->layers->layers)
        if (const auto at = dimmings.find(layer.name); at != dimmings.end()) known.insert(*at);
    if (showDimmed(known)) place_.tell(Change::Solve);
}

bool Solving::showDimmed(const std::map<std::string, double>& dimmings) {
    auto dimmed = recombine(of_->project, *solved_->layers, dimmings);
    if (!dimmed) {
        place_.complain(dimmed.error());
        return false;
    }
    // What it cost stays that of the solve.
    dimmed->seconds = solved_->seconds, dimmed->algorithm = solved_->algorithm, dimmed->samples = solved_->samples, dimmed->trace = solved_->trace;
    dimmed->complete = solved_->complete;
    result_ = std::make_shared<const SolveResult>(*std::move(dimmed));
    return true;
}

void Solving::clear() {
    of_.reset(), solved_.reset(), result_.reset();
    current_ = false;
    place_.tell(Change::Solve);
}

}  // namespace luxdeck::gui

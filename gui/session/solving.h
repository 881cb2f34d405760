#pragma once

#include "analysis/grids/solver.h"
#include "gui/session/workplace.h"

#include <map>
#include <memory>
#include <string>

namespace luxdeck::gui {

/// Illuminance on the calculation surfaces: solving it, and following edits that need no new solve.
class Solving {
public:
    explicit Solving(Workplace& place) : place_(place) {}

    /// In the background; results come round after round. Settings that keep the light of each luminaire apart are taken
    /// where the algorithm can.
    void start(const SolveSettings& settings);
    void cancel() { place_.jobs.cancel(JobKind::Solve); }

    /// What is known; null: nothing. Not complete while it is being solved.
    [[nodiscard]] std::shared_ptr<const SolveResult> result() const { return result_; }
    /// The result is of the project as it is now (or of one that differs in dimming alone, which was followed).
    [[nodiscard]] bool current() const;

    /// The light of each luminaire is known apart, and so dimmings are followed.
    [[nodiscard]] bool followsDimming() const { return solved_ && solved_->layers; }
    /// Shows the results as other dimmings would have them, by the luminaires' names; nothing where they are not followed.
    /// What the project says comes back with its next change.
    void preview(const std::map<std::string, double>& dimmings);

    /// The project has changed: dimmings are followed from the layers; anything else makes the result old.
    void follow();
    void clear();

private:
    bool showDimmed(const std::map<std::string, double>& dimmings);

    Workplace& place_;
    std::shared_ptr<const LitProject> of_;             // that was solved
    std::shared_ptr<const SolveResult> solved_, result_;  // as solved; as dimmed now
    std::string lightless_;                            // of the solved scene, without its dimmings
    bool current_ = false;
};

}  // namespace luxdeck::gui

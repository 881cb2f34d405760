#pragma once

#include "analysis/compare/compare.h"
#include "engine/core/image.h"
#include "gui/session/volumes.h"
#include "gui/session/workplace.h"
#include "tonemap/falsecolor.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace luxdeck::gui {

/// One run of a comparison.
struct RunKey {
    std::string subject, algorithm;            ///< no algorithm: the reference
    int rung = 0;

    friend bool operator==(const RunKey&, const RunKey&) = default;
    friend bool operator<(const RunKey& a, const RunKey& b) { return std::tie(a.subject, a.algorithm, a.rung) < std::tie(b.subject, b.algorithm, b.rung); }
};

/// Something of a run to be looked at.
struct RunPicture {
    std::string title;                         ///< "path", "Reference", "Difference", with the grid's name where it is of one
    DisplayImage image;
    std::string unit;                          ///< of false colours; empty: tone mapped
    tonemap::ColourMap map = tonemap::ColourMap::Dusk;
    tonemap::ScaleRange range;                 ///< in that unit, linear
};

/// Algorithms against each other on the project: error against run time, in the background; each run can be looked at; and
/// a volume by each, to be seen side by side.
class Comparing {
public:
    Comparing(Workplace& place, Volumes& volumes) : place_(place), volumes_(volumes) {}

    /// How long it will take without the references [s]: budgets, repetitions and rungs; 0 where samples are given instead.
    [[nodiscard]] double expectedSeconds(const CompareSettings& settings) const;

    /// In the background; what was compared before goes.
    void start(const CompareSettings& settings);
    /// What there is stays, marked incomplete.
    void cancel() { place_.jobs.cancel(JobKind::Compare); }

    /// Run after run while it goes on; null: nothing.
    [[nodiscard]] const std::shared_ptr<const Comparison>& result() const { return result_; }
    /// Of the project as it is now.
    [[nodiscard]] bool current() const;

    /// Makes the pictures of a run, in the background: pictures() are of it soon.
    void look(const RunKey& run);
    [[nodiscard]] const RunKey& looked() const { return looked_; }
    /// Of the run that is looked at: itself, the reference, the difference; of grids one of each for each grid.
    [[nodiscard]] const std::vector<RunPicture>& pictures() const { return pictures_; }

    /// Builds the project's volume by each compared algorithm and by the reference, in the background: they come among the
    /// session's volumes by the algorithms' names, and their differences into the result.
    void buildVolumes(const AlgorithmSettings& settings = {});

    /// Figures, tables, plots and error pictures as the command line writes them; in the background, failures to the log.
    ///
    /// errors  InvalidArgument: nothing was compared
    Result<void> save(const std::filesystem::path& folder);

    void clear();

private:
    void take(std::shared_ptr<const Comparison> result);

    Workplace& place_;
    Volumes& volumes_;
    std::shared_ptr<const LitProject> of_;
    std::shared_ptr<const Comparison> result_;
    std::map<RunKey, std::shared_ptr<const ComparedValues>> values_;
    RunKey looked_;
    std::vector<RunPicture> pictures_;
};

}  // namespace luxdeck::gui

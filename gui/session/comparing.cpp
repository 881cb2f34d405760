#include "gui/session/comparing.h"

#include "analysis/compare/compare_folder.h"
#include "analysis/compare/volume_pairs.h"
#include "analysis/report/compare_plot.h"
#include "engine/algorithms/registry.h"
#include "gui/session/run_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::gui {

double Comparing::expectedSeconds(const CompareSettings& settings) const {
    if (settings.samples || !place_.project) return 0;
    const auto contenders = settings.algorithms.empty() ? algorithms().size() : settings.algorithms.size();
    const auto subjects = settings.views.size() + (settings.grids && !place_.project->project.grids.empty() ? 1 : 0);
    const double ladder = settings.budgetSeconds * (2 - std::ldexp(1.0, 1 - settings.rungs));
    return static_cast<double>(contenders * subjects) * settings.repetitions * ladder;
}

bool Comparing::current() const { return result_ && place_.project && result_->sceneHash == place_.project->project.scene.hash; }

void Comparing::start(const CompareSettings& settings) {
    if (!place_.project) return;
    cancel();
    clear();
    of_ = place_.project;
    place_.jobs.start(JobKind::Compare, "Comparing", [this, project = of_, settings](const Progress& progress, const Jobs::Tell& tell) -> Jobs::Delivery {
        const auto heard = [&](const Comparison& soFar, const ComparedValues& last) {
            tell([this, project, all = std::make_shared<const Comparison>(soFar), one = std::make_shared<const ComparedValues>(last)] {
                if (project != of_) return;
                values_[{one->subject, one->algorithm, one->rung}] = one;
                take(all);
            });
        };
        auto result = compare(project->project, project->lit, settings, progress, heard);
        if (!result) return place_.complaint(result.error());
        return [this, project, all = std::make_shared<const Comparison>(*std::move(result))] {
            if (project != of_) return;
            for (const auto& warning : all->warnings) place_.warn(warning);
            take(all);
        };
    });
    place_.tell(Change::Jobs);
}

void Comparing::take(std::shared_ptr<const Comparison> result) {
    result_ = std::move(result);
    place_.tell(Change::Comparison);
}

void Comparing::look(const RunKey& run) {
    const auto own = values_.find(run), reference = values_.find({run.subject, "", 0});
    if (own == values_.end() || reference == values_.end()) return;
    looked_ = run;
    pictures_.clear();
    place_.jobs.start(JobKind::Look, "Drawing differences", [this, run, own = own->second, truth = reference->second](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
        auto made = std::make_shared<Result<std::vector<RunPicture>>>(runPictures(*own, *truth, differenceRange(*own)));
        return [this, run, made] {
            if (!(looked_ == run)) return;  // another one was clicked meanwhile
            if (*made) pictures_ = std::move(**made);
            else place_.complain(made->error());
            place_.tell(Change::Comparison);
        };
    });
    place_.tell(Change::Comparison);
}

void Comparing::buildVolumes(const AlgorithmSettings& settings) {
    if (!current() || place_.jobs.running(JobKind::Compare)) return;
    place_.jobs.start(JobKind::Volume, "Building volumes", [this, project = of_, settings, before = result_](const Progress& progress, const Jobs::Tell& tell) -> Jobs::Delivery {
        auto found = *before;
        found.volumes.clear();
        const auto keep = [&](const std::string& name, std::shared_ptr<const IrradianceVolume> volume) -> Result<void> {
            tell([this, project, name, volume] {
                if (project == of_) volumes_.add({name, {}, volume, project, {}, place_.project && place_.project->project.scene.hash == volume->sceneHash});
            });
            return {};
        };
        const auto done = compareVolumePairs(project->project, project->lit, settings, TakeVolume(keep), progress, found);
        if (!done) return place_.complaint(done.error());
        return [this, project, before, volumes = found.volumes] {
            if (project != of_ || before != result_) return;
            auto with = *result_;
            with.volumes = volumes;
            take(std::make_shared<const Comparison>(std::move(with)));
        };
    });
    place_.tell(Change::Jobs);
}

Result<void> Comparing::save(const std::filesystem::path& folder) {
    if (!result_) return Error{ErrorCode::InvalidArgument, "nothing was compared yet", folder.string()};
    place_.save("Saving comparison", "Saved the comparison in " + folder.string(), [result = result_, folder]() -> Result<void> {
        if (auto written = writeComparison(*result, folder); !written) return written;
        return writeComparePlots(*result, folder);
    });
    return {};
}

void Comparing::clear() {
    of_.reset(), result_.reset();
    values_.clear();
    looked_ = {};
    pictures_.clear();
    place_.tell(Change::Comparison);
}

}  // namespace luxdeck::gui

#include "gui/session/volumes.h"

#include "engine/algorithms/registry.h"
#include "engine/volume/volume_file.h"

#include <algorithm>
#include <utility>

namespace luxdeck::gui {

Result<IrradianceVolume> buildVolume(const LitProject& project, const VolumeRequest& request, const Progress& progress) {
    const auto scene = project.lit.transport();
    const auto estimator = makeEstimator(request.options.algorithm, scene, request.algorithmSettings, request.options.seed, progress);
    if (!estimator) return estimator.error();
    return luxdeck::buildVolume(scene, **estimator, request.settings, request.options, progress);
}

void Volumes::build(const VolumeRequest& request) {
    if (!place_.project) return;
    place_.jobs.cancel(JobKind::Volume);
    auto project = place_.project;
    place_.jobs.start(JobKind::Volume, "Building volume " + request.name,
                      [this, project, request](const Progress& progress, const Jobs::Tell&) -> Jobs::Delivery {
        auto built = buildVolume(*project, request, progress);
        if (!built) return place_.complaint(built.error());
        auto volume = std::make_shared<const IrradianceVolume>(*std::move(built));
        return [this, project, volume, name = request.name] {
            add({name, {}, volume, project, {}, place_.project->project.scene.hash == volume->sceneHash});
        };
    });
    place_.tell(Change::Jobs);
}

Result<void> Volumes::open(const std::filesystem::path& file) {
    auto volume = readVolume(file);
    if (!volume) return volume.error();
    VolumeState state{file.stem().string(), file, std::make_shared<const IrradianceVolume>(*std::move(volume)), place_.project, {}, true};
    state.current = place_.project && place_.project->project.scene.hash == state.volume->sceneHash;
    if (!state.current) place_.warn(file.filename().string() + " is a volume of another state of this project: it is shown as it is");
    add(std::move(state));
    return {};
}

Result<void> Volumes::save(std::size_t index, const std::filesystem::path& file) {
    if (index >= all_.size()) return Error{ErrorCode::InvalidArgument, "there is no such volume", {}};
    if (auto written = writeVolume(file, *all_[index].volume); !written) return written;
    all_[index].file = file;
    place_.tell(Change::Volumes);
    return {};
}

void Volumes::remove(std::size_t index) {
    if (index >= all_.size()) return;
    all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(index));
    shown_ = 0;
    place_.tell(Change::Volumes);
}

void Volumes::add(VolumeState state) {
    auto at = std::find_if(all_.begin(), all_.end(), [&](const auto& v) { return v.name == state.name; });
    if (at == all_.end()) at = all_.insert(all_.end(), VolumeState{});
    *at = std::move(state);
    if (at->without.empty()) shown_ = static_cast<std::size_t>(at - all_.begin());
    place_.tell(Change::Volumes);
}

void Volumes::show(std::size_t index) {
    if (index >= all_.size() || index == shown_) return;
    shown_ = index;
    place_.tell(Change::Volumes);
}

const VolumeState* Volumes::named(const std::string& name) const {
    const auto at = std::find_if(all_.begin(), all_.end(), [&](const auto& v) { return v.name == name; });
    return at == all_.end() ? shown() : &*at;
}

void Volumes::follow() {
    bool changed = false;
    for (auto& state : all_) {
        // One without an object is of another scene by its nature: it lasts while its room does (Furnishing sees to it).
        const bool current = !state.without.empty() ? state.current : place_.project && place_.project->project.scene.hash == state.volume->sceneHash;
        changed = changed || current != state.current;
        state.current = current;
    }
    if (changed) place_.tell(Change::Volumes);
}

void Volumes::clear() {
    all_.clear();
    shown_ = 0;
    place_.tell(Change::Volumes);
}

}  // namespace luxdeck::gui

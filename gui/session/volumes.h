#pragma once

#include "engine/volume/volume.h"
#include "engine/volume/volume_build.h"
#include "gui/session/workplace.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::gui {

/// An irradiance volume of the session.
struct VolumeState {
    std::string name;                                   ///< "room", or "without Desk 03"
    std::filesystem::path file;                         ///< empty: in memory alone
    std::shared_ptr<const IrradianceVolume> volume;
    std::shared_ptr<const LitProject> of;               ///< what it was built in (without the object, where one is left out)
    std::string without;                                ///< object that was left out; empty: none
    bool current = true;                                ///< of the project as it is now
};

struct VolumeRequest {
    std::string name = "room";
    VolumeSettings settings;
    BuildOptions options;
    AlgorithmSettings algorithmSettings;
};

/// On the calling thread. errors  of makeEstimator() and luxdeck::buildVolume()
Result<IrradianceVolume> buildVolume(const LitProject& project, const VolumeRequest& request, const Progress& progress);

/// The irradiance volumes of a session: built in the background, read and written.
class Volumes {
public:
    explicit Volumes(Workplace& place) : place_(place) {}

    /// In the background; replaces one of the same name.
    void build(const VolumeRequest& request);
    /// errors  of readVolume(); a volume of another scene is taken and marked as not current
    Result<void> open(const std::filesystem::path& file);
    Result<void> save(std::size_t index, const std::filesystem::path& file);
    void remove(std::size_t index);
    void add(VolumeState state);

    [[nodiscard]] const std::vector<VolumeState>& all() const { return all_; }
    /// The one that views show; null: none.
    [[nodiscard]] const VolumeState* shown() const { return shown_ < all_.size() ? &all_[shown_] : nullptr; }
    [[nodiscard]] std::size_t shownIndex() const { return shown_; }
    void show(std::size_t index);
    /// The one of that name; shown() for none, or when there is no such any more.
    [[nodiscard]] const VolumeState* named(const std::string& name) const;

    void follow();
    void clear();

private:
    Workplace& place_;
    std::vector<VolumeState> all_;
    std::size_t shown_ = 0;
};

}  // namespace luxdeck::gui

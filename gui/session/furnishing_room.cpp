#include "gui/session/furnishing_room.h"

#include "engine/volume/volume_build.h"

#include <utility>

namespace luxdeck::gui {

namespace {

/// Points of a grid, as many of a surface as tell which part of it lies where.
std::vector<Vec3d> pointsOf(const CalculationGrid& grid) {
    constexpr int kSide = 10;
    std::vector<Vec3d> points;
    for (const auto& point : grid.points) points.push_back(point[0]);
    if (!points.empty()) return points;
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) points.push_back(grid.origin + grid.u * ((i + 0.5) / kSide) + grid.v * ((j + 0.5) / kSide));
    return points;
}

/// What lies on the working surface, in the user's coordinates: a little below it to reading height.
Box3d overWorkingSurface(const MovableObject& object, const Vec3d& origin) {
    Box3d box;
    for (std::size_t i = 0; i < object.positions.size(); ++i)
        if (object.workingAreaM2[i] > 0) box.extendBy(Vec3d(object.positions[i]) + object.pivot + origin);
    if (box.isEmpty()) return box;
    box.min.z -= 0.05, box.max.z += 0.3;
    return box;
}

Result<std::shared_ptr<const LitProject>> litRoom(const LitProject& project, Scene scene) {
    auto room = std::make_unique<LitProject>();
    room->project = project.project;
    room->project.scene = std::move(scene);
    auto lit = LitScene::create(room->project.scene);
    if (!lit) return lit.error();
    room->lit = *std::move(lit);
    return std::shared_ptr<const LitProject>(std::move(room));
}

}  // namespace

Result<EmptyRoom> emptyRoom(const LitProject& project, const std::string& object, const std::vector<VolumeState>& known,
                            const std::optional<VolumeRequest>& request, const Progress& progress) {
    auto scene = withoutObject(project.project.scene, object);
    if (!scene) return scene.error();
    EmptyRoom room;
    for (const auto& state : known) {
        if (state.volume->sceneHash != scene->hash) continue;
        room.volume = state.volume;
        if (state.of && state.of->project.scene.hash == scene->hash) room.project = state.of;
    }
    if (!room.project) {
        auto lit = litRoom(project, *std::move(scene));
        if (!lit) return lit.error();
        room.project = *std::move(lit);
    }
    if (room.volume) return room;
    const auto settings = request ? Result<VolumeSettings>(request->settings) : volumeSettingsOf(room.project->project, {});
    if (!settings) return settings.error();
    auto wanted = request.value_or(VolumeRequest{});
    wanted.settings = *settings;
    auto volume = buildVolume(*room.project, wanted, progress);
    if (!volume) return volume.error();
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, "stopped", {}};
    room.volume = std::make_shared<const IrradianceVolume>(*std::move(volume));
    room.built = true;
    return room;
}

std::optional<RequiredLight> requiredOn(const Project& project, const MovableObject& object) {
    const auto over = overWorkingSurface(object, project.scene.origin);
    std::optional<RequiredLight> found;
    double most = 0;
    for (const auto& grid : project.grids) {
        const auto points = pointsOf(grid);
        double inside = 0;
        for (const auto& point : points) inside += over.intersects(point) ? 1 : 0;
        const double part = inside / static_cast<double>(points.size());
        for (const auto& requirement : grid.requirements)
            if (requirement.meanLux && part > most && grid.kind == GridKind::Planar) most = part, found = RequiredLight{grid.name, *requirement.meanLux};
    }
    return found;
}

}  // namespace luxdeck::gui

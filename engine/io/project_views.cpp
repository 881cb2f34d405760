#include "engine/io/project_keys.h"
#include "engine/io/project_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace luxdeck::project {

namespace {

constexpr TomlChoice<ViewKind> kViewKinds[] = {{"perspective", ViewKind::Perspective}, {"fisheye", ViewKind::Fisheye}};
// Beyond 170 degrees a flat picture is all rim; below 0.1 it is a telescope's.
constexpr NumberRange kFov{.low = 0.1, .high = 170};
constexpr int kMaxPictureSide = 16384;
constexpr double kEyeHeightM = 1.6;
// With pictures of 3:2 it sees 90 degrees across: from a corner, both walls to their ends.
constexpr double kCornerFovDeg = 67;

bool parallel(const Vec3d& a, const Vec3d& b) { return a.cross(b).length() <= 1e-6 * a.length() * b.length(); }

Vec3d readDirection(const TomlTable& table, const Vec3d& position) {
    const Vec3d harmless(0, 1, 0);
    if (table.refuseBoth("target", "direction")) return harmless;
    if (!table.has("target") && !table.has("direction")) {
        table.error(ErrorCode::Parse, "", "target or direction is missing");
        return harmless;
    }
    const Key key = table.has("target") ? "target" : "direction";
    const auto direction = key == "target" ? table.vector(key) - position : table.vector(key);
    if (direction.length() > 0) return direction.normalized();
    table.error(ErrorCode::InvalidArgument, key,
                key == "target" ? "target is the position, expected another point" : "direction is [0, 0, 0]");
    return harmless;
}

/// Up as asked for; by default z, and y for views straight up or down (north is up, as in a plan).
Vec3d readUp(const TomlTable& table, const Vec3d& direction) {
    if (!table.has("up")) return parallel(direction, Vec3d(0, 0, 1)) ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
    const auto up = table.vector("up");
    if (up.length() > 0 && !parallel(direction, up)) return up.normalized();
    table.error(ErrorCode::InvalidArgument, "up", "up is zero or along the direction of view, expected another direction");
    return {0, 0, 1};
}

std::string uniqueName(std::set<std::string>& taken, const std::string& wanted) {
    const std::string stem = wanted.empty() ? "camera" : wanted;
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{} {}", stem, i);
    return name;
}

}  // namespace

std::vector<View> readViews(const TomlTable& root) {
    std::vector<View> views;
    UniqueNames names;
    root.each("view", kView, [&](const TomlTable& table) {
        View view;
        view.where = table.where();
        view.name = table.text("name");
        names.add(table, "name", view.name);
        view.kind = table.choice<ViewKind>("kind", ViewKind::Perspective, kViewKinds);
        view.position = table.vector("position");
        view.direction = readDirection(table, view.position);
        view.up = readUp(table, view.direction);
        const bool fisheye = view.kind == ViewKind::Fisheye;
        if (fisheye && table.has("vertical_fov_deg"))
            table.error(ErrorCode::InvalidArgument, "vertical_fov_deg",
                        "vertical_fov_deg belongs to perspective views: a fisheye always sees 180 degrees");
        view.verticalFovDeg = fisheye ? 180.0 : table.number("vertical_fov_deg", kFov, view.verticalFovDeg);
        const auto standard = fisheye ? std::array{1000, 1000} : std::array{view.width, view.height};
        const auto size = table.integers<2>("size", 1, kMaxPictureSide, standard);
        view.width = size[0], view.height = size[1];
        views.push_back(std::move(view));
    });
    return views;
}

std::vector<VolumeSpec> readVolumes(const TomlTable& root) {
    std::vector<VolumeSpec> volumes;
    UniqueNames names;
    root.each("volume", kVolume, [&](const TomlTable& table) {
        VolumeSpec volume;
        volume.where = table.where();
        volume.name = table.text("name");
        names.add(table, "name", volume.name);
        volume.min = table.vector("min");
        volume.max = table.vector("max");
        for (int i = 0; i < 3 && table.has("min") && table.has("max"); ++i)
            if (!(volume.min[i] < volume.max[i]))
                table.error(ErrorCode::InvalidArgument, "max",
                            fmt::format("max[{}] is {}, expected more than min[{}], which is {}", i, volume.max[i], i, volume.min[i]));
        volume.firstLevel = table.integers<3>("first_level", 2, 256, volume.firstLevel);
        volume.secondLevel = table.integer("second_level", 1, 32, volume.secondLevel);
        volume.bins = table.integer("bins", 2, 64, volume.bins);
        volumes.push_back(std::move(volume));
    });
    return volumes;
}

std::vector<HolodeckSection> readHolodeckSections(const TomlTable& root) {
    std::vector<HolodeckSection> sections;
    UniqueNames names;
    root.each("holodeck_section", kHolodeck, [&](const TomlTable& table) {
        HolodeckSection section;
        section.where = table.where();
        section.name = table.text("name");
        names.add(table, "name", section.name);
        section.origin = table.vector("origin");
        const auto rows = table.rows("axes", 3);
        for (std::size_t i = 0; i < 3 && i < rows.size(); ++i) section.axes[i] = {rows[i][0], rows[i][1], rows[i][2]};
        const auto& [a, b, c] = section.axes;
        if (table.has("axes") && rows.size() != 3)
            table.error(ErrorCode::Parse, "axes", fmt::format("axes has {} edges, expected 3", rows.size()));
        else if (table.has("axes") && !(std::abs(a.dot(b.cross(c))) > 1e-9 * a.length() * b.length() * c.length()))
            table.error(ErrorCode::InvalidArgument, "axes", "axes span no volume, expected three edges out of one plane");
        section.grid = table.integers<3>("grid", 1, 64, section.grid);
        sections.push_back(std::move(section));
    });
    return sections;
}

std::vector<View> viewsOf(const std::vector<SceneCamera>& cameras, const std::string& where) {
    std::vector<View> views;
    std::set<std::string> taken;
    for (const auto& camera : cameras) {
        View view;
        view.name = uniqueName(taken, camera.name);
        view.position = camera.position;
        view.direction = camera.direction;
        view.up = camera.up;
        view.verticalFovDeg = camera.verticalFovDeg;
        view.where = where;
        views.push_back(std::move(view));
    }
    return views;
}

View cornerView(const Box3d& bounds) {
    View view;
    view.name = "corner";
    view.verticalFovDeg = kCornerFovDeg;
    view.position = {0, 0, kEyeHeightM};
    if (bounds.isEmpty()) return view;
    const Vec3d size = bounds.max - bounds.min;
    // Off the corner itself, so that the walls which meet there are in front of the eye and not around it.
    view.position = bounds.min + 0.05 * size;
    const bool flat = size.z <= 1e-3 * std::max(size.x, size.y);
    view.position.z = bounds.min.z + (flat ? kEyeHeightM : std::min(kEyeHeightM, 0.6 * size.z));
    Vec3d target = (bounds.min + bounds.max) * 0.5;
    if (!flat) target.z = 0.5 * (target.z + view.position.z);  // mostly ahead: upright walls stay nearly upright
    const auto direction = target - view.position;
    if (direction.length() > 0) view.direction = direction.normalized();
    if (parallel(view.direction, view.up)) view.up = {0, 1, 0};
    return view;
}

}  // namespace luxdeck::project

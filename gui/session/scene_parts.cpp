#include "gui/session/scene_parts.h"

#include "engine/scene/opening.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr std::uint32_t kNoLuminaire = 0xffffffffU;
constexpr float kThickestM = 0.6F;       // of a wall or slab
constexpr float kNearSide = 0.08F;       // part of the scene's extent from its side in which a wall begins
constexpr float kOwnDepthM = 0.15F;      // what is set into a wall or ceiling goes no deeper
constexpr float kHousingM = 0.35F;       // a housing is no larger than its opening and this

struct SideOf {
    ShellSide side;
    int axis;
    bool high;
};
constexpr std::array<SideOf, 6> kSides{{{ShellSide::West, 0, false},
                                        {ShellSide::East, 0, true},
                                        {ShellSide::South, 1, false},
                                        {ShellSide::North, 1, true},
                                        {ShellSide::Floor, 2, false},
                                        {ShellSide::Ceiling, 2, true}}};

const SideOf& description(ShellSide side) {
    return *std::find_if(kSides.begin(), kSides.end(), [&](const SideOf& s) { return s.side == side; });
}

Box3 grown(Box3 box, float metres) {
    box.min -= Vec3(metres);
    box.max += Vec3(metres);
    return box;
}

bool within(const Box3& inside, const Box3& outside) { return outside.intersects(inside.min) && outside.intersects(inside.max); }

}  // namespace

SceneParts::SceneParts(const Scene& scene)
    : scene_(&scene), bounds_(scene.objects.size()), sides_(scene.objects.size(), ShellSide::None), hulls_(scene.objects.size()), luminaires_(scene.objects.size(), kNoLuminaire) {
    for (const auto& mesh : scene.meshes)
        for (const auto& position : mesh.positions) bounds_[mesh.object].extendBy(position);
    for (const auto& box : bounds_) all_.extendBy(box);
    if (all_.isEmpty()) return;
    inner_ = all_;
    findShell();
    attach();
    findHousings();
}

/// A thin slab along one side of the scene that covers most of it.
ShellSide SceneParts::shellSide(const Box3& box) const {
    const Vec3 extent = all_.size(), size = box.size();
    for (const auto& s : kSides) {
        const int a = s.axis, b = (a + 1) % 3, c = (a + 2) % 3;
        const float fromSide = s.high ? all_.max[a] - box.max[a] : box.min[a] - all_.min[a];
        const bool thin = size[a] <= std::min(kThickestM, 0.3F * extent[a]);
        const bool wide = a == 2 ? size[b] * size[c] >= 0.4F * extent[b] * extent[c]
                                 : size[3 - a - 2] >= 0.6F * extent[3 - a - 2] && size.z >= 0.5F * extent.z;
        if (thin && wide && fromSide <= std::max(kNearSide * extent[a], 0.5F)) return s.side;
    }
    return ShellSide::None;
}

void SceneParts::findShell() {
    const Vec3 extent = all_.size();
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        const auto& box = bounds_[i];
        if (box.isEmpty()) continue;
        const Vec3 size = box.size();
        hulls_[i] = size.x >= 0.85F * extent.x && size.y >= 0.85F * extent.y && size.z >= 0.85F * extent.z ? 1 : 0;
        if (hull(static_cast<std::uint32_t>(i))) continue;
        sides_[i] = shellSide(box);
        if (sides_[i] == ShellSide::None) continue;
        const auto& s = description(sides_[i]);
        if (s.high)
            inner_.max[s.axis] = std::min(inner_.max[s.axis], box.min[s.axis]);
        else
            inner_.min[s.axis] = std::max(inner_.min[s.axis], box.max[s.axis]);
    }
}

/// What is set into a side, or lies on it flat, goes with it: windows, tiles, air outlets, pictures.
void SceneParts::attach() {
    for (const auto& s : kSides) {
        if (s.side == ShellSide::Floor) continue;
        Box3 slab = grown(all_, 0.01F);
        if (s.high)
            slab.min[s.axis] = inner_.max[s.axis] - kOwnDepthM;
        else
            slab.max[s.axis] = inner_.min[s.axis] + kOwnDepthM;
        const bool found = std::find(sides_.begin(), sides_.end(), s.side) != sides_.end();
        for (std::size_t i = 0; found && i < bounds_.size(); ++i)
            if (sides_[i] == ShellSide::None && hulls_[i] == 0 && !bounds_[i].isEmpty() && !scene_->objects[i].movable && within(bounds_[i], slab)) sides_[i] = s.side;
    }
}

void SceneParts::findHousings() {
    for (std::size_t l = 0; l < scene_->luminaires.size(); ++l) {
        const auto& luminaire = scene_->luminaires[l];
        const auto opening = PlacedOpening::of(luminaire, scene_->luminaireTypes[luminaire.type].photometry.opening).bounds();
        const auto near = grown(opening, 0.03F);
        for (std::size_t i = 0; i < bounds_.size(); ++i) {
            if (scene_->objects[i].movable || !bounds_[i].intersects(near)) continue;
            const Vec3 size = bounds_[i].size(), most = opening.size() + Vec3(kHousingM);
            if (size.x <= most.x && size.y <= most.y) luminaires_[i] = static_cast<std::uint32_t>(l);
        }
    }
}

ShellSide SceneParts::side(std::uint32_t mesh, std::uint32_t triangle) const {
    const auto& m = scene_->meshes[mesh];
    if (!hull(m.object)) return sides_[m.object];
    Box3 box;
    for (const auto v : m.triangles[triangle]) box.extendBy(m.positions[v]);
    const Vec3 size = box.size(), extent = all_.size();
    for (const auto& s : kSides) {
        const float near = 0.02F * extent[s.axis];
        const float off = s.high ? all_.max[s.axis] - box.min[s.axis] : box.max[s.axis] - all_.min[s.axis];
        if (off <= near && size[s.axis] <= near) return s.side;
    }
    return ShellSide::None;
}

std::optional<std::uint32_t> SceneParts::luminaireOf(std::uint32_t object) const {
    if (luminaires_[object] == kNoLuminaire) return {};
    return luminaires_[object];
}

std::uint32_t SceneParts::sidesInTheWay(const CameraPose& pose) const {
    std::uint32_t bits = 0;
    if (all_.isEmpty()) return bits;
    for (const auto& s : kSides) {
        const double outwards = s.high ? 1 : -1;
        const double beyond = outwards * (pose.position[s.axis] - double{s.high ? inner_.max[s.axis] : inner_.min[s.axis]});
        const bool inTheWay = pose.parallel ? outwards * pose.direction[s.axis] < -0.2 : beyond > 0;
        if (inTheWay) bits |= 1U << static_cast<unsigned>(s.side);
    }
    return bits;
}

}  // namespace luxdeck::gui

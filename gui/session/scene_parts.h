#pragma once

#include "engine/scene/scene.h"
#include "gui/session/camera_motion.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace luxdeck::gui {

/// A side of the room that may stand in the way when it is looked at from outside.
enum class ShellSide : std::uint8_t { None, Ceiling, Floor, West, East, South, North };
inline constexpr int kShellSides = 7;

/// What the geometry of a scene tells about its objects: which of them are the room's ceiling, floor and outer walls (or are
/// set into them), and which are housings of luminaires. Names are not asked, for every program names things otherwise.
class SceneParts {
public:
    explicit SceneParts(const Scene& scene);

    [[nodiscard]] ShellSide side(std::uint32_t mesh, std::uint32_t triangle) const;
    /// Side of a whole object; None also where its triangles are on several.
    [[nodiscard]] ShellSide sideOfObject(std::uint32_t object) const { return sides_[object]; }
    /// The luminaire that an object is the housing of.
    [[nodiscard]] std::optional<std::uint32_t> luminaireOf(std::uint32_t object) const;
    /// Bounds of an object [m, re-based]; empty for one without triangles.
    [[nodiscard]] const Box3& bounds(std::uint32_t object) const { return bounds_[object]; }
    [[nodiscard]] const Box3& sceneBounds() const { return all_; }

    /// The sides between the camera and the room, a bit (1 << side) each: to be left out so that the inside is seen.
    [[nodiscard]] std::uint32_t sidesInTheWay(const CameraPose& pose) const;

private:
    [[nodiscard]] bool hull(std::uint32_t object) const { return hulls_[object] != 0; }
    [[nodiscard]] ShellSide shellSide(const Box3& box) const;
    void findShell();
    void attach();
    void findHousings();

    const Scene* scene_;
    Box3 all_;
    Box3 inner_;                              // inner faces of the sides that were found; the scene's bounds elsewhere
    std::vector<Box3> bounds_;                // #objects
    std::vector<ShellSide> sides_;            // #objects
    std::vector<std::uint8_t> hulls_;         // #objects: one object is the whole room
    std::vector<std::uint32_t> luminaires_;   // #objects, kNothing: no housing
};

}  // namespace luxdeck::gui

#pragma once

#include "gui/session/gizmo_motion.h"
#include "gui/view3d/view_colours.h"

#include <QPointF>

#include <functional>
#include <optional>
#include <vector>

class QPainter;

namespace luxdeck::gui {

/// The handles of what is selected: arrows along the axes, a square for the plan, a ring to turn. As large on the screen
/// wherever the thing is; painted over the view.
class Gizmo {
public:
    struct Target {
        Vec3d centre{0, 0, 0};   ///< re-based [m]
        bool vertical = false;   ///< may be lifted
        bool turns = false;

        friend bool operator==(const Target&, const Target&) = default;
    };
    using Project = std::function<std::optional<QPointF>(const Vec3d&)>;

    /// project  where a point is seen [pixels]
    explicit Gizmo(Project project) : project_(std::move(project)) {}

    void setTarget(std::optional<Target> target);
    [[nodiscard]] const std::optional<Target>& target() const { return target_; }
    /// metresPerPixel  at the target's depth
    void setScale(double metresPerPixel) { sizeM_ = kSizePixels * metresPerPixel; }
    [[nodiscard]] Handle handleAt(QPointF pixel) const;
    /// A place on a handle [pixels], for pointing at it.
    [[nodiscard]] std::optional<QPointF> placeOf(Handle handle) const;
    /// The handle under the cursor stands out. Returns whether that changes the picture.
    bool setHot(Handle handle);

    void begin(Handle handle, const SightLine& line);
    [[nodiscard]] bool dragging() const { return held_ != Handle::None; }
    [[nodiscard]] GizmoMotion drag(const SightLine& line, const Snapping& snapping);
    GizmoMotion end();

    void paint(QPainter& painter, const ViewColours& colours) const;

private:
    static constexpr double kSizePixels = 74;

    [[nodiscard]] std::vector<Handle> handles() const;
    [[nodiscard]] Vec3d centre() const { return target_->centre + motion_.moveM; }
    [[nodiscard]] std::vector<QPointF> ring() const;
    [[nodiscard]] std::vector<QPointF> square() const;

    Project project_;
    std::optional<Target> target_;
    double sizeM_ = 1;
    Handle hot_ = Handle::None, held_ = Handle::None;
    SightLine start_{};
    GizmoMotion motion_;
};

}  // namespace luxdeck::gui

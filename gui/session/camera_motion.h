#pragma once

#include "engine/io/project.h"

#include <optional>
#include <string>

namespace luxdeck::gui {

/// A place in a view: -1 .. 1 from its left to its right edge, and from the bottom to the top.
struct ScreenPoint {
    double x = 0, y = 0;
};

/// How a view looks into the scene, in its re-based coordinates [m]. Everything below is mathematics on it: no view, no
/// mouse. `aspect` is always the view's width over its height.
struct CameraPose {
    Vec3d position{0, -10, 4};
    Vec3d direction{0, 1, 0};      ///< unit
    Vec3d up{0, 0, 1};             ///< unit, across the direction
    double fovDeg = 45;            ///< vertical
    bool parallel = false;         ///< no perspective: plans and elevations
    double heightM = 10;           ///< of what is seen, when parallel

    [[nodiscard]] Vec3d right() const { return direction.cross(up); }
    friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

struct SightLine {
    Vec3d origin, direction;  ///< [m], unit
};

/// What lies under a place of the view.
SightLine sightLine(const CameraPose& pose, double aspect, ScreenPoint at);
/// Where a point is seen; none: behind the camera.
std::optional<ScreenPoint> seenAt(const CameraPose& pose, double aspect, const Vec3d& point);
/// Depth of a point along the view direction [m].
double depthOf(const CameraPose& pose, const Vec3d& point);
/// How many metres at that depth one unit of ScreenPoint::y stands for.
double metresPerUnit(const CameraPose& pose, double depthM);

/// Turned about a point, which stays where it is seen: about the vertical and then about the camera's right. The camera
/// never stands on its head.
CameraPose orbited(const CameraPose& pose, const Vec3d& about, double turnDeg, double tiltDeg);
/// Shifted across the direction, so that the point under `from` comes to `to`.
CameraPose panned(const CameraPose& pose, double aspect, const Vec3d& point, ScreenPoint to);
/// Closer to a point (factor < 1) or farther from it, by this factor of its distance; the direction is kept, and so the
/// point stays where it is seen. Ward & Simmons 1999, "The holodeck ray cache", 2.4.1: 0.9 a frame.
CameraPose approached(const CameraPose& pose, double aspect, const Vec3d& point, double factor);
/// Looks elsewhere from where it stands.
CameraPose lookedAround(const CameraPose& pose, double turnDeg, double tiltDeg);
/// Walks: forward and right stay level, up is up [m].
CameraPose walked(const CameraPose& pose, double forwardM, double rightM, double upM);
/// Stands upright (no roll).
CameraPose upright(const CameraPose& pose);

enum class Side { Top, Bottom, Front, Back, Left, Right, Iso };

/// The whole box in the view, looked at in the same direction.
CameraPose fitted(const CameraPose& pose, double aspect, const Box3& box);
/// The whole box from one side: parallel, but for Iso, which looks down at it from the south-west in perspective.
CameraPose lookingFrom(Side side, double aspect, const Box3& box);

/// A view of the project as a camera, and back (in user coordinates, with the size of the picture).
CameraPose poseOf(const View& view, const Scene& scene);
View viewOf(const CameraPose& pose, const Scene& scene, const std::string& name, int width, int height);

}  // namespace luxdeck::gui

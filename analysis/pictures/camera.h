#pragma once

#include "engine/io/project.h"
#include "engine/raycast/raycaster.h"

#include <optional>

namespace luxdeck {

/// The rays of a view. Perspective: a pinhole; fisheye: angular (r proportional to theta), 180 degrees in
/// the largest circle that fits.
class Camera {
public:
    Camera(const View& view, const Scene& scene);

    /// The ray through a point of the picture, in pixels from the top left; none outside a fisheye's circle.
    [[nodiscard]] std::optional<Ray> ray(float x, float y) const;

private:
    ViewKind kind_;
    Vec3 position_;
    Vec3 forward_, right_, up_;
    float width_, height_;
    float halfHeight_;  // tangent of half the vertical angle of view
};

}  // namespace luxdeck

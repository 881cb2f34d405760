#include "analysis/pictures/camera.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

Camera::Camera(const View& view, const Scene& scene)
    : kind_(view.kind), position_(scene.toRebased(view.position)), forward_(Vec3(view.direction.normalized())),
      width_(static_cast<float>(view.width)), height_(static_cast<float>(view.height)),
      halfHeight_(static_cast<float>(std::tan(view.verticalFovDeg * kDegree / 2))) {
    Vec3d right = view.direction.cross(view.up);
    if (!(right.length() > 1e-9)) right = Vec3d(Frame::about(forward_).tangent);  // looking along "up"
    right_ = Vec3(right.normalized());
    up_ = cross(right_, forward_);
}

std::optional<Ray> Camera::ray(float x, float y) const {
    Ray ray;
    ray.origin = position_;
    if (kind_ == ViewKind::Perspective) {
        const float px = (2 * x - width_) / height_ * halfHeight_, py = (height_ - 2 * y) / height_ * halfHeight_;
        ray.direction = (forward_ + right_ * px + up_ * py).normalized();
        return ray;
    }
    const float radius = 0.5F * std::min(width_, height_);
    const float dx = (x - 0.5F * width_) / radius, dy = (0.5F * height_ - y) / radius;
    const float r = std::sqrt(dx * dx + dy * dy);
    if (r > 1) return std::nullopt;
    const float theta = r * kPi / 2;
    const float s = r > 0 ? std::sin(theta) / r : 0;
    ray.direction = (forward_ * std::cos(theta) + right_ * (dx * s) + up_ * (dy * s)).normalized();
    return ray;
}

}  // namespace luxdeck

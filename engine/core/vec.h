#pragma once

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <cmath>
#include <numbers>

namespace luxdeck {

using Vec2 = Imath::V2f;
using Vec3 = Imath::V3f;
using Vec3d = Imath::V3d;
using Matrix4d = Imath::M44d;  ///< row vectors: p' = p * M, Imath's convention
using Box3 = Imath::Box3f;
using Box3d = Imath::Box3d;

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr double kPiD = std::numbers::pi_v<double>;
inline constexpr double kDegree = kPiD / 180.0;

inline float dot(const Vec3& a, const Vec3& b) { return a.dot(b); }
inline Vec3 cross(const Vec3& a, const Vec3& b) { return a.cross(b); }

inline bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool isFinite(const Vec3d& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A right-handed orthonormal frame: tangent, bitangent, normal.
struct Frame {
    Vec3 tangent{1, 0, 0};
    Vec3 bitangent{0, 1, 0};
    Vec3 normal{0, 0, 1};

    /// The frame about a unit normal. Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
    static Frame about(const Vec3& n) {
        const float sign = std::copysign(1.0F, n.z);
        const float a = -1.0F / (sign + n.z);
        const float b = n.x * n.y * a;
        return {{1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x},
                {b, sign + n.y * n.y * a, -n.y},
                n};
    }

    [[nodiscard]] Vec3 toWorld(const Vec3& local) const {
        return tangent * local.x + bitangent * local.y + normal * local.z;
    }
    [[nodiscard]] Vec3 toLocal(const Vec3& world) const {
        return {dot(world, tangent), dot(world, bitangent), dot(world, normal)};
    }
};

}  // namespace luxdeck

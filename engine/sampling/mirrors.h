#pragma once

#include "engine/core/vec.h"
#include "engine/sampling/light_sampler.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace luxdeck {

inline constexpr std::uint32_t kNoMirror = std::numeric_limits<std::uint32_t>::max();

/// One flat mirror or pane: all triangles of one specular material in one plane.
struct FlatMirror {
    Vec3 normal{0, 0, 1};     // unit
    float offset = 0;         // dot(normal, p) of its points [m]
    MirrorFrame frame;        // the rectangle that holds its triangles
    float importance = 0;     // area times reflectance [m^2]

    [[nodiscard]] Vec3 mirrored(const Vec3& p) const { return p - normal * (2 * (dot(normal, p) - offset)); }
    [[nodiscard]] Vec3 turned(const Vec3& direction) const { return direction - normal * (2 * dot(normal, direction)); }
    [[nodiscard]] Receiver mirrored(const Receiver& at) const { return {mirrored(at.position), turned(at.normal), at.glossy}; }
};

/// The flat mirrors and panes of a scene, in which lamps show mirrored images. A receiver looks for light by way
/// of them as if it stood behind them.
class Mirrors {
public:
    Mirrors() = default;
    Mirrors(const Scene& scene, const SceneNeeds& needs);

    [[nodiscard]] bool empty() const { return mirrors_.empty(); }
    [[nodiscard]] const std::vector<FlatMirror>& all() const { return mirrors_; }
    /// The mirror that a triangle is a part of, kNoMirror for most.
    [[nodiscard]] std::uint32_t of(std::uint32_t mesh, std::uint32_t triangle) const {
        return mesh < ofTriangle_.size() && !ofTriangle_[mesh].empty() ? ofTriangle_[mesh][triangle] : kNoMirror;
    }
    /// One of them, by importance.
    struct Choice {
        std::uint32_t mirror;
        float probability;
    };
    [[nodiscard]] Choice choose(float u) const;

private:
    std::vector<FlatMirror> mirrors_;
    std::vector<float> sums_;                             // of importance
    std::vector<std::vector<std::uint32_t>> ofTriangle_;  // by mesh; empty for those that mirror nothing
};

}  // namespace luxdeck

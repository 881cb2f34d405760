#pragma once

#include "engine/transport/radiance_estimator.h"

#include <array>

namespace luxdeck {

/// The solids that a point lies in, outermost first: glass around water and the like. What lies around the
/// outermost is air. Solids must be closed, and one inside another must lie wholly inside it.
class Media {
public:
    /// More solids inside each other than this are not followed.
    static constexpr std::size_t kDeepest = 8;

    [[nodiscard]] bool inAir() const { return depth_ == 0; }
    /// Index of refraction of the innermost.
    [[nodiscard]] float ior() const { return inAir() ? 1.0F : solids_[depth_ - 1]->ior; }
    /// Index of refraction on the other side of the innermost solid of this material: what a ray that meets its
    /// surface from inside goes out to. When the point lies in none: of what it lies in.
    [[nodiscard]] float iorAround(const Material& material) const;
    /// What a way of this length inside lets through; all of it in air [-].
    [[nodiscard]] Rgb transmittance(float lengthM) const;

    /// false: too deep
    [[nodiscard]] bool enter(const Material& material);
    void leave(const Material& material);

private:
    /// One past the place of the innermost solid of this material; 0: there is none.
    [[nodiscard]] std::size_t find(const Material& material) const;

    std::array<const Material*, kDeepest> solids_{};
    std::size_t depth_ = 0;
};

/// The solids around a point, found along one ray to infinity: what it leaves more often than it enters.
Media mediaAt(const TransportScene& scene, const Vec3& position, TransportCounters& counters);

/// The same, remembered while the point stays the same: a batch asks mostly at one.
class MediaFinder {
public:
    explicit MediaFinder(const TransportScene& scene) : scene_(scene) {}
    const Media& at(const Vec3& position, TransportCounters& counters);

private:
    const TransportScene& scene_;
    Vec3 position_{0, 0, 0};
    Media media_;
    bool known_ = false;
};

}  // namespace luxdeck

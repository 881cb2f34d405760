#pragma once

#include "engine/core/vec.h"
#include "engine/sampling/receiver.h"
#include "engine/sampling/sky_map.h"
#include "engine/scene/scene.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace luxdeck {

/// A ray that asks what hides the sky.
struct SkyRay {
    Vec3 origin{0, 0, 0};
    Vec3 direction{0, 0, 1};
    float most = 0;               // how far to look [m]; infinite: as far as the sky
};

/// What an opaque surface that a SkyRay met looks like.
struct SkyObstacle {
    float distance = 0;           // [m]; infinite: none
    Vec3 normal{0, 0, 1};         // unit, towards the ray's origin
};

/// Where the sky may be seen from, for those who cannot trace rays themselves. Constant, safe to share.
class SkyVisibility {
public:
    virtual ~SkyVisibility() = default;
    /// hidden[i] becomes 1 where something opaque lies on rays[i]; both #R.
    virtual void hidden(std::span<const SkyRay> rays, std::span<std::uint8_t> hidden) const = 0;
    [[nodiscard]] virtual SkyObstacle nearest(const SkyRay& ray) const = 0;
};

/// Which way a receiver looks, as far as the tables tell: along one of the axes, or anyhow.
enum class Facing : std::uint32_t { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ, Any };
inline constexpr std::uint32_t kFacings = 7;
Facing facingOf(const Vec3& normal);
/// The unit vector of a facing; zero for Any.
Vec3 axisOf(Facing facing);

/// What the receivers of one cell that face one way see of the sky, roughly.
struct SkyView {
    SkyTable table;
    float lux = 0;                                 // of the visible sky on such a receiver
    std::array<float, 4> sunShare{1, 1, 1, 1};     // of the cell that the first suns reach
};

/// The sky as seen from inside an enclosed part of a scene, cell by cell. A cell is computed when it is first asked
/// for, from a seed of its own: what it holds does not depend on who asked. Its points are taken from surfaces in the
/// cell that face the right way, if there are any: a cell may straddle a wall, and the view from its far side is
/// another.
///
/// memory   2.5 kB for a view; a view is made where light is asked for, typically in a tenth of at most 7 x 8192
/// threads  view() from any number
class SkyCells {
public:
    /// luminances  #SkyMap::kTexels  of the texels [cd/m^2]
    SkyCells(const Scene& scene, std::span<const float> luminances, std::unique_ptr<const SkyVisibility> visibility);
    ~SkyCells();
    SkyCells(const SkyCells&) = delete;
    SkyCells& operator=(const SkyCells&) = delete;

    /// Whether some part of the scene is enclosed enough for cells to help.
    [[nodiscard]] bool useful() const { return count_[0] > 0; }
    /// Null outside the enclosed part.
    [[nodiscard]] const SkyView* view(const Receiver& at) const;
    [[nodiscard]] float cellSizeM() const { return size_; }

private:
    void findEnclosed(const Scene& scene);
    [[nodiscard]] std::unique_ptr<SkyView> compute(std::size_t cell, Facing facing) const;
    [[nodiscard]] std::vector<Vec3> pointsOf(std::size_t cell, Facing facing) const;
    void weighTexels(std::size_t cell, Facing facing, const std::vector<Vec3>& points, SkyView& view) const;
    void weighSuns(Facing facing, const std::vector<Vec3>& points, SkyView& view) const;

    std::vector<float> luminances_;
    std::vector<Vec3> suns_;
    std::unique_ptr<const SkyVisibility> visibility_;
    Vec3 low_{0, 0, 0};
    float size_ = 1;                               // edge of a cell [m]
    std::array<int, 3> count_{0, 0, 0};
    mutable std::vector<std::atomic<const SkyView*>> views_;  // kFacings a cell; null: nobody asked yet
};

}  // namespace luxdeck

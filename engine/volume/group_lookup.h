#pragma once

#include "engine/raycast/raycaster.h"
#include "engine/volume/volume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// VisibleLookup for many points close together, as the vertices of one object are: points in the same sixty-fourth of a
/// cell whose normals have the same main axis are a group, and what its first point sees of the cell's corners holds for
/// all of them. A wall between members of one group is not seen; everything else is as in VisibleLookup.
///
/// find(), then weights() for each point. Nothing is allocated once the largest number of points and groups was met. One
/// object a thread. Volume and raycaster must outlive it.
class GroupLookup {
public:
    /// room  of the volume's scene; null: nothing hides corners (the thesis' plain interpolation)
    GroupLookup(const IrradianceVolume& volume, const Raycaster* room) : volume_(&volume), room_(room) {}

    /// Corners that count for a point, and how much; weights sum to 1, or all are 0 where nothing is known of the point.
    struct Corners {
        const std::uint32_t* vertices = nullptr;  // 8, of the lattice
        std::array<float, 8> weights{};
        bool known = false;
    };

    /// positions [m, re-based], normals (unit), both #P. Depends on them and their order alone.
    void find(std::span<const Vec3> positions, std::span<const Vec3> normals);

    [[nodiscard]] Corners weights(std::size_t point) const;
    [[nodiscard]] std::uint32_t group(std::size_t point) const { return points_[point].group; }
    [[nodiscard]] std::uint32_t cell(std::size_t point) const { return groups_[points_[point].group].cell; }
    [[nodiscard]] std::size_t groupCount() const { return groups_.size(); }
    /// The group's first point.
    [[nodiscard]] std::uint32_t representative(std::size_t group) const { return groups_[group].first; }
    /// Occlusion rays of the last find().
    [[nodiscard]] std::uint64_t rays() const { return rayCount_; }

private:
    static constexpr std::uint32_t kAcross = 4;  // groups along each side of a cell

    struct Point {
        std::uint32_t group = 0;
        Vec3 fraction{0, 0, 0};  // along the sides of its cell
    };
    struct Group {
        std::uint32_t cell = 0;
        std::uint32_t first = 0;
        std::uint8_t seen = 0;                     // a bit for each corner
        bool around = false;                       // no corner is seen: vertices of the cells around count, as they are weighed here
        std::array<std::uint32_t, 8> vertices{};
        std::array<float, 8> weights{};
    };
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t round = 0, group = 0;
    };

    std::uint32_t groupOf(std::uint64_t key, std::uint32_t cell, std::uint32_t point);
    void growTable();
    void traceCorners(std::span<const Vec3> positions, std::span<const Vec3> normals);
    void lookAround(Group& group, const Vec3& from);

    const IrradianceVolume* volume_;
    const Raycaster* room_;
    std::vector<Point> points_;
    std::vector<Group> groups_;
    std::vector<std::uint8_t> traced_;   // of groups
    std::vector<Slot> table_;            // open addressing; slots of earlier rounds are free
    std::uint32_t round_ = 0;
    std::vector<Ray> rays_;
    std::vector<std::uint32_t> rayOf_;   // group * 8 + corner
    std::vector<std::uint8_t> hidden_;
    std::uint64_t rayCount_ = 0;
};

}  // namespace luxdeck

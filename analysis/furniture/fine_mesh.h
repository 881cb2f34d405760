#pragma once

#include "analysis/furniture/movable_object.h"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace luxdeck {

/// Divides triangles until their edges are short enough to carry light, sharing vertices of the same place and normal.
class FineMesh {
public:
    FineMesh(MovableObject& object, double longestEdgeM) : object_(object), longestEdgeM_(longestEdgeM) {}

    /// Appends a mesh of the scene, moved into the object's frame. errors  OutOfResources: too many vertices
    Result<void> add(const Scene& scene, const Mesh& mesh);

private:
    struct Corner {
        Vec3 position{0, 0, 0}, normal{0, 0, 1};
    };
    using Key = std::array<float, 6>;
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };

    std::uint32_t vertex(const Corner& corner, const Rgb& reflectance);
    void divide(const std::array<Corner, 3>& corners, int n, const Rgb& reflectance, bool solid);

    MovableObject& object_;
    double longestEdgeM_;
    std::unordered_map<Key, std::uint32_t, KeyHash> index_;  // of this mesh: materials do not share vertices
    std::vector<std::uint32_t> rows_;
};

/// Fills workingAreaM2 and workingSurfaceM2.
void findWorkingSurface(MovableObject& object);

}  // namespace luxdeck

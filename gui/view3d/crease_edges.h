#pragma once

#include "engine/core/vec.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace luxdeck::gui {

/// Finds the lines that a draughtsman would draw: borders of surfaces, and edges where they bend sharply. Triangles belong
/// together where their corners coincide, whether or not they share vertices.
class CreaseEdges {
public:
    /// normal  of the triangle, unit
    void add(const std::array<Vec3, 3>& corners, const Vec3& normal);
    [[nodiscard]] vtkSmartPointer<vtkPolyData> lines() const;

private:
    struct Edge {
        std::uint32_t from, to;
        Vec3 normal;              // of the first triangle
        bool border = true;       // one triangle alone
        bool sharp = false;
    };
    std::uint32_t cornerAt(const Vec3& position);

    std::unordered_map<std::uint64_t, std::uint32_t> cornerOf_, edgeOf_;
    std::vector<Vec3> corners_;
    std::vector<Edge> edges_;
};

}  // namespace luxdeck::gui

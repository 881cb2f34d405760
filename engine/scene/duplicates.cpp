#include "engine/scene/duplicates.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace luxdeck {

namespace {

using Corner = std::array<float, 3>;
using Corners = std::array<Corner, 3>;

/// The same for triangles of the same corners: in the same order around, or in any where both sides emit.
Corners cornersOf(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, bool eitherSide) {
    Corners out;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& p = mesh.positions[triangle[i]];
        out[i] = {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};  // -0 is 0
    }
    if (eitherSide) std::sort(out.begin(), out.end());
    else std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
    return out;
}

}  // namespace

std::size_t removeCoincidentEmitters(Scene& scene) {
    std::set<Corners> oneSided, twoSided;
    std::size_t removed = 0;
    for (auto& mesh : scene.meshes) {
        const auto& material = scene.materials[mesh.material];
        if (!material.emits()) continue;
        auto& seen = material.oneSidedEmission ? oneSided : twoSided;
        removed += std::erase_if(mesh.triangles, [&](const auto& t) {
            return !seen.insert(cornersOf(mesh, t, !material.oneSidedEmission)).second;
        });
    }
    return removed;
}

}  // namespace luxdeck

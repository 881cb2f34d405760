#include "engine/io/gltf_solid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

namespace luxdeck::gltf {

Shell shellOf(const std::vector<const Primitive*>& primitives) {
    std::map<std::array<float, 3>, std::uint32_t> places;
    std::vector<std::pair<std::uint64_t, int>> edges;  // from lower to higher place; +1 that way, -1 the other
    double volume = 0;                                 // six times what is enclosed
    for (const auto* primitive : primitives)
        for (const auto& triangle : primitive->triangles) {
            std::array<std::uint32_t, 3> at{};
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3& p = primitive->positions[triangle[i]];
                const auto next = static_cast<std::uint32_t>(places.size());
                // + 0 makes one of both zeros
                at[i] = places.try_emplace({p.x + 0.0F, p.y + 0.0F, p.z + 0.0F}, next).first->second;
            }
            if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
            const Vec3d a(primitive->positions[triangle[0]]), b(primitive->positions[triangle[1]]),
                c(primitive->positions[triangle[2]]);
            volume += a.dot(b.cross(c));
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint64_t from = at[i], to = at[(i + 1) % 3];
                edges.emplace_back(std::min(from, to) << 32U | std::max(from, to), from < to ? 1 : -1);
            }
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();) {
        int balance = 0;
        const auto edge = edges[i].first;
        for (; i < edges.size() && edges[i].first == edge; ++i) balance += edges[i].second;
        if (balance != 0) return Shell::Open;
    }
    if (edges.empty() || volume == 0) return Shell::Open;
    return volume > 0 ? Shell::Outward : Shell::Inward;
}

}  // namespace luxdeck::gltf

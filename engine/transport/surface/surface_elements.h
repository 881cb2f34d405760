#pragma once

#include "engine/core/vec.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"
#include "engine/transport/surface/surface_point.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// The matte surfaces of a scene, cut into elements of about one area, each side by itself: 2 k is the front of a piece,
/// 2 k + 1 its back. What reflects nothing has none.
///
/// A triangle is halved across its longest edge until its parts are small enough; where a point lies is found by
/// walking down the same halves, and nothing is stored of them. Triangles much smaller than an element are taken
/// together: those of one mesh that lie in one cell of space and face the same way. No triangle takes more than an
/// eighth of all pieces: a wide ground outdoors leaves some for the room.
///
/// Constant after it was made; the scene must outlive it. memory: 16 bytes a triangle, 16 a piece.
class SurfaceElements {
public:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    /// wanted  pieces, about
    SurfaceElements(const Scene& scene, const SceneNeeds& needs, std::size_t wanted);

    [[nodiscard]] std::size_t size() const { return 2 * areasM2_.size(); }
    [[nodiscard]] float areaM2(std::size_t element) const { return areasM2_[element / 2]; }
    /// The one mesh that it is a part of.
    [[nodiscard]] std::uint32_t mesh(std::size_t element) const { return members_[firstMember_[element / 2]].mesh; }
    /// The element of a point with barycentric weights u, v of the triangle's second and third vertex; kNone: of a
    /// mesh that is never matte, or black.
    [[nodiscard]] std::uint32_t at(std::uint32_t mesh, std::uint32_t triangle, float u, float v, bool front) const;
    /// A point of an element, uniform by area, as a ray meets it from its side.
    [[nodiscard]] SurfacePoint place(std::size_t element, Vec2 u) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Cut {                  // of a triangle
        std::uint32_t first = kNone;  // piece
        std::uint32_t depth = 0;      // how often it is halved
    };
    struct Member {               // a triangle that a piece lies in
        std::uint32_t mesh, triangle;
        float upToM2;             // area of the piece's members up to this one
    };

    void cutLarge(std::span<const double> areasM2, double pieceM2, double most);
    void joinSmall(std::span<const double> areasM2, double pieceM2);
    void addPiece(double areaM2) { areasM2_.push_back(static_cast<float>(areaM2)); }

    const Scene* scene_;
    const SceneNeeds* needs_;
    std::vector<std::uint32_t> firstCut_;     // of each mesh, kNone: it has no elements
    std::vector<Cut> cuts_;                   // by triangle
    std::vector<std::array<std::uint32_t, 2>> triangles_;  // by cut: mesh and triangle
    std::vector<float> areasM2_;              // by piece
    std::vector<std::uint32_t> firstMember_;  // by piece, and one past the last
    std::vector<Member> members_;
};

}  // namespace luxdeck

#pragma once

#include "analysis/furniture/movable_object.h"
#include "engine/raycast/raycaster.h"
#include "engine/volume/directions.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace luxdeck {

/// An object as a scene of its own, in its own frame, to be asked for what it hides.
///
/// errors  OutOfResources
class ObjectRays {
public:
    static Result<ObjectRays> create(const MovableObject& object);

    [[nodiscard]] const Raycaster& raycaster() const { return *raycaster_; }
    /// The vertex of the object nearest to where a ray met it.
    [[nodiscard]] std::uint32_t vertexAt(const Hit& hit) const;

private:
    std::unique_ptr<Scene> scene_;  // solid triangles; the raycaster refers to it
    std::unique_ptr<Raycaster> raycaster_;
};

/// How the object hides the world from its own vertices, and what they see of it instead: found once, in its own frame,
/// by cosine-distributed rays (thesis 5.1.3 and 6.1.3; kept by directions, so that light from a side that is hidden
/// counts less than light from one that is open).
///
/// Left out: what lies between the 72 directions (a lamp is spread over 17 degrees where something is hidden); light that
/// reached its own parts by more than one reflection; panes of the object hide nothing.
class SelfShade {
public:
    static constexpr int kSide = 6;           // of the bins: 72 directions
    static constexpr int kBins = 2 * kSide * kSide;
    static constexpr std::uint32_t kRays = 128;  // for each vertex
    static constexpr std::size_t kLinks = 16;
    static constexpr std::uint32_t kOpen = 0xffffffffU;

    /// Of a vertex that does not see everything.
    struct Row {
        std::array<std::uint8_t, kBins> all{};     // rays that went there
        std::array<std::uint8_t, kBins> hidden{};  // of them: met the object
        float hiddenPart = 0;                      // cosine-weighted
        std::uint8_t linkCount = 0;
        std::array<std::uint32_t, kLinks> links{}; // vertices that it sees instead, each for an equal part of hiddenPart;
                                                   // kOpen: a back, which is dark
    };

    SelfShade(const MovableObject& object, const ObjectRays& rays);

    /// Null: the vertex sees the whole hemisphere.
    [[nodiscard]] const Row* row(std::uint32_t vertex) const { return index_[vertex] == kOpen ? nullptr : &rows_[index_[vertex]]; }
    [[nodiscard]] std::size_t shadedVertices() const { return rows_.size(); }

private:
    std::vector<std::uint32_t> index_;  // #V into rows_, kOpen
    std::vector<Row> rows_;
};

}  // namespace luxdeck

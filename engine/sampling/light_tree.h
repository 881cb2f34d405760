#pragma once

#include "engine/core/vec.h"
#include "engine/sampling/receiver.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace luxdeck {

/// One light as the tree sees it: a luminaire, or an emitting triangle.
struct TreeLight {
    Vec3 centre{0, 0, 0};
    Vec3 half{0, 0, 0};        // half extents of its bounds, along the world's axes [m]
    Frame frame;               // in which its directional map is written
    std::uint32_t map = 0;     // index of that map
    float scale = 1;           // of the map's intensities
    float power = 0;           // flux, for the defensive part, > 0 [lm]
};

/// A hierarchy over lights that chooses one by how much it may give to a receiver, in time that grows with the
/// logarithm of their number.
///
/// Every node has up to eight children, and of each of these knows bounds, flux and a coarse map of the intensity
/// that it sends into each direction of the world. A descent weighs the children of a node, takes one in proportion
/// and goes on with what is left of its one random number. The maps take the place of the cone of normals in the
/// usual tree: luminaires differ by their distribution more than by their orientation.
///
/// A child's importance is the intensity towards the receiver, over the product of the distances to its nearest and
/// farthest point (which is what 1/d^2 times a lamp's own cosine averages to over a plane of lamps; the distance to
/// the centre alone starves the lamps straight above a receiver inside a large node), times the largest cosine that
/// its bounds allow. A small part of every choice goes by flux: no light's chance is zero, whatever the maps say.
///
/// Constant after it was made; safe to share between threads.
/// Source: Conty Estevez & Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting".
class LightTree {
public:
    static constexpr int kMapSide = 32;   // of the lights' own maps
    static constexpr int kNodeSide = 8;   // of the nodes' maps

    LightTree() = default;
    /// lights  #L >= 1, with the power that their maps integrate to
    /// maps    #M x kMapSide^2  octahedral, intensity by direction in the lights' frames [cd]
    LightTree(std::span<const TreeLight> lights, std::vector<float> maps);

    struct Draw {
        std::uint32_t light;
        float probability;
    };
    /// u in [0, 1). A float has 2^24 steps: a light of probability 1e-6 is chosen as stated to 6 %, and one light of
    /// a million matters no more than that.
    [[nodiscard]] Draw draw(const Receiver& at, float u) const;
    /// The probability with which draw() chooses this light: the same products, from the leaf to the root.
    [[nodiscard]] float probability(const Receiver& at, std::uint32_t light) const;

    /// How draws at one receiver may be made without the tree: every light weighed by itself. sums[k] is the chance
    /// of the first k + 1 lights in the tree's own order. O(#L): for receivers that are asked many times.
    [[nodiscard]] std::vector<float> weighAll(const Receiver& at) const;
    [[nodiscard]] Draw draw(std::span<const float> sums, float u) const;

    [[nodiscard]] std::size_t size() const { return slotOfLight_.size(); }
    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    [[nodiscard]] std::size_t bytes() const;

private:
    static constexpr std::uint32_t kWidth = 8;
    static constexpr std::size_t kNodeTexels = std::size_t{kNodeSide} * kNodeSide;

    /// A node's children, a row for each number, so that weighing them becomes vector instructions. Rows beyond
    /// the last child weigh nothing.
    struct Node {
        using Row = std::array<float, kWidth>;
        Row x{}, y{}, z{};              // centre of the bounds [m]
        Row hx{}, hy{}, hz{};           // half extents [m]
        Row extent{};                   // 1: the nearest and the farthest point count; 0: a light, its centre does
        Row least2{};                   // squared distances are not taken below this [m^2]
        Row tx{}, ty{}, tz{}, bx{}, by{}, bz{}, nx{}, ny{}, nz{};  // axes of its map's frame
        Row scale{};                    // of its map
        Row side{};                     // of its map [texels]
        Row powerShare{};               // of the node's flux
        std::array<std::int32_t, kWidth> map{};   // first texel in maps_
        std::array<std::uint32_t, kWidth> link{}; // the node below, or kLeaf and the light
        std::uint32_t count = 0;
        std::uint32_t above = 0;        // the node that this is a child of, and which: kWidth * node + child
    };
    static constexpr std::uint32_t kLeaf = 0x80000000U;
    using Shares = std::array<float, kWidth>;

    /// A run of lights in the order of the tree while it is built.
    struct Run {
        std::uint32_t first = 0, last = 0;
        Vec3 low{0, 0, 0}, high{0, 0, 0};
        double power = 0;
        [[nodiscard]] std::uint32_t count() const { return last - first; }
        [[nodiscard]] double cost() const;
    };
    /// What a subtree sends out: a node map, shared by all that look alike, and its scale.
    struct Emission {
        std::uint32_t map = 0;
        double scale = 0;
    };
    struct Building;

    Emission build(Building& work, const Run& run, std::uint32_t above);
    [[nodiscard]] static Run runOf(const Building& work, std::uint32_t first, std::uint32_t last);
    static std::vector<Run> parts(Building& work, const Run& run);
    static std::array<Run, 2> split(Building& work, const Run& run);
    Emission leafEmission(Building& work, const TreeLight& light);
    Emission together(std::span<const Emission> parts);
    void addFloor(std::size_t map);
    static void place(Node& node, std::uint32_t i, const Run& run, const Frame& frame, bool leaf);
    [[nodiscard]] Shares importances(const Node& node, const Receiver& at) const;
    [[nodiscard]] Shares shares(const Node& node, const Receiver& at) const;

    std::vector<Node> nodes_;                  // the root first
    std::vector<std::uint32_t> slotOfLight_;   // #L, kWidth * node + child
    std::vector<std::uint32_t> leaves_;        // #L, the lights as they come node after node
    std::vector<float> leafPowers_;            // #L, their shares of all flux
    std::vector<float> maps_;                  // of the lights; then of the nodes, in the world's directions
};

}  // namespace luxdeck

#include "engine/io/gltf_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::gltf {

namespace {

constexpr std::int64_t kNoParent = -1;

Matrix4d localMatrix(const JsonView& node) {
    if (const auto json = node["matrix"]; json.present()) {
        // Columns one after the other for column vectors are rows one after the other for row vectors.
        const auto m = json.numbers<16>({});
        Matrix4d matrix;
        for (std::size_t i = 0; i < 16; ++i) matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = m[i];
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) json.fail("has a last row other than 0 0 0 1");
        return matrix;
    }
    const auto t = node["translation"].numbers<3>({0, 0, 0});
    const auto s = node["scale"].numbers<3>({1, 1, 1});
    const auto matrix = nodeMatrix(t, node["rotation"].numbers<4>({0, 0, 0, 1}), s);
    if (!matrix) node["rotation"].fail("is a quaternion without length");
    return matrix.value_or(Matrix4d());
}

bool isVisible(const JsonView& node) { return node.extension("KHR_node_visibility")["visible"].flag(true); }

/// The children of every node, after checking that each has one parent at most.
std::vector<std::vector<std::size_t>> readChildren(Document& document, std::vector<std::int64_t>& parents) {
    const auto nodes = document.root()["nodes"];
    std::vector<std::vector<std::size_t>> children(nodes.size());
    parents.assign(nodes.size(), kNoParent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto list = nodes.at(i)["children"];
        for (std::size_t c = 0; c < list.size(); ++c) {
            const auto child = list.at(c).index(nodes.size(), "nodes");
            if (document.failure.failed()) return children;
            auto& parent = parents[static_cast<std::size_t>(child)];
            if (parent != kNoParent) {
                list.at(c).fail(fmt::format("is {}, which is already a child of nodes[{}]", child, parent));
                return children;
            }
            parent = static_cast<std::int64_t>(i);
            children[i].push_back(static_cast<std::size_t>(child));
        }
    }
    return children;
}

/// With one parent each, nodes that no parentless node leads to stand on a ring, or below one.
void refuseRings(Document& document, const std::vector<std::vector<std::size_t>>& children,
                 const std::vector<std::int64_t>& parents) {
    std::vector<std::size_t> open;
    std::vector<bool> reached(parents.size(), false);
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] == kNoParent) open.push_back(i);
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        reached[node] = true;
        open.insert(open.end(), children[node].begin(), children[node].end());
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost == reached.end()) return;
    // Up from a lost node the way ends in the ring: the first node met twice is on it.
    auto node = static_cast<std::size_t>(lost - reached.begin());
    while (!reached[node]) {
        reached[node] = true;
        node = static_cast<std::size_t>(parents[node]);
    }
    const auto nodes = document.root()["nodes"];
    nodes.at(node).fail(fmt::format("node '{}' is recursive: it is its own ancestor, through nodes[{}]",
                                    nodeName(nodes.at(node)), parents[node]));
}

/// The root nodes of the scene to show.
std::vector<std::size_t> roots(Document& document, const std::vector<std::int64_t>& parents) {
    const auto root = document.root();
    const auto scenes = root["scenes"];
    const auto nodes = root["nodes"];
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < scenes.size(); ++i) (void)scenes.at(i)["name"].text();
    const auto wanted = root["scene"].index(scenes.size(), "scenes", false);
    if (document.failure.failed()) return result;
    if (scenes.size() == 0) {  // a library of nodes: everything is shown
        for (std::size_t i = 0; i < parents.size(); ++i)
            if (parents[i] == kNoParent) result.push_back(i);
        return result;
    }
    if (scenes.size() > 1)
        document.warnings.add(fmt::format("the file has {} scenes: scene {} is read", scenes.size(), std::max<std::int64_t>(wanted, 0)));
    const auto list = scenes.at(static_cast<std::size_t>(std::max<std::int64_t>(wanted, 0)))["nodes"];
    std::vector<bool> taken(parents.size(), false);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto node = list.at(i).index(nodes.size(), "nodes");
        if (document.failure.failed()) return result;
        const auto at = static_cast<std::size_t>(node);
        if (parents[at] != kNoParent || taken[at]) {
            list.at(i).fail(fmt::format("is {}, which is not a root node or is listed twice", node));
            return result;
        }
        taken[at] = true;
        result.push_back(at);
    }
    return result;
}

}  // namespace

std::optional<Matrix4d> nodeMatrix(const std::array<double, 3>& t, const std::array<double, 4>& q,
                                   const std::array<double, 3>& s) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 0)) return std::nullopt;
    const double x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
    // Row vectors: the transpose of the usual matrix.
    const Matrix4d rotation(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0,
                            2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0,
                            2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0,
                            0, 0, 0, 1);
    const Matrix4d scale(s[0], 0, 0, 0, 0, s[1], 0, 0, 0, 0, s[2], 0, 0, 0, 0, 1);
    const Matrix4d translation(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, t[0], t[1], t[2], 1);
    return scale * rotation * translation;
}

std::string nodeName(const JsonView& node) { return node["name"].text(node.path()); }

std::vector<PlacedNode> placeNodes(Document& document, const Matrix4d& placement) {
    std::vector<PlacedNode> placed;
    std::vector<std::int64_t> parents;
    const auto children = readChildren(document, parents);
    if (document.failure.failed()) return placed;
    refuseRings(document, children, parents);
    if (document.failure.failed()) return placed;
    const auto nodes = document.root()["nodes"];
    for (const auto root : roots(document, parents))
        placed.push_back({root, localMatrix(nodes.at(root)) * placement, isVisible(nodes.at(root))});
    for (std::size_t i = 0; i < placed.size() && !document.failure.failed(); ++i)
        for (const auto child : children[placed[i].node])
            placed.push_back({child, localMatrix(nodes.at(child)) * placed[i].world,
                              isVisible(nodes.at(child)) && placed[i].visible});
    return placed;
}

}  // namespace luxdeck::gltf

#include "engine/io/panorama_nodes.h"

#include "engine/core/file.h"
#include "engine/io/toml_reader.h"

#include <fmt/format.h>

#include <array>

namespace luxdeck {

namespace {

constexpr std::array<std::string_view, 2> kRootKeys{"default", "node"};
constexpr std::array<std::string_view, 3> kNodeKeys{"position", "picture", "latitude"};
constexpr TomlSection kRoot{"top level", kRootKeys};
constexpr TomlSection kNode{"[[node]]", kNodeKeys};
constexpr NumberRange kLatitude{.low = -90, .high = 90};
constexpr NumberRange kLuminance{.low = 0, .high = 1e10};
constexpr std::uint64_t kMostBytes = 1U << 24;

PanoramaNode readNode(const TomlTable& table, const std::filesystem::path& folder) {
    PanoramaNode node;
    node.position = table.vector("position");
    const std::filesystem::path picture = table.text("picture");
    node.picture = picture.is_absolute() ? picture : folder / picture;
    if (!table.has("latitude")) return node;
    const auto range = table.numbers("latitude", 2, kLatitude);
    if (range.size() != 2) return node;
    node.lowestDeg = range[0], node.highestDeg = range[1];
    if (!(node.lowestDeg < node.highestDeg))
        table.error(ErrorCode::InvalidArgument, "latitude", fmt::format("latitude is [{}, {}], expected the lower one first", range[0], range[1]));
    return node;
}

}  // namespace

Result<PanoramaNodes> parsePanoramaNodes(std::string_view bytes, const std::filesystem::path& name) {
    Diagnostics diagnostics;
    const auto document = TomlDocument::parse(bytes, name.string(), diagnostics);
    if (!document) return document.error();
    const auto root = document->root(kRoot);
    PanoramaNodes out;
    out.defaultCdM2 = root.number("default", kLuminance, 0);
    root.each("node", kNode, [&](const TomlTable& table) { out.nodes.push_back(readNode(table, name.parent_path())); });
    if (diagnostics.first()) return *diagnostics.first();
    if (out.nodes.empty()) return Error{ErrorCode::InvalidArgument, "no [[node]], expected one for each picture", name.string()};
    return out;
}

Result<PanoramaNodes> readPanoramaNodes(const std::filesystem::path& file) {
    const auto bytes = readFile(file, kMostBytes);
    if (!bytes) return bytes.error();
    return parsePanoramaNodes(*bytes, file);
}

}  // namespace luxdeck

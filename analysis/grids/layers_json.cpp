#include "analysis/grids/layers.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>

namespace luxdeck {

namespace {

constexpr std::size_t kNumbers = 2 * kReplicates;  // of one layer at one point: direct, then indirect

/// Means with nine digits: 5e-10 of each, far below what any interval tells apart.
void appendPoint(std::string& text, const PointSums& point, std::size_t layers) {
    text += fmt::format("{{\"perReplicate\":{},\"backFaces\":{},\"rejected\":{},", point.perReplicate, point.backFaces,
                        point.rejected);
    // Of the whole point, whatever is dimmed: what was not seen may belong to any of its lights.
    const double unseen = point.unseen();
    if (unseen > 0)
        text += fmt::format("\"unseen\":{},", std::isfinite(unseen) ? fmt::format("{:.9g}", unseen) : "null");
    text += "\"layers\":[";
    for (std::size_t layer = 0; layer < layers; ++layer) {
        text += layer > 0 ? ",\n[" : "[";
        const auto own = point.layers.empty() ? std::span<const double>{} : std::span(point.layers).subspan(layer * kNumbers, kNumbers);
        const bool dark = std::all_of(own.begin(), own.end(), [](double x) { return x == 0; });
        for (std::size_t i = 0; i < own.size() && !dark; ++i)
            fmt::format_to(std::back_inserter(text), "{}{:.9g}", i > 0 ? "," : "", own[i] / point.perReplicate);
        text += "]";
    }
    text += "]}";
}

/// Throws std::runtime_error or nlohmann's exceptions with what was seen.
PointSums pointOf(const nlohmann::json& json, std::size_t layers) {
    PointSums point;
    point.perReplicate = json.at("perReplicate").get<std::uint32_t>();
    point.backFaces = json.at("backFaces").get<std::uint64_t>(), point.rejected = json.at("rejected").get<std::uint64_t>();
    if (const auto unseen = json.find("unseen"); unseen != json.end()) {
        const double lux = unseen->is_null() ? std::numeric_limits<double>::infinity() : unseen->get<double>();
        if (!(lux >= 0)) throw std::runtime_error(fmt::format("what was not seen is {}, expected 0 lx or more", lux));
        point.lost = lux * static_cast<double>(point.samples());
    }
    const auto& rows = json.at("layers");
    if (rows.size() != layers) throw std::runtime_error(fmt::format("a point has {} layers, expected {}", rows.size(), layers));
    point.layers.assign(layers * kNumbers, 0.0);  // no sooner: what is taken must be there to be filled
    for (std::size_t layer = 0; layer < layers; ++layer) {
        const auto& row = rows[layer];
        if (!row.empty() && row.size() != kNumbers)
            throw std::runtime_error(fmt::format("a layer has {} numbers, expected none or {}", row.size(), kNumbers));
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double mean = row[i].get<double>();
            if (!(mean >= 0 && mean < 1e30)) throw std::runtime_error(fmt::format("a mean is {}, expected 0 .. 1e30 lx", mean));
            point.layers[layer * kNumbers + i] = mean * point.perReplicate;
        }
    }
    return point;
}

}  // namespace

std::string layersJson(const LayeredSums& layers) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const auto& layer : layers.layers) names.push_back({{"name", layer.name}, {"dimming", layer.dimming}});
    std::string text = fmt::format("{{\"schema\":\"luxdeck-layers/1\",\"sceneHash\":\"{}\",\"replicates\":{},\n\"layers\":{},\n\"points\":[\n", layers.sceneHash,
                                   kReplicates, names.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    for (std::size_t i = 0; i < layers.points.size(); ++i) {
        if (i > 0) text += ",\n";
        appendPoint(text, layers.points[i], layers.layers.size());
    }
    return text + "]}\n";
}

Result<LayeredSums> readLayersJson(const std::string& text, const std::string& where) {
    try {
        const auto json = nlohmann::json::parse(text);
        if (const auto schema = json.at("schema").get<std::string>(); schema != "luxdeck-layers/1")
            return Error{ErrorCode::Parse, fmt::format("schema is \"{}\", expected \"luxdeck-layers/1\"", schema), where};
        if (const auto replicates = json.at("replicates").get<int>(); replicates != kReplicates)
            return Error{ErrorCode::Parse, fmt::format("{} replicates, expected {}", replicates, kReplicates), where};
        LayeredSums out;
        out.sceneHash = json.at("sceneHash").get<std::string>();
        for (const auto& layer : json.at("layers")) {
            out.layers.push_back({layer.at("name").get<std::string>(), layer.at("dimming").get<double>()});
            if (!(out.layers.back().dimming > 0))
                return Error{ErrorCode::Parse, fmt::format("dimming of layer \"{}\" is {}, expected more than 0", out.layers.back().name, out.layers.back().dimming), where};
        }
        for (const auto& point : json.at("points")) out.points.push_back(pointOf(point, out.layers.size()));
        return out;
    } catch (const std::exception& e) {
        return Error{ErrorCode::Parse, fmt::format("not a file of layers: {}", e.what()), where};
    }
}

}  // namespace luxdeck

#include "engine/volume/volume_header.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace luxdeck {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "luxdeck-volume/1";

template <class V>
Json vector(const V& v) {
    return Json::array({v.x, v.y, v.z});
}

Json boxJson(const Box3& box) { return box.isEmpty() ? Json(nullptr) : Json{{"min", vector(box.min)}, {"max", vector(box.max)}}; }

Json settingsJson(const VolumeSettings& s) {
    return {{"firstLevel", s.firstLevel}, {"secondLevel", s.secondLevel}, {"refineBelow", s.refineBelow}, {"refineDepth", s.refineDepth},
            {"bounds", boxJson(s.bounds)}, {"insetM", s.insetM}, {"side", s.side}, {"sampling", s.sampling == BinSampling::Centres ? "centres" : "spread"},
            {"sources", s.sources == SourceSampling::InBins ? "bins" : "sought"}, {"samplesPerBin", s.samplesPerBin},
            {"lightSamples", s.lightSamples}, {"ignored", s.ignored}, {"ignoredCdM2", s.ignoredCdM2}};
}

Vec3d vec3(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

Box3 boxOf(const Json& j) { return j.is_null() ? Box3{} : Box3(Vec3(vec3(j.at("min"))), Vec3(vec3(j.at("max")))); }

VolumeSettings settingsOf(const Json& j) {
    VolumeSettings s;
    s.firstLevel = j.at("firstLevel").get<std::array<int, 3>>();
    s.secondLevel = j.at("secondLevel"), s.refineBelow = j.at("refineBelow"), s.refineDepth = j.at("refineDepth");
    s.bounds = boxOf(j.at("bounds")), s.insetM = j.at("insetM"), s.side = j.at("side");
    s.sampling = j.at("sampling") == "centres" ? BinSampling::Centres : BinSampling::Spread;
    s.sources = j.at("sources") == "bins" ? SourceSampling::InBins : SourceSampling::Sought;
    s.samplesPerBin = j.at("samplesPerBin"), s.lightSamples = j.at("lightSamples");
    s.ignored = j.at("ignored").get<std::vector<std::string>>();
    s.ignoredCdM2 = j.at("ignoredCdM2");
    return s;
}

VolumeShape fill(const Json& j, IrradianceVolume& v) {
    v.settings = settingsOf(j.at("settings"));
    v.scene = j.at("scene"), v.sceneHash = j.at("sceneHash");
    for (const auto& part : j.at("parts")) v.parts.push_back({part.at("name"), part.at("hash"), boxOf(part.at("bounds"))});
    v.algorithm = j.at("algorithm"), v.seed = j.at("seed");
    v.seconds = j.at("seconds"), v.rays = j.at("rays"), v.complete = j.at("complete");
    v.interpolationError = j.at("interpolationError").is_null() ? -1 : j.at("interpolationError").get<double>();
    v.origin = vec3(j.at("origin"));
    const auto weights = vec3(j.at("luminanceWeights"));
    v.weights = {weights.x, weights.y, weights.z};
    const auto& lattice = j.at("lattice");
    return {boxOf(lattice.at("bounds")), lattice.at("cells").get<std::array<int, 3>>(), lattice.at("split"), lattice.at("depth")};
}

}  // namespace

std::string settingsText(const VolumeSettings& settings) { return settingsJson(settings).dump(); }

std::string headerText(const IrradianceVolume& v) {
    Json parts = Json::array();
    for (const auto& part : v.parts) parts.push_back({{"name", part.name}, {"hash", part.hash}, {"bounds", boxJson(part.bounds)}});
    const double error = v.relativeError();
    const Json out{{"schema", kSchema},
                   {"scene", v.scene},
                   {"sceneHash", v.sceneHash},
                   {"algorithm", v.algorithm},
                   {"seed", v.seed},
                   {"seconds", v.seconds},
                   {"rays", v.rays},
                   {"complete", v.complete},
                   {"relativeError95", std::isfinite(error) ? Json(1.96 * error) : Json(nullptr)},
                   {"interpolationError", v.interpolationError < 0 ? Json(nullptr) : Json(v.interpolationError)},
                   {"settings", settingsJson(v.settings)},
                   {"lattice", {{"bounds", boxJson(v.lattice.bounds())}, {"cells", v.lattice.firstLevel()}, {"split", v.lattice.split()}, {"depth", v.lattice.depth()}}},
                   {"origin", vector(v.origin)},
                   {"luminanceWeights", {v.weights.r, v.weights.g, v.weights.b}},
                   {"parts", parts}};
    return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<VolumeShape> readHeader(std::string_view text, const std::string& name, IrradianceVolume& volume) {
    try {
        const auto j = Json::parse(text);
        if (j.at("schema") != kSchema) return Error{ErrorCode::Parse, fmt::format("schema {}, expected \"{}\"", j.at("schema").dump(), kSchema), name};
        const auto shape = fill(j, volume);
        if (volume.settings.side < 2 || volume.settings.side > 64)
            return Error{ErrorCode::Parse, fmt::format("{} bins along a hemisphere's side, expected 2 .. 64", volume.settings.side), name};
        return shape;
    } catch (const nlohmann::json::exception& e) {
        return Error{ErrorCode::Parse, fmt::format("the header of the volume: {}", e.what()), name};
    }
}

}  // namespace luxdeck

#include "analysis/grids/solve_json.h"

#include "analysis/grids/layers.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace luxdeck {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

/// Null where nothing is known, or so little that the number is withheld.
Json known(const Interval& i) { return std::isfinite(i.ci95) ? number(i.value) : Json(nullptr); }

Json statistic(const JudgedInterval& s) {
    Json out{{"value", known(s.interval)}, {"ci95", number(s.interval.ci95)}};
    out["required"] = s.required ? Json(*s.required) : Json(nullptr);
    out["verdict"] = s.verdict == Verdict::None ? Json(nullptr) : Json(verdictText(s.verdict));
    return out;
}

Json point(const PointResult& p) {
    return {{"x", p.position.x}, {"y", p.position.y}, {"z", p.position.z},
            {"nx", p.normal.x}, {"ny", p.normal.y}, {"nz", p.normal.z},
            {"lx", known(p.total)}, {"ci95", number(p.total.ci95)},
            {"direct", known(p.direct)}, {"directCi95", number(p.direct.ci95)},
            {"indirect", known(p.indirect)}, {"indirectCi95", number(p.indirect.ci95)},
            {"samples", p.samples}};
}

Json grid(const GridResult& g) {
    Json out{{"name", g.name}, {"kind", g.kind == GridKind::Planar ? "planar" : "cylindrical"},
             {"columns", g.columns}, {"rows", g.rows}, {"spacing", {g.spacingU, g.spacingV}}, {"border", g.borderM}};
    out["mean"] = statistic(g.mean), out["min"] = statistic(g.minimum), out["uniformity"] = statistic(g.uniformity);
    out["max"] = number(g.maximumLux);
    for (const auto& r : g.requirements) out["requirements"].push_back({{"name", r.name}, {"source", r.source}});
    out["points"] = Json::array();
    for (const auto& p : g.points) out["points"].push_back(point(p));
    return out;
}

/// Of every layer that is not dark, its light at the grid's points.
Json layersOf(const LayeredSums& layers, std::size_t first, std::size_t count) {
    Json out = Json::array();
    for (std::size_t layer = 0; layer < layers.layers.size(); ++layer) {
        Json points = Json::array();
        bool dark = true;
        for (std::size_t i = first; i < first + count; ++i) {
            const auto value = layers.value(i, layer);
            dark = dark && value.value == 0;
            points.push_back({{"lx", number(value.value)}, {"ci95", number(value.ci95)}});
        }
        if (!dark) out.push_back({{"name", layers.layers[layer].name}, {"dimming", layers.layers[layer].dimming}, {"points", points}});
    }
    return out;
}

}  // namespace

std::string solveJson(const SolveResult& r) {
    Json out{{"schema", "luxdeck-solve/1"}, {"project", r.project}, {"complete", r.complete},
             {"seconds", r.seconds}, {"setupSeconds", r.setupSeconds}, {"predictedSeconds", r.predictedSeconds},
             {"samples", r.samples}, {"rays", r.rays}, {"algorithm", r.algorithm}, {"ambientLux", r.ambientLux},
             {"seed", r.seed}, {"threads", r.threads},
             {"targetError", r.targetError > 0 ? Json(r.targetError) : Json(nullptr)}, {"targetReached", r.targetReached}};
    out["grids"] = Json::array();
    std::size_t first = 0;
    for (const auto& g : r.grids) {
        out["grids"].push_back(grid(g));
        if (r.layers) out["grids"].back()["layers"] = layersOf(*r.layers, first, g.points.size());
        first += g.points.size();
    }
    out["trace"] = Json::array();
    for (const auto& t : r.trace)
        out["trace"].push_back({{"seconds", t.seconds}, {"relativeError", number(t.relativeError)},
                                {"rmsPointError", number(t.rmsPointError)}, {"samples", t.samples}});
    out["leftOut"] = Json::array();
    for (const auto& l : r.leftOut) out["leftOut"].push_back({{"what", l.what}, {"why", l.why}});
    out["warnings"] = r.warnings;
    out["truncatedFraction"] = r.truncatedFraction;
    out["condition"] = {{"meanReflectance", r.condition.meanReflectance}, {"amplification", r.condition.amplification},
                        {"effectiveReplicates", r.condition.effectiveReplicates}};
    out["rejectedSamples"] = r.rejectedSamples, out["withheldPoints"] = r.withheldPoints;
    out["sceneHash"] = r.sceneHash, out["projectHash"] = r.projectHash;
    out["version"] = r.version, out["kernel"] = r.kernel;
    return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxdeck

#include "analysis/photometry/photometry_summary.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luxdeck {

namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json lobeJson(const LobeWidth& lobe) { return {{"beam", orNull(lobe.beamDegrees)}, {"field", orNull(lobe.fieldDegrees)}}; }

Json fileJson(const CheckedFile& checked) {
    const auto& p = checked.photometry;
    const auto& f = checked.facts;
    const auto& t = p.table;
    return {{"schema", "luxdeck-check/1"}, {"name", p.name}, {"manufacturer", p.manufacturer}, {"lamp", p.lamp}, {"format", p.format},
            {"photometry", fmt::format("type {}{}", typeText(t.type()), p.absolute ? ", absolute" : ", relative")},
            {"lumensDeclared", p.lumensDeclared}, {"lumensIntegrated", f.lumens}, {"lumensRatio", orNull(f.declaredRatio)},
            {"flux", f.fluxJudgement}, {"lumensDown", f.lumensDown}, {"lumensUp", f.lumensUp},
            {"maxCandela", f.peak.candela}, {"maxAt", {{"gamma", f.peak.gammaDegrees}, {"plane", f.peak.planeDegrees}}},
            {"angleC0", lobeJson(f.c0)}, {"angleC90", lobeJson(f.c90)},
            {"symmetry", symmetryText(p.symmetry)}, {"symmetryMeasured", symmetryText(f.measured)},
            {"symmetryDeviation", {{"axial", f.deviation.axial}, {"aboutC0", f.deviation.about0}, {"aboutC90", f.deviation.about90}}},
            {"opening", {{"shape", openingText(p.opening.shape)}, {"length", p.opening.lengthM}, {"width", p.opening.widthM}, {"height", p.opening.heightM}}},
            {"angles", {{"vertical", t.vertical().size()}, {"horizontal", t.horizontal().size()}}}, {"watts", p.watts},
            {"efficacy", orNull(f.efficacy)}, {"fileHash", p.fileHash}, {"repairs", p.repairs}, {"warnings", p.warnings}};
}

/// Names in files may be anything; what is not UTF-8 gets replacement characters.
std::string dumped(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string degreesText(const std::optional<double>& degrees) { return degrees ? fmt::format("{:.1f}°", *degrees) : "none"; }

std::string lobeText(const LobeWidth& c0, const LobeWidth& c90) {
    return fmt::format("  beam angle  {} in C0-C180, {} in C90-C270 (half of the plane's maximum)\n  field angle {}, {} (a tenth)\n",
                       degreesText(c0.beamDegrees), degreesText(c90.beamDegrees), degreesText(c0.fieldDegrees), degreesText(c90.fieldDegrees));
}

std::string openingLine(const LuminousOpening& o) {
    if (o.shape == OpeningShape::Point) return "  opening     point\n";
    return fmt::format("  opening     {} {:.3f} x {:.3f} x {:.3f} m (length along C0-C180, width, height)\n", openingText(o.shape), o.lengthM,
                       o.widthM, o.heightM);
}

std::string fluxText(const Photometry& p, const PhotometricFacts& f) {
    std::string text = fmt::format("  lumens      {:.1f} integrated, ", f.lumens);
    text += f.declaredRatio ? fmt::format("{:.1f} declared, ratio {:.4f}", p.lumensDeclared, *f.declaredRatio) : "none declared";
    text += fmt::format(": {}\n", f.fluxJudgement);
    const double share = f.lumens > 0 ? 100 / f.lumens : 0;
    return text + fmt::format("  up, down    {:.1f} lm up ({:.1f} %), {:.1f} lm down ({:.1f} %)\n", f.lumensUp, share * f.lumensUp, f.lumensDown,
                              share * f.lumensDown);
}

std::string symmetryLine(const Photometry& p, const PhotometricFacts& f) {
    return fmt::format("  symmetry    stored {}, measured {}; off by {:.2g} % of the maximum from axial, {:.2g} % about C0-C180, {:.2g} % about C90-C270\n",
                       symmetryText(p.symmetry), symmetryText(f.measured), 100 * f.deviation.axial, 100 * f.deviation.about0,
                       100 * f.deviation.about90);
}

}  // namespace

std::string photometryText(const CheckedFile& checked) {
    const auto& p = checked.photometry;
    const auto& f = checked.facts;
    const auto& t = p.table;
    std::string text = (p.name.empty() ? "luminaire without a name" : p.name) + (p.manufacturer.empty() ? "" : "  (" + p.manufacturer + ")") + "\n";
    if (!p.lamp.empty()) text += "  lamp        " + p.lamp + "\n";
    text += fmt::format("  photometry  {}, type {}, {}, {} vertical and {} horizontal angles\n", p.format, typeText(t.type()),
                        p.absolute ? "absolute" : "relative", t.vertical().size(), t.horizontal().size());
    text += fluxText(p, f);
    text += fmt::format("  candela     {:.1f} at most, at γ {:.4g}°, C {:.4g}°\n", f.peak.candela, f.peak.gammaDegrees, f.peak.planeDegrees);
    text += lobeText(f.c0, f.c90) + symmetryLine(p, f) + openingLine(p.opening);
    if (f.efficacy) text += fmt::format("  power       {:.1f} W, {:.0f} lm/W\n", p.watts, *f.efficacy);
    for (const auto& r : p.repairs) text += "  repaired: " + r + "\n";
    for (const auto& w : p.warnings)
        if (!w.starts_with("flux: ")) text += "  warning: " + w + "\n";  // that one stands beside the lumens
    return text;
}

std::string photometryJson(const CheckedFile& checked) { return dumped(fileJson(checked)); }

std::string photometryListJson(const std::vector<CheckedFile>& checked, const std::vector<RefusedFile>& refused) {
    Json out{{"schema", "luxdeck-check-list/1"}, {"files", Json::array()}, {"refused", Json::array()}};
    for (const auto& each : checked) {
        Json file{{"file", each.file}};
        auto facts = fileJson(each);
        facts.erase("schema");
        file.update(facts);
        out["files"].push_back(std::move(file));
    }
    for (const auto& each : refused) out["refused"].push_back({{"file", each.file}, {"why", each.why}});
    return dumped(out);
}

}  // namespace luxdeck

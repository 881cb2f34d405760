#include "cli/check_aside.h"

#include "cli/json_text.h"
#include "cli/load.h"
#include "engine/core/file.h"
#include "engine/io/image_files.h"
#include "engine/io/obj_mtl.h"
#include "engine/io/wea.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace luxdeck::cli {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t kMostFaultsShown = 10;

enum class Kind { None, Weather, Picture, Texture, Materials, NotRead };

/// What is not read, and what to do instead.
struct Foreign {
    const char* extension;
    const char* is;
    const char* instead;
};
constexpr const char* kExportModel = "export the model as glTF (.glb) or OBJ";
constexpr const char* kAskMaker = "ask its maker for IES LM-63 (.ies) or EULUMDAT (.ldt)";
constexpr std::array<Foreign, 22> kForeign{{
    {".ifc", "a building model (IFC)", kExportModel},
    {".dwg", "an AutoCAD drawing", kExportModel},
    {".dxf", "an AutoCAD drawing", kExportModel},
    {".skp", "a SketchUp model", kExportModel},
    {".3dm", "a Rhino model", kExportModel},
    {".rvt", "a Revit model", kExportModel},
    {".fbx", "an FBX model", kExportModel},
    {".dae", "a COLLADA model", kExportModel},
    {".3ds", "a 3D Studio model", kExportModel},
    {".blend", "a Blender file", kExportModel},
    {".stl", "an STL model, which knows no materials", kExportModel},
    {".ply", "a PLY mesh", kExportModel},
    {".usd", "a USD scene", kExportModel},
    {".usdz", "a USD scene", kExportModel},
    {".xml", "XML: photometry by TM-33, or a BSDF", kAskMaker},
    {".uld", "a luminaire of DIALux", kAskMaker},
    {".rolf", "a luminaire of Relux", kAskMaker},
    {".gdtf", "a stage luminaire (GDTF)", kAskMaker},
    {".cie", "photometry by CIE 102", kAskMaker},
    {".evo", "a DIALux project", kExportModel},
    {".tm2", "weather of TMY2", "convert it to EPW (EnergyPlus's weather converter does)"},
    {".stat", "statistics of an EPW file", "name the .epw itself"},
}};

const Foreign* foreign(const std::string& extension) {
    for (const auto& each : kForeign)
        if (extension == each.extension) return &each;
    return nullptr;
}

Kind kindByName(const std::string& extension) {
    static const std::map<std::string, Kind> kKinds{
        {".epw", Kind::Weather}, {".wea", Kind::Weather}, {".hdr", Kind::Picture},  {".pic", Kind::Picture},
        {".rgbe", Kind::Picture}, {".xyze", Kind::Picture}, {".exr", Kind::Picture}, {".png", Kind::Texture},
        {".jpg", Kind::Texture}, {".jpeg", Kind::Texture}, {".mtl", Kind::Materials}};
    const auto found = kKinds.find(extension);
    if (found != kKinds.end()) return found->second;
    return foreign(extension) != nullptr ? Kind::NotRead : Kind::None;
}

/// Names that projects, scenes and photometry have: what is in them is their readers' to judge.
bool isReadElsewhere(const std::string& extension) {
    static constexpr std::array<std::string_view, 13> kNames{".toml", ".glb", ".gltf", ".obj", ".rad", ".mat", ".ies",
                                                             ".ldt",  ".oct", ".rtm",  ".vf",  ".cal", ".dat"};
    return std::find(kNames.begin(), kNames.end(), extension) != kNames.end();
}

Kind kindOf(const std::string& path) {
    const auto extension = lowerExtension(path);
    if (isReadElsewhere(extension)) return Kind::None;
    if (const auto kind = kindByName(extension); kind != Kind::None) return kind;
    std::array<char, 512> head{};
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    const std::string_view start(head.data(), static_cast<std::size_t>(in.gcount()));
    if (start.starts_with("LOCATION,") || start.starts_with("place ")) return Kind::Weather;
    const bool text = start.find('\0') == std::string_view::npos;
    return text ? Kind::None : Kind::NotRead;
}

/// What is told of a file.
struct Told {
    std::string kind;                                     ///< "weather"
    std::vector<std::pair<std::string, Json>> facts;
    std::string use;                                      ///< where it belongs
    std::vector<std::string> warnings;
};

std::string clock(const ClockTime& time, double hour) {
    return fmt::format("{:02}-{:02} {:.4g} h", time.month, time.day, hour);
}

void tellFaults(const Weather& weather, Told& told) {
    std::size_t faults = 0;
    for (const auto& row : weather.rows) {
        if (row.fault.empty() || ++faults > kMostFaultsShown) continue;
        const double half = row.intervalHours / 2;
        told.warnings.push_back(fmt::format("{}: {} to {:.4g} h cannot be used", row.fault,
                                            clock(row.middle, row.middle.hour - half), row.middle.hour + half));
    }
    if (faults > kMostFaultsShown)
        told.warnings.push_back(fmt::format("and {} more such rows", faults - kMostFaultsShown));
    if (!weather.undated.empty())
        told.warnings.push_back(fmt::format("{} rows have no date that can be read, so no hour either; the first: {}",
                                            weather.undated.size(), weather.undated.front().fault));
}

Result<Told> weatherTold(const std::string& path) {
    const auto bytes = readFile(path);
    if (!bytes) return bytes.error();
    const auto weather = readWeatherFile(*bytes, path);
    if (!weather) return weather.error();
    Told told;
    told.kind = "weather";
    std::size_t unusable = weather->undated.size(), missing = 0;
    double brightest = 0;
    for (const auto& row : weather->rows) {
        if (!row.fault.empty()) ++unusable;
        else if (!row.directNormalWm2 || !row.diffuseHorizontalWm2) ++missing;
        brightest = std::max(brightest, row.diffuseHorizontalWm2.value_or(0));
    }
    const auto& first = weather->rows.front().middle;
    const auto& last = weather->rows.back().middle;
    told.facts = {{"place", weather->place}, {"latitudeDeg", weather->site.latitudeDeg},
                  {"longitudeDeg", weather->site.longitudeDeg}, {"timeZoneHours", weather->site.timeZoneHours},
                  {"rows", weather->rows.size()}, {"intervalMinutes", weather->rows.front().intervalHours * 60},
                  {"first", clock(first, first.hour)}, {"last", clock(last, last.hour)},
                  {"rowsUnusable", unusable}, {"rowsMarkedMissing", missing}, {"mostDiffuseWm2", brightest}};
    const auto name = fs::path(path).filename().string();
    told.use =
        fmt::format("a project names it: [sky] kind = \"perez\", weather = \"{}\", date = \"06-21\", hour = 12", name);
    tellFaults(*weather, told);
    return told;
}

Result<Told> pictureTold(const std::string& path) {
    const auto image = readHdrImage(path);
    if (!image) return image.error();
    Told told;
    told.kind = "picture";
    std::string channels;
    std::size_t notFinite = 0;
    float most = 0;
    for (const auto& [name, values] : image->channels()) {
        channels += (channels.empty() ? "" : " ") + name;
        for (const float value : values) {
            if (!std::isfinite(value)) ++notFinite;
            else most = std::max(most, value);
        }
    }
    told.facts = {{"width", image->width()}, {"height", image->height()},
                  {"channels", channels}, {"largestValue", most}};
    if (notFinite > 0) told.warnings.push_back(fmt::format("{}: {} values are not finite", path, notFinite));
    told.use = fmt::format("show it: luxdeck tonemap {} -o picture.png; a Radiance scene names it in a colorpict",
                           fs::path(path).filename().string());
    return told;
}

Result<Told> textureTold(const std::string& path) {
    Told told;
    told.kind = "texture";
    if (lowerExtension(path) == ".png") {
        const auto image = readPng(path);
        if (!image) return image.error();
        told.facts = {{"width", image->width}, {"height", image->height}};
    } else {
        const auto bytes = readFile(path);
        if (!bytes) return bytes.error();
        if (!bytes->starts_with("\xFF\xD8\xFF"))
            return Error{ErrorCode::Parse, "does not begin as a JPEG file does", path};
    }
    told.use = "a model names it: map_Kd in an MTL file, images in glTF";
    return told;
}

Result<Told> materialsTold(const std::string& path) {
    const auto bytes = readFile(path);
    if (!bytes) return bytes.error();
    WarningList warnings;
    const auto records = obj::parseMtl(*bytes, path, warnings);
    if (!records) return records.error();
    Told told;
    told.kind = "materials";
    Json names = Json::array();
    for (const auto& record : *records) names.push_back(record.name);
    told.facts = {{"materials", std::move(names)}};
    told.use = fmt::format("an OBJ file names it: mtllib {}", fs::path(path).filename().string());
    told.warnings = warnings.texts();
    return told;
}

Result<Told> tell(const std::string& path) {
    switch (kindOf(path)) {
        case Kind::Weather: return weatherTold(path);
        case Kind::Picture: return pictureTold(path);
        case Kind::Texture: return textureTold(path);
        case Kind::Materials: return materialsTold(path);
        case Kind::NotRead:
        case Kind::None: break;
    }
    std::error_code error;
    if (!fs::exists(path, error)) return Error{ErrorCode::FileNotFound, "does not exist", path};
    const auto* known = foreign(lowerExtension(path));
    const auto why = known != nullptr ? fmt::format("is {}, which is not read: {}", known->is, known->instead)
                                      : std::string("is no file that is read: expected project.toml, a model (.glb, "
                                                    ".gltf, .obj), a Radiance scene (.rad), photometry (.ies, .ldt), "
                                                    "weather (.epw, .wea) or a picture (.hdr, .exr)");
    return Error{ErrorCode::Unsupported, why, path};
}

std::string textOf(const std::string& path, const Told& told) {
    std::string text = fmt::format("{}: {}\n", path, told.kind);
    for (const auto& [name, value] : told.facts)
        text += fmt::format("  {:<18}{}\n", name, value.is_string() ? value.get<std::string>() : value.dump());
    return text + fmt::format("  {:<18}{}\n", "use", told.use);
}

}  // namespace

bool isAside(const std::string& path) { return kindOf(path) != Kind::None; }

Exit checkAside(const std::vector<std::string>& files, const Context& context) {
    Exit exit = Exit::Ok;
    std::string text;
    Json list = Json::array();
    for (const auto& file : files) {
        if (context.progress.cancelled()) return Exit::Interrupted;
        const auto told = tell(file);
        if (!told) {
            exit = complain(told.error());
            continue;
        }
        printWarnings(told->warnings, context.common.quiet);
        text += textOf(file, *told);
        Json facts = Json::object();
        for (const auto& [name, value] : told->facts) facts[name] = value;
        list.push_back({{"file", file}, {"kind", told->kind}, {"facts", facts}, {"use", told->use},
                        {"warnings", told->warnings}});
    }
    if (list.empty()) return exit;
    const Json json{{"schema", "luxdeck-check-files/1"}, {"files", list}};
    const auto written = writeOutput("-", context.common.json ? jsonText(json) : text);
    return written ? exit : complain(written.error());
}

}  // namespace luxdeck::cli

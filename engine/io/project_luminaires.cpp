#include "engine/core/file.h"
#include "engine/io/ies_tilt.h"
#include "engine/io/photometry.h"
#include "engine/io/project_aim.h"
#include "engine/io/project_colour.h"
#include "engine/io/project_keys.h"
#include "engine/io/project_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace luxdeck::project {

namespace {

constexpr NumberRange kLumens{.low = 0, .high = 1e9, .lowExcluded = true};
constexpr NumberRange kWatts{.low = 0, .high = 1e9};
constexpr NumberRange kKelvin{.low = kLowestColourTemperatureK, .high = kHighestColourTemperatureK};
constexpr NumberRange kMaintenance{.low = 0, .high = 1, .lowExcluded = true};
constexpr NumberRange kTurn{.low = -3600, .high = 3600};

std::size_t readType(const TomlTable& table, const Ids& ids) {
    const auto id = table.text("type");
    const auto index = ids.find(id);
    if (!index && !id.empty())
        table.error(ErrorCode::InvalidArgument, "type",
                    fmt::format("type {} is no [[luminaire_type]]; {}", inQuotes(id), suggestion(id, ids.names())));
    return index.value_or(0);
}

void readArray(const TomlTable& table, LuminaireSpec& spec) {
    const auto array = table.table("array", kArray);
    if (!array) return;
    constexpr int kMost = static_cast<int>(kMaxLuminaires);
    spec.count = array->integers<2>("count", 1, kMost, {1, 1});
    if (!array->has("count")) array->error(ErrorCode::Parse, "", "count is missing");
    const auto spacing = array->numbers("spacing", 2, kCoordinate);
    spec.spacingM = {spacing[0], spacing[1]};
    for (int i = 0; i < 2; ++i)
        if (spec.count[i] > 1 && spec.spacingM[i] == 0)
            array->error(ErrorCode::InvalidArgument, "spacing",
                         fmt::format("spacing[{}] is 0: {} luminaires would be in one place", i, spec.count[i]));
}

std::size_t total(const LuminaireSpec& spec) {
    return static_cast<std::size_t>(spec.count[0]) * static_cast<std::size_t>(spec.count[1]);
}

void warnOfUnusedTypes(const TomlTable& root, const std::vector<LuminaireTypeSpec>& types,
                       const std::vector<LuminaireSpec>& luminaires) {
    std::set<std::size_t> used;
    for (const auto& luminaire : luminaires) used.insert(luminaire.type);
    const auto tables = root.tables("luminaire_type", kLuminaireType);
    for (std::size_t i = 0; i < types.size(); ++i)  // fewer than tables after an error
        if (!used.contains(i)) tables[i].warn("id", fmt::format("no luminaire is of type {}", inQuotes(types[i].id)));
}

/// Gives out names: "A1", "A2" ... for luminaires that have none, "row-1" ... for arrays that have one.
class LuminaireNames {
public:
    LuminaireNames(const Scene& scene, const ProjectSpec& spec) {
        for (const auto& luminaire : scene.luminaires) taken_.insert(luminaire.name);
        for (const auto& luminaire : spec.luminaires)
            if (total(luminaire) == 1) taken_.insert(luminaire.name);
    }
    std::string name(const LuminaireSpec& spec, const std::string& typeId) {
        if (!spec.name.empty() && total(spec) == 1) return spec.name;
        const auto stem = spec.name.empty() ? typeId : spec.name + "-";
        std::string name;
        do name = fmt::format("{}{}", stem, ++count_[stem]);
        while (!taken_.insert(name).second);
        return name;
    }

private:
    std::set<std::string> taken_;
    std::map<std::string, std::size_t> count_;
};

/// By aim and rotation_deg, or by IES LM-72's angles.
void readAim(const TomlTable& table, LuminaireSpec& spec) {
    constexpr std::array<Key, 4> kAngles{"orient", "tilt", "roll", "spin"};
    std::array<double, 4> degrees{};
    bool byAngles = false;
    for (std::size_t i = 0; i < kAngles.size(); ++i) {
        byAngles |= table.has(kAngles[i]);
        degrees[i] = table.number(kAngles[i], kTurn, 0.0);
        for (const Key other : {"aim", "rotation_deg"}) table.refuseBoth(kAngles[i], other);
    }
    if (byAngles) {
        spec.frame = luminaireFrame(AimAngles{degrees[0], degrees[1], degrees[2], degrees[3]});
        return;
    }
    auto aim = table.vector("aim", Vec3d(0, 0, -1));
    if (!(aim.length() > 0)) {
        table.error(ErrorCode::InvalidArgument, "aim", "aim is [0, 0, 0], expected a direction");
        aim = Vec3d(0, 0, -1);
    }
    spec.frame = luminaireFrame(aim, table.number("rotation_deg", kTurn, 0.0));
    if (!table.has("rotation_deg")) spec.uprightFrame = luminaireFrame(uprightAim(aim));
}

Luminaire placed(const Scene& scene, const LuminaireSpec& spec, const LuminaireTypeSpec& type, const Vec3d& offset) {
    Luminaire luminaire;
    luminaire.position = scene.toRebased(spec.position + offset);
    luminaire.dimming = spec.dimming;
    luminaire.maintenanceFactor = spec.maintenanceFactor.value_or(type.maintenanceFactor);
    return luminaire;
}

/// Types A and B, aimed without a rotation, are floods and headlamps whose "up" is up, as the trade aims them.
Frame frameOf(const LuminaireSpec& spec, const LuminaireType& type) {
    const bool hasUp = type.photometry.table.type() != PhotometryType::C;
    return hasUp ? spec.uprightFrame.value_or(spec.frame) : spec.frame;
}

/// By type; nothing where the file has none or the project wants none.
std::vector<LampTilt> loadLampTilts(const ProjectSpec& spec, const std::vector<LuminaireType>& types) {
    std::vector<LampTilt> tilts(types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (!spec.luminaireTypes[i].lampTilt || types[i].photometry.format == "EULUMDAT") continue;
        const auto& path = spec.luminaireTypes[i].file.path;
        const auto bytes = readFile(path);
        if (!bytes) continue;  // it was there a moment ago, when its photometry was read
        if (auto tilt = readLampTilt(*bytes, path)) tilts[i] = *std::move(tilt);
    }
    return tilts;
}

/// What looked wrong in the photometric files: who only ever checks the project shall hear of it too.
void tellOfPhotometry(Scene& scene, const ProjectSpec& spec, const std::vector<LuminaireType>& types) {
    for (std::size_t i = 0; i < types.size(); ++i)
        for (const auto& warning : types[i].photometry.warnings)
            if (!warning.starts_with("flux:"))  // how lumens are stated, which every file has something to say on
                scene.warnings.push_back(fmt::format("luminaire type {}: {}: {}", inQuotes(types[i].id),
                                                     spec.luminaireTypes[i].file.shown, warning));
}

/// What TILT did to the luminaires of a type.
struct TiltNote {
    std::size_t count = 0;
    double least = 1e30, most = 0;
};

void noteTilt(TiltNote& note, double factor, std::size_t count) {
    note.count += count;
    note.least = std::min(note.least, factor), note.most = std::max(note.most, factor);
}

/// Luminaires far outside the model are seldom meant: most often the model's unit or axis is wrong.
void warnOfStrays(Scene& scene, const Box3& model, std::size_t firstPlaced) {
    if (model.isEmpty() || scene.triangleCount() == 0) return;
    const Vec3 margin(1.0F + (model.max - model.min).length());
    const Box3 near(model.min - margin, model.max + margin);
    std::size_t strays = 0;
    for (std::size_t i = firstPlaced; i < scene.luminaires.size(); ++i)
        strays += near.intersects(scene.luminaires[i].position) ? 0 : 1;
    if (strays > 0)
        scene.warnings.push_back(fmt::format(
            "{} luminaires lie far outside the geometry: is its unit or its up axis right?", strays));
}

}  // namespace

std::vector<LuminaireTypeSpec> readLuminaireTypes(const TomlTable& root, const std::filesystem::path& folder) {
    std::vector<LuminaireTypeSpec> types;
    UniqueNames ids;
    root.each("luminaire_type", kLuminaireType, [&](const TomlTable& table) {
        LuminaireTypeSpec type;
        type.id = table.text("id");
        ids.add(table, "id", type.id);
        type.file = readFileReference(table, "file", folder);
        type.description = table.text("description", "");
        type.lumens = table.numberIf("lumens", kLumens);
        type.watts = table.numberIf("watts", kWatts);
        type.maintenanceFactor = table.number("maintenance_factor", kMaintenance, 1.0);
        type.lampTilt = table.flag("lamp_tilt", true);
        if (const auto kelvin = table.numberIf("colour_temperature_k", kKelvin)) type.colour = daylightColour(*kelvin);
        types.push_back(std::move(type));
    });
    return types;
}

std::vector<LuminaireSpec> readLuminaires(const TomlTable& root, const std::vector<LuminaireTypeSpec>& types) {
    std::vector<LuminaireSpec> luminaires;
    Ids ids;
    for (const auto& type : types) ids.add(type.id);
    UniqueNames names;
    std::size_t count = 0;
    root.each("luminaire", kLuminaire, [&](const TomlTable& table) {
        LuminaireSpec spec;
        spec.where = table.where();
        spec.type = readType(table, ids);
        spec.name = table.text("name", "");
        if (!spec.name.empty()) names.add(table, "name", spec.name);
        spec.position = table.vector("position");
        readAim(table, spec);
        spec.dimming = table.number("dimming", kFraction, 1.0);
        spec.maintenanceFactor = table.numberIf("maintenance_factor", kMaintenance);
        readArray(table, spec);
        count += total(spec);
        if (count > kMaxLuminaires)
            table.error(ErrorCode::InvalidArgument, "array",
                        fmt::format("with this there are {} luminaires, expected at most {}", count, kMaxLuminaires));
        luminaires.push_back(std::move(spec));
    });
    warnOfUnusedTypes(root, types, luminaires);
    return luminaires;
}

Result<std::vector<LuminaireType>> loadLuminaireTypes(const ProjectSpec& spec) {
    std::vector<LuminaireType> types;
    for (const auto& typeSpec : spec.luminaireTypes) {
        const auto subject = fmt::format("luminaire type {}", inQuotes(typeSpec.id));
        auto photometry = loadPhotometry(typeSpec.file.path);
        if (!photometry) return inNamedFile(photometry.error(), subject, typeSpec.file);
        if (typeSpec.lumens && !(photometry->table.lumens() > 0))
            return Error{ErrorCode::InvalidArgument,
                         fmt::format("{}: lumens = {} cannot be had from {}, which emits nothing", subject,
                                     *typeSpec.lumens, typeSpec.file.shown),
                         typeSpec.file.where};
        LuminaireType type;
        type.id = typeSpec.id;
        type.description = typeSpec.description;
        type.file = typeSpec.file.shown;
        type.colour = typeSpec.colour;
        type.watts = typeSpec.watts.value_or(photometry->watts);
        type.photometry = std::move(*photometry);
        types.push_back(std::move(type));
    }
    return types;
}

Result<void> placeLuminaires(Scene& scene, const ProjectSpec& spec, std::vector<LuminaireType> types) {
    std::set<std::string> inGeometry;
    for (const auto& luminaire : scene.luminaires) inGeometry.insert(luminaire.name);
    const auto model = scene.bounds();
    const auto firstType = scene.luminaireTypes.size(), firstPlaced = scene.luminaires.size();
    LuminaireNames names(scene, spec);
    const auto lampTilts = loadLampTilts(spec, types);
    tellOfPhotometry(scene, spec, types);
    std::map<std::size_t, TiltNote> tilts;
    for (const auto& luminaireSpec : spec.luminaires) {
        if (!luminaireSpec.name.empty() && inGeometry.contains(luminaireSpec.name))
            return Error{ErrorCode::InvalidArgument,
                         fmt::format("luminaire name {} is taken by a light in the geometry", inQuotes(luminaireSpec.name)),
                         luminaireSpec.where};
        const auto& typeSpec = spec.luminaireTypes[luminaireSpec.type];
        const auto& type = types[luminaireSpec.type];
        const double relamped = typeSpec.lumens ? *typeSpec.lumens / type.photometry.table.lumens() : 1.0;
        const auto frame = frameOf(luminaireSpec, type);
        const double tilted = lampTilts[luminaireSpec.type].factor(frame);
        if (tilted != 1) noteTilt(tilts[luminaireSpec.type], tilted, total(luminaireSpec));
        for (int j = 0; j < luminaireSpec.count[1]; ++j)
            for (int i = 0; i < luminaireSpec.count[0]; ++i) {
                const Vec3d offset(i * luminaireSpec.spacingM[0], j * luminaireSpec.spacingM[1], 0);
                auto luminaire = placed(scene, luminaireSpec, typeSpec, offset);
                luminaire.name = names.name(luminaireSpec, typeSpec.id);
                luminaire.type = static_cast<std::uint32_t>(firstType + luminaireSpec.type);
                luminaire.frame = frame;
                luminaire.fluxScale = relamped * tilted;
                scene.luminaires.push_back(std::move(luminaire));
            }
    }
    for (const auto& [type, note] : tilts)
        scene.warnings.push_back(fmt::format(
            "luminaire type {}: {} are tilted and shine with {:.4g}..{:.4g} of their output by the file's TILT "
            "(lamp_tilt = false leaves it out)",
            inQuotes(spec.luminaireTypes[type].id), note.count, note.least, note.most));
    for (auto& type : types) scene.luminaireTypes.push_back(std::move(type));
    warnOfStrays(scene, model, firstPlaced);
    return {};
}

}  // namespace luxdeck::project

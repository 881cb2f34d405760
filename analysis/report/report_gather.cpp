#include "analysis/report/report_gather.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <sys/utsname.h>
#include <optional>
#include <thread>
#include <tuple>

namespace luxdeck {

namespace {

constexpr double kCutAboveFloorM = 1.2;  // through windows and doors, above desks: as architects cut

/// Correlated colour temperature of a Rec.709 colour; none for the white that stands for "not given" and
/// for colours too far from white to have one. Source: McCamy 1992, good to a few kelvin from 2000 to 12500 K.
std::optional<double> colourTemperature(const Rgb& c) {
    if (c.isGrey() || c.isBlack()) return std::nullopt;
    const double x = 0.4124 * c.r + 0.3576 * c.g + 0.1805 * c.b, y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b,
                 z = 0.0193 * c.r + 0.1192 * c.g + 0.9505 * c.b;
    const double sum = x + y + z;
    if (!(sum > 0)) return std::nullopt;
    const double n = (x / sum - 0.3320) / (0.1858 - y / sum);
    const double kelvin = ((449.0 * n + 3525.0) * n + 6823.3) * n + 5520.33;
    if (!(kelvin >= 1800 && kelvin <= 12500)) return std::nullopt;
    return std::round(kelvin / 10) * 10;
}

ScheduleRow rowOf(const LuminaireType& type, const Luminaire& luminaire) {
    ScheduleRow row;
    row.id = type.id;
    row.description = type.description.empty() ? type.photometry.name : type.description;
    row.manufacturer = type.photometry.manufacturer;
    row.lumensEach = type.photometry.table.lumens() * luminaire.fluxScale;
    row.wattsEach = type.watts > 0 ? type.watts : type.photometry.watts;
    row.maintenanceFactor = luminaire.maintenanceFactor;
    row.dimming = luminaire.dimming;
    row.cctK = colourTemperature(type.colour);
    row.file = type.file;
    row.fileHash = type.photometry.fileHash;
    return row;
}

/// Luminaires of one type that run alike share a row; rows keep the order of types.
std::vector<ScheduleRow> scheduleOf(const Scene& scene) {
    std::map<std::tuple<std::uint32_t, double, double, double>, ScheduleRow> rows;
    for (const auto& l : scene.luminaires) {
        if (l.type >= scene.luminaireTypes.size()) continue;
        auto [at, isNew] = rows.try_emplace({l.type, -l.dimming, l.maintenanceFactor, l.fluxScale});
        if (isNew) at->second = rowOf(scene.luminaireTypes[l.type], l);
        ++at->second.count;
    }
    std::vector<ScheduleRow> out;
    for (auto& [key, row] : rows) out.push_back(std::move(row));
    return out;
}

const char* kindText(MaterialKind kind) {
    switch (kind) {
        case MaterialKind::Matte: return "matte";
        case MaterialKind::Plastic: return "coated";
        case MaterialKind::Metal: return "metal";
        case MaterialKind::Mirror: return "mirror";
        case MaterialKind::ThinGlass: return "glass";
        case MaterialKind::MetallicRoughness: return "glTF";
        case MaterialKind::Ward: return "Ward";
        case MaterialKind::Dielectric: return "solid glass";
        case MaterialKind::Mix: return "mixture";
    }
    return "";
}

std::vector<MaterialRow> materialsOf(const Scene& scene) {
    std::vector<MaterialRow> rows;
    for (const auto& m : scene.materials) {
        const bool mirror = m.kind == MaterialKind::Metal || m.kind == MaterialKind::Mirror;
        const bool clear = m.kind == MaterialKind::ThinGlass || m.kind == MaterialKind::Dielectric;
        const Rgb& shown = clear ? m.transmittance : mirror ? m.specular : m.reflectance;
        rows.push_back({m.name, kindText(m.kind), luminance(shown, scene.weights), m.source});
    }
    return rows;
}

bool isFloor(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name.find("floor") != std::string::npos;
}

/// Just above the floor plus the cut's height, or half-way up a room lower than that.
double cutHeight(const Scene& scene) {
    const auto bounds = scene.bounds();
    if (bounds.isEmpty()) return kCutAboveFloorM;
    const double low = bounds.min.z + scene.origin.z, high = bounds.max.z + scene.origin.z;
    return high - low > 1.25 * kCutAboveFloorM ? low + kCutAboveFloorM : (low + high) / 2;
}

std::string processorName() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string row; std::getline(in, row);)
        if (row.starts_with("model name"))
            if (const auto at = row.find(": "); at != std::string::npos) return row.substr(at + 2);
    return "unknown processor";
}

std::vector<NamedText> machineFacts() {
    std::vector<NamedText> facts{
        {"Machine", fmt::format("{}, {} logical cores", processorName(), std::thread::hardware_concurrency())}};
    utsname system{};
    if (uname(&system) == 0) facts.push_back({"Operating system", fmt::format("{} {} {}", system.sysname, system.release, system.machine)});
    return facts;
}

}  // namespace

std::optional<double> floorArea(const Scene& scene) {
    struct Level {
        double up = 0, down = 0;  // area of the faces that look either way [m^2]
        [[nodiscard]] double area() const { return std::max(up, down); }  // a sheet may be there twice
    };
    std::map<long, Level> levels;  // by height in centimetres
    for (const auto& mesh : scene.meshes) {
        const bool named = mesh.object < scene.objects.size() && isFloor(scene.objects[mesh.object].name);
        if (!named && !isFloor(mesh.name)) continue;
        for (const auto& t : mesh.triangles) {
            const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
            const Vec3d twice = (b - a).cross(c - a);
            if (std::abs(twice.z) < 0.98 * twice.length()) continue;
            auto& level = levels[std::lround(a.z * 100)];
            (twice.z > 0 ? level.up : level.down) += std::abs(twice.z) / 2;
        }
    }
    double area = 0;
    for (const auto& [height, level] : levels) area += level.area();
    if (area <= 0) return std::nullopt;
    // The underside of slabs is as large as all their upper sides; windings are not to be trusted with telling.
    const double lowest = levels.begin()->second.area();
    const bool underside = levels.size() > 1 && std::abs(2 * lowest - area) < 0.01 * area;
    return underside ? area - lowest : area;
}

ReportContents gatherReport(const Project& project, SolveResult solve, std::string created) {
    ReportContents contents;
    contents.info = project.info;
    contents.created = std::move(created);
    contents.schedule = scheduleOf(project.scene);
    contents.materials = materialsOf(project.scene);
    contents.floorAreaM2 = floorArea(project.scene);
    if (contents.floorAreaM2) contents.floorAreaSource = "level faces of objects named “floor”";
    contents.plan = roomPlan(project.scene, cutHeight(project.scene));
    contents.solve = std::move(solve);
    contents.facts = machineFacts();
    contents.facts.push_back({"Project file", project.file.filename().string()});
    return contents;
}

}  // namespace luxdeck

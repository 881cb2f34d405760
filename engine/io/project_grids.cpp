#include "engine/io/project_keys.h"
#include "engine/io/project_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::project {

namespace {

constexpr NumberRange kIlluminance{.low = 0, .high = 1e7, .lowExcluded = true};
constexpr NumberRange kUniformity{.low = 0, .high = 1, .lowExcluded = true};
constexpr NumberRange kBorder{.low = 0, .high = kMaxCoordinateM};
constexpr int kMaxCount = static_cast<int>(kMaxGridPoints);

constexpr TomlChoice<GridKind> kGridKinds[] = {{"planar", GridKind::Planar}, {"cylindrical", GridKind::Cylindrical}};

/// The requirements that a grid names, by `requirement` or `requirements`.
std::vector<Requirement> requirementsOf(const TomlTable& table, const std::vector<NamedRequirement>& known, const Ids& knownIds) {
    std::vector<Requirement> found;
    if (table.refuseBoth("requirement", "requirements")) return found;
    const bool one = table.has("requirement");
    const auto ids = one ? std::vector<std::string>{table.text("requirement")} : table.texts("requirements");
    for (const auto& id : ids) {
        if (const auto index = knownIds.find(id)) {
            found.push_back(known[*index].requirement);
            continue;
        }
        table.error(ErrorCode::InvalidArgument, one ? "requirement" : "requirements",
                    fmt::format("{} is no [[requirement]]; {}", inQuotes(id), suggestion(id, knownIds.names())));
        break;
    }
    return found;
}

void readPoints(const TomlTable& table, CalculationGrid& grid) {
    for (const auto* key : {"origin", "u", "v", "border", "spacing", "counts"}) table.refuseBoth("points", key);
    const auto rows = table.rows("points", 6);
    if (rows.empty()) table.error(ErrorCode::InvalidArgument, "points", "points is empty");
    if (rows.size() > kMaxGridPoints)
        table.error(ErrorCode::InvalidArgument, "points",
                    fmt::format("points has {} of them, expected at most {}", rows.size(), kMaxGridPoints));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Vec3d normal(rows[i][3], rows[i][4], rows[i][5]);
        if (!(normal.length() > 0))
            return table.error(ErrorCode::InvalidArgument, "points",
                               fmt::format("points[{}] has the normal (0, 0, 0), expected a direction", i));
        grid.points.push_back({Vec3d(rows[i][0], rows[i][1], rows[i][2]), normal.normalized()});
    }
}

/// Checks that edges and border leave an area to divide.
void checkArea(const TomlTable& table, const CalculationGrid& grid) {
    const double a = grid.u.length(), b = grid.v.length();
    // Edges closer to parallel than 10^-6 rad span no surface that could be measured.
    if (!(grid.u.cross(grid.v).length() > 1e-6 * a * b))
        return table.error(ErrorCode::InvalidArgument, "u",
                           "u and v span no area, expected two edges that are not parallel and not zero");
    if (2 * grid.borderM >= std::min(a, b))
        table.error(ErrorCode::InvalidArgument, "border",
                    fmt::format("border is {} m on each side of a surface {} m x {} m: nothing is left", grid.borderM, a, b));
}

void readDivision(const TomlTable& table, CalculationGrid& grid) {
    if (table.refuseBoth("spacing", "counts")) return;
    grid.spacingM = table.numberIf("spacing", kLength);
    if (table.has("counts")) grid.counts = table.integers<2>("counts", 1, kMaxCount, {1, 1});
    double points = 0;
    if (grid.counts) points = static_cast<double>((*grid.counts)[0]) * (*grid.counts)[1];
    if (grid.spacingM)
        points = std::ceil(grid.u.length() / *grid.spacingM) * std::ceil(grid.v.length() / *grid.spacingM);
    if (points > static_cast<double>(kMaxGridPoints))
        table.error(ErrorCode::InvalidArgument, grid.counts ? "counts" : "spacing",
                    fmt::format("makes {:.0f} points, expected at most {}", points, kMaxGridPoints));
}

}  // namespace

std::vector<NamedRequirement> readRequirements(const TomlTable& root, UniqueNames& ids) {
    std::vector<NamedRequirement> requirements;
    root.each("requirement", kRequirement, [&](const TomlTable& table) {
        NamedRequirement named;
        named.id = table.text("id");
        ids.add(table, "id", named.id);
        auto& r = named.requirement;
        r.name = table.text("name", named.id);
        r.source = table.text("source", "");
        r.meanLux = table.numberIf("mean_lux", kIlluminance);
        r.minimumLux = table.numberIf("minimum_lux", kIlluminance);
        r.uniformity = table.numberIf("uniformity", kUniformity);
        r.where = table.where();
        if (!table.has("mean_lux") && !table.has("minimum_lux") && !table.has("uniformity"))
            table.error(ErrorCode::Parse, "", "requires nothing, expected mean_lux, minimum_lux or uniformity");
        requirements.push_back(std::move(named));
    });
    return requirements;
}

std::vector<CalculationGrid> readGrids(const TomlTable& root, const std::vector<NamedRequirement>& requirements) {
    std::vector<CalculationGrid> grids;
    Ids ids;
    for (const auto& named : requirements) ids.add(named.id);
    UniqueNames names;
    root.each("grid", kGrid, [&](const TomlTable& table) {
        CalculationGrid grid;
        grid.where = table.where();
        grid.name = table.text("name");
        names.add(table, "name", grid.name);
        grid.kind = table.choice<GridKind>("kind", GridKind::Planar, kGridKinds);
        if (table.has("points")) {
            readPoints(table, grid);
        } else {
            grid.origin = table.vector("origin");
            grid.u = table.vector("u");
            grid.v = table.vector("v");
            grid.borderM = table.number("border", kBorder, 0.0);
            if (table.has("u") && table.has("v")) checkArea(table, grid);
            readDivision(table, grid);
        }
        grid.requirements = requirementsOf(table, requirements, ids);
        grids.push_back(std::move(grid));
    });
    return grids;
}

}  // namespace luxdeck::project

#include "analysis/report/schedule_page.h"

#include "analysis/report/number_format.h"
#include "analysis/report/plan_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace luxdeck::report {

namespace {

struct Totals {
    int count = 0;
    double watts = 0, lumens = 0;
    bool wattsKnown = true;
};

Totals totalsOf(const std::vector<ScheduleRow>& schedule) {
    Totals totals;
    for (const auto& row : schedule) {
        totals.count += row.count;
        totals.watts += row.count * row.wattsEach;
        totals.lumens += row.count * row.lumensEach;
        totals.wattsKnown = totals.wattsKnown && (row.wattsEach > 0 || row.count == 0);
    }
    return totals;
}

double areaOf(const GridResult& grid) { return grid.u.cross(grid.v).length(); }

/// The largest level surface: its mean is what a power density is compared with.
const GridResult* largestLevelGrid(const SolveResult& solve) {
    const GridResult* largest = nullptr;
    for (const auto& grid : solve.grids) {
        if (grid.kind != GridKind::Planar || grid.columns == 0 || !GridPlane::of(grid).plan) continue;
        if (largest == nullptr || areaOf(grid) > areaOf(*largest)) largest = &grid;
    }
    return largest;
}

std::vector<TableRow> scheduleRows(const std::vector<ScheduleRow>& schedule) {
    std::vector<TableRow> rows;
    for (const auto& row : schedule) {
        const auto watts = row.wattsEach > 0 ? formatNumber(row.wattsEach, 3) : "–";
        const auto efficacy = row.wattsEach > 0 ? formatFixed(row.lumensEach / row.wattsEach, 0) : "–";
        const auto cct = row.cctK ? formatFixed(*row.cctK, 0) : "–";
        const auto product = row.manufacturer.empty() ? row.description : row.manufacturer + " — " + row.description;
        rows.push_back({{{line(row.id), type::kStrong.with(ink::kAccent)},
                         {line(product)},
                         {QString::number(row.count), type::kStrong},
                         {line(formatFixed(row.lumensEach, 0))},
                         {line(watts)},
                         {line(efficacy)},
                         {line(cct)},
                         {line(formatFixed(row.maintenanceFactor, 2))},
                         {line(formatFixed(row.dimming * 100, 0) + " %")}}});
    }
    return rows;
}

void drawTotals(Document& document) {
    const auto& contents = document.contents();
    const auto totals = totalsOf(contents.schedule);
    std::vector<NamedText> facts{{"Luminaires", std::to_string(totals.count)},
                                 {"Luminous flux, new", formatFixed(totals.lumens, 0) + " lm"}};
    const auto power = formatNumber(totals.watts, 4) + " W" + (totals.wattsKnown ? "" : " (of those whose power is known)");
    facts.push_back({"Installed power, undimmed", power});
    if (contents.floorAreaM2 && *contents.floorAreaM2 > 0) {
        const double density = totals.watts / *contents.floorAreaM2;
        facts.push_back({"Floor area", formatNumber(*contents.floorAreaM2, 4) + " m²" +
                                           (contents.floorAreaSource.empty() ? "" : " (" + contents.floorAreaSource + ")")});
        auto text = formatNumber(density, 3) + " W/m²";
        const auto* grid = largestLevelGrid(contents.solve);
        if (grid != nullptr && grid->mean.interval.value > 0)
            text += fmt::format(" = {} W/m² per 100 lx, with Ēm of “{}”",
                                formatNumber(density / (grid->mean.interval.value / 100), 3), grid->name);
        facts.push_back({"Power density", text});
    }
    drawFacts(document, facts, sheet::kColumn + sheet::kGutter);
}

void drawLuminairePlan(Document& document) {
    const auto& plan = document.contents().plan;
    auto bounds = boundsOf(plan);
    for (const auto& l : plan.luminaires) bounds.add({l.position.x, l.position.y});
    if (bounds.empty()) return;
    bounds.grow(0.03 * std::max(bounds.width(), bounds.height()) + 1e-3);
    const double wide = sheet::kTextWidth;
    const double height = std::clamp(wide * bounds.height() / std::max(bounds.width(), 1e-9), 30.0, 105.0);
    document.heading("Luminaire plan", height + 12);
    auto& canvas = document.canvas();
    const PlanScale scale(bounds, {sheet::kLeft, document.y, wide, height});
    drawRoom(canvas, scale, plan, {});
    document.y += height + 5;
    drawScaleBar(canvas, scale, sheet::kLeft, document.y);
    drawAxes(canvas, sheet::kRight - 12, document.y + 1, "x", "y");
    canvas.text(sheet::column(1), document.y, line("Section at z = " + formatNumber(plan.cutHeightM, 3) + " m"), type::kSmall);
    document.y += 9;
}

void drawFiles(Document& document) {
    std::vector<TableRow> rows;
    std::set<std::pair<std::string, std::string>> seen;  // rows that differ in dimming alone share a file
    for (const auto& row : document.contents().schedule)
        if (seen.emplace(row.id, row.file).second)
            rows.push_back({{{line(row.id), type::kStrong.with(ink::kAccent)}, {line(row.file)}, {line(row.fileHash), type::kSmall}}});
    if (rows.empty()) return;
    document.heading("Photometric files", 14);
    drawTable(document, {{"Mark", 16}, {"File", 114}, {"Content hash", 40}}, rows);
}

void drawMaterials(Document& document) {
    std::vector<TableRow> rows;
    for (const auto& m : document.contents().materials)
        rows.push_back({{{line(m.name), type::kStrong}, {line(m.kind)}, {line(formatFixed(m.reflectance, 2))}, {line(m.source), type::kSmall}}});
    if (rows.empty()) return;
    document.heading("Materials", 14);
    drawTable(document, {{"Material", 48}, {"Kind", 24}, {"Reflectance, of glass transmittance", 32}, {"Source", 66}}, rows);
}

}  // namespace

void drawSchedule(Document& document) {
    document.startPage("Luminaires", "Luminaire schedule");
    const auto rows = scheduleRows(document.contents().schedule);
    if (rows.empty()) {
        document.y += document.canvas().paragraph(sheet::kLeft, document.y, sheet::kTextWidth,
                                                  "This project has no luminaires.", type::kBody) + 5;
    } else {
        drawTable(document,
                  {{"Mark", 14}, {"Product", 54}, {"Count", 12, Align::Right}, {"Flux each\nlm", 16, Align::Right},
                   {"Power each\nW", 16, Align::Right}, {"Efficacy\nlm/W", 17, Align::Right}, {"CCT\nK", 13, Align::Right},
                   {"Maint.\nfactor", 14, Align::Right}, {"Dimmed\nto", 14, Align::Right}},
                  rows);
        drawTotals(document);
    }
    drawLuminairePlan(document);
    drawFiles(document);
    drawMaterials(document);
}

}  // namespace luxdeck::report

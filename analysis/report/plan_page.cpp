#include "analysis/report/plan_page.h"

#include "analysis/report/grid_drawing.h"
#include "analysis/report/number_format.h"
#include "analysis/report/summary_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::report {

namespace {

QString gridTitle(const GridResult& grid, std::size_t index) {
    return line(grid.name.empty() ? fmt::format("Surface {}", index + 1) : grid.name);
}

QString quantity(const GridResult& grid) {
    return grid.kind == GridKind::Cylindrical ? "Cylindrical illuminance" : "Illuminance";
}

/// "", "2nd ", "3rd ", "4th " ...: as in "every 2nd column".
std::string ordinal(int n) {
    if (n <= 1) return "";
    const bool teen = n % 100 / 10 == 1;
    return fmt::format("{}{} ", n, teen ? "th" : n % 10 == 1 ? "st" : n % 10 == 2 ? "nd" : n % 10 == 3 ? "rd" : "th");
}

struct Split {
    double direct = 0, indirect = 0;  // means over the points [lx]
};

Split splitOf(const GridResult& grid) {
    Split split;
    for (const auto& p : grid.points) split.direct += p.direct.value, split.indirect += p.indirect.value;
    const double n = std::max<double>(1, static_cast<double>(grid.points.size()));
    return {split.direct / n, split.indirect / n};
}

TableRow statistic(const QString& name, const JudgedInterval& judged, const std::string& unit) {
    return {{{name},
             {line(formatInterval(judged.interval) + unit), type::kStrong},
             {judged.required ? line("≥ " + formatNumber(*judged.required) + unit) : QString("–")},
             verdictCell(judged.verdict)}};
}

void drawStatistics(Document& document, const GridResult& grid) {
    drawTable(document, {{"Statistic", 33}, {"Computed, 95 % interval", 38}, {"Required", 26}, {"Verdict", 29.25}},
              {statistic("Mean Ēm", grid.mean, " lx"), statistic("Minimum Emin", grid.minimum, " lx"),
               statistic("Uniformity Uo", grid.uniformity, "")});
}

std::string lengthText(double metres) { return formatNumber(metres, 3) + " m"; }

std::string heightText(const GridResult& grid) {
    double low = 1e300, high = -1e300;
    for (const auto& p : grid.points) low = std::min(low, p.position.z), high = std::max(high, p.position.z);
    if (high < low) return "–";
    return high - low < 1e-3 ? "z = " + lengthText(low) : "z = " + formatNumber(low, 3) + " to " + lengthText(high);
}

std::string requirementText(const GridResult& grid) {
    std::string text;
    for (const auto& requirement : grid.requirements) {
        if (!text.empty()) text += "; ";
        text += requirement.name;
        if (!requirement.source.empty()) text += " (" + requirement.source + ")";
    }
    return text.empty() ? "none" : text;
}

std::vector<NamedText> gridFacts(const GridResult& grid) {
    std::vector<NamedText> facts;
    if (grid.columns > 0)
        facts.push_back({"Points", fmt::format("{} × {} = {}, spacing {} × {}", grid.columns, grid.rows, grid.points.size(),
                                               lengthText(grid.spacingU), lengthText(grid.spacingV))});
    else
        facts.push_back({"Points", fmt::format("{} free points", grid.points.size())});
    if (grid.columns > 0)
        facts.push_back({"Border left out", grid.borderM > 0 ? lengthText(grid.borderM) + " along every edge" : "none"});
    facts.push_back({"Height", heightText(grid)});
    facts.push_back({"Maximum", formatGridLux(grid.maximumLux) + " lx"});
    facts.push_back({"Requirement", requirementText(grid)});
    const auto buried = std::count_if(grid.points.begin(), grid.points.end(), [](const auto& p) { return p.insideSolid; });
    if (buried > 0)
        facts.push_back({"Please check", fmt::format("points that seem to lie inside solid objects: {} (values in "
                                                     "brackets). Look at the surface's height and border.", buried)});
    return facts;
}

/// A bar of the direct and the indirect share.
void drawSplit(Document& document, const GridResult& grid, double width) {
    auto& canvas = document.canvas();
    const auto split = splitOf(grid);
    const double whole = split.direct + split.indirect;
    if (!(whole > 0) || !std::isfinite(whole)) return;
    const double share = split.direct / whole, y = document.y;
    canvas.fillRect({sheet::kLeft, y, width * share, 2.4}, ink::kAccent);
    canvas.fillRect({sheet::kLeft + width * share, y, width * (1 - share), 2.4}, ink::kLight);
    canvas.text(sheet::kLeft, y + 6, line(fmt::format("Direct {} lx · {}", formatNumber(split.direct, 3), formatPercent(share))),
                type::kLabel.with(ink::kAccent));
    canvas.text(sheet::kLeft + width, y + 6,
                line(fmt::format("Indirect {} lx · {}", formatNumber(split.indirect, 3), formatPercent(1 - share))),
                type::kLabel.aligned(Align::Right));
    document.y += 10;
}

/// Facts beside the key plan: names 26 mm, texts to the end of the third column.
void drawFactsNarrow(Document& document, const std::vector<NamedText>& facts, double width) {
    auto& canvas = document.canvas();
    for (const auto& fact : facts) {
        auto words = line(fact.text);
        auto lines = canvas.wrap(words, width - 28, type::kBody);
        if (lines.size() > 4) lines = lines.mid(0, 4), lines.last() += " …";
        canvas.stroke(sheet::kLeft, document.y, sheet::kLeft + width, document.y, ink::kLight, 0.2);
        canvas.text(sheet::kLeft, document.y + 4, line(fact.name), type::kLabel);
        double baseline = document.y + 4;
        for (const auto& row : lines) {
            canvas.text(sheet::kLeft + 28, baseline, row, type::kBody);
            baseline += Canvas::lineHeight(type::kBody);
        }
        document.y += 1.6 + lines.size() * Canvas::lineHeight(type::kBody);
    }
}

void drawPlace(Document& document, const GridResult& grid, double top) {
    auto& canvas = document.canvas();
    const double x = sheet::column(3);
    canvas.text(x, top + 2.4, "Place in the room", type::kLabel);
    canvas.stroke(x, top + 4.4, sheet::kRight, top + 4.4, ink::kBlack, 0.35);
    drawKeyPlan(canvas, {x, top + 7, sheet::kColumn, 42}, document.contents().plan, grid);
}

void drawSurface(Document& document, const GridResult& grid) {
    auto& canvas = document.canvas();
    std::vector<double> values;
    for (const auto& p : grid.points) values.push_back(knownLux(p.total));
    const auto range = roundRange(values);
    const bool plan = GridPlane::of(grid).plan;
    canvas.text(sheet::kLeft, 43.2, quantity(grid) + (plan ? " in lx, seen from above" : " in lx, seen from the front"), type::kSmall);
    const auto drawing = drawGrid(canvas, {sheet::kLeft, 46, sheet::kTextWidth, 124}, document.contents().plan, grid, range);
    drawColourBar(canvas, sheet::kLeft, 174, 92, range, "lx");
    drawScaleBar(canvas, drawing.scale, sheet::column(3) - 15, 177);
    drawAxes(canvas, sheet::kRight - 10, 179, plan ? "x" : "", plan ? "y" : "z");
    if (drawing.everyColumn > 1 || drawing.everyRow > 1)
        canvas.text(sheet::kRight, 43.2,
                    line(fmt::format("Values are printed for every {}column and every {}row", ordinal(drawing.everyColumn),
                                     ordinal(drawing.everyRow))),
                    type::kSmall.aligned(Align::Right));
    document.y = 189;
    const double width = sheet::column(3) - sheet::kGutter - sheet::kLeft;
    const double top = document.y;
    drawStatistics(document, grid);
    document.y -= 1;
    drawSplit(document, grid, width);
    drawFactsNarrow(document, gridFacts(grid), width);
    drawPlace(document, grid, top);
}

std::string vectorText(const Vec3d& v, int decimals) {
    return fmt::format("{}  {}  {}", formatFixed(v.x, decimals), formatFixed(v.y, decimals), formatFixed(v.z, decimals));
}

void drawFreePoints(Document& document, const GridResult& grid) {
    const double width = sheet::column(3) - sheet::kGutter - sheet::kLeft;
    const double top = document.y;
    drawStatistics(document, grid);
    drawSplit(document, grid, width);
    drawFactsNarrow(document, gridFacts(grid), width);
    drawPlace(document, grid, top);
    document.y = std::max(document.y, top + 52) + 6;
    std::vector<TableRow> rows;
    for (std::size_t i = 0; i < grid.points.size(); ++i) {
        const auto& p = grid.points[i];
        rows.push_back({{{QString::number(i + 1), type::kLabel},
                         {line(vectorText(p.position, 2))},
                         {line(vectorText(p.normal, 2))},
                         {line(formatInterval(p.total)), type::kStrong},
                         {line(formatInterval(p.direct))},
                         {line(formatInterval(p.indirect))}}});
    }
    document.heading("Points", 14);
    drawTable(document,
              {{"No.", 12}, {"Position x y z, m", 42}, {"Facing x y z", 38}, {quantity(grid) + " lx", 28}, {"Direct lx", 25}, {"Indirect lx", 25}},
              rows);
}

}  // namespace

void drawGridPage(Document& document, std::size_t index) {
    const auto& grids = document.contents().solve.grids;
    const auto& grid = grids[index];
    document.startPage(line(fmt::format("Calculation surface {} of {}", index + 1, grids.size())), gridTitle(grid, index));
    document.remember(gridKey(index));
    const bool surface = grid.columns > 0 && grid.rows > 0 &&
                         grid.points.size() == static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
    surface ? drawSurface(document, grid) : drawFreePoints(document, grid);
}

}  // namespace luxdeck::report

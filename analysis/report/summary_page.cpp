#include "analysis/report/summary_page.h"

#include "analysis/report/number_format.h"

#include <fmt/format.h>

namespace luxdeck::report {

VerdictCount VerdictCount::of(const SolveResult& solve) {
    VerdictCount count;
    for (const auto& grid : solve.grids)
        for (const auto* judged : {&grid.mean, &grid.minimum, &grid.uniformity}) {
            if (judged->verdict == Verdict::Met) ++count.met;
            if (judged->verdict == Verdict::NotMet) ++count.notMet;
            if (judged->verdict == Verdict::Undecided) ++count.undecided;
        }
    return count;
}

std::string gridKey(std::size_t index) { return fmt::format("grid {}", index); }

namespace {

void drawCount(Canvas& canvas, double x, double y, int number, Verdict verdict, const QString& words) {
    const QColor colour = number > 0 ? verdictColour(verdict) : ink::kLight;
    canvas.stroke(x, y, x + sheet::kColumn, y, colour, 0.9);
    canvas.text(x - 0.6, y + 14, QString::number(number), {34, QFont::Bold, colour});
    if (number > 0) canvas.verdictSymbol(x + 1.9, y + 19.4, 3.8, verdict);
    canvas.text(x + (number > 0 ? 5.4 : 0), y + 20.5, words, {9, QFont::DemiBold, number > 0 ? colour : ink::kGrey});
}

void drawCounts(Document& document) {
    auto& canvas = document.canvas();
    const auto count = VerdictCount::of(document.contents().solve);
    if (count.asked() == 0) {
        document.y += canvas.paragraph(sheet::kLeft, document.y, sheet::kTextWidth,
                                       "No requirement is set in this project: the values below are reported without a verdict.",
                                       {10}) + 5;
        return;
    }
    const double y = document.y;
    drawCount(canvas, sheet::column(0), y, count.met, Verdict::Met, "met");
    drawCount(canvas, sheet::column(1), y, count.notMet, Verdict::NotMet, "not met");
    drawCount(canvas, sheet::column(2), y, count.undecided, Verdict::Undecided, "undecided");
    const auto& solve = document.contents().solve;
    const double x = sheet::column(3);
    canvas.stroke(x, y, x + sheet::kColumn, y, ink::kBlack, 0.9);
    canvas.text(x - 0.3, y + 10.5, line(formatSeconds(solve.seconds)), {16, QFont::Bold});
    canvas.text(x, y + 15.6, "of solving", type::kLabel);
    canvas.text(x, y + 20.5, line(formatCount(solve.samples) + " paths"), type::kLabel);
    document.y += 31;
}

TableRow statisticRow(const QString& surface, const QString& name, const JudgedInterval& judged,
                      const std::string& unit, const QString& page) {
    TableRow row;
    row.opensGroup = !surface.isEmpty();
    row.cells = {{surface, type::kStrong},
                 {name},
                 {judged.required ? line("≥ " + formatNumber(*judged.required) + unit) : QString("–")},
                 {line(formatInterval(judged.interval) + unit), type::kStrong},
                 verdictCell(judged.verdict),
                 {page, type::kSmall}};
    return row;
}

std::vector<TableRow> gridRows(const Document& document) {
    std::vector<TableRow> rows;
    const auto& grids = document.contents().solve.grids;
    for (std::size_t i = 0; i < grids.size(); ++i) {
        const auto& grid = grids[i];
        const auto name = line(grid.name.empty() ? fmt::format("Surface {}", i + 1) : grid.name);
        const auto page = document.pageOf(gridKey(i));
        rows.push_back(statisticRow(name, "Mean Ēm", grid.mean, " lx", page));
        rows.push_back(statisticRow({}, "Minimum Emin", grid.minimum, " lx", {}));
        rows.push_back(statisticRow({}, "Uniformity Uo", grid.uniformity, "", {}));
    }
    return rows;
}

void note(Document& document, const QString& title, const QString& text) {
    auto& canvas = document.canvas();
    const double width = sheet::kTextWidth - sheet::kColumn - sheet::kGutter;
    const double height = canvas.wrap(text, width, type::kBody).size() * Canvas::lineHeight(type::kBody) + 2.5;
    document.turnUnlessFits(height);
    canvas.text(sheet::kLeft, document.y + 2.7, title, type::kStrong);
    canvas.paragraph(sheet::column(1), document.y, width, text, type::kBody);
    document.y += height;
}

void drawNotes(Document& document) {
    const auto& solve = document.contents().solve;
    note(document, "± interval",
         "Each value is an estimate; the true value of the model lies within ± the interval with 95 % probability. It "
         "covers the computation's own noise, not the uncertainty of products, reflectances or workmanship.");
    if (VerdictCount::of(solve).undecided > 0)
        note(document, "Undecided",
             "The required value lies inside the interval, so this run can say neither met nor not met. A longer run or a "
             "smaller target error narrows the interval until it can.");
    if (const auto withheld = withheldPoints(solve); withheld > 0)
        note(document, "Withheld",
             line("Something in the scene has no value, and too many samples of " + formatCount(withheld) +
                  " points met it: their numbers, and all that rests on them, are not known."));
    else if (!solve.complete)
        note(document, "Incomplete",
             line("The solve was interrupted after " + formatSeconds(solve.seconds) +
                  ". Values and intervals are those of the samples taken until then."));
    if (solve.complete && !solve.targetReached)
        note(document, "Target not reached",
             line("The time ran out before the target error of " + formatPercent(solve.targetError) +
                  " was reached; the intervals tell what was reached."));
    for (const auto& text : document.contents().info.notes) note(document, "Note", line(text));
}

}  // namespace

void drawSummary(Document& document) {
    document.startPage("Summary", "Requirements and results");
    drawCounts(document);
    const auto rows = gridRows(document);
    if (rows.empty()) {
        document.y += document.canvas().paragraph(sheet::kLeft, document.y, sheet::kTextWidth,
                                                  "This project has no calculation surfaces.", type::kBody) + 5;
    } else {
        drawTable(document,
                  {{"Surface", 48}, {"Statistic", 29}, {"Required", 22}, {"Computed, 95 % interval", 34}, {"Verdict", 27}, {"Page", 10}},
                  rows);
    }
    drawNotes(document);
}

}  // namespace luxdeck::report

#include "analysis/report/photometric_sheet.h"

#include "analysis/report/drawing_file.h"
#include "analysis/report/number_format.h"
#include "analysis/report/photometric_drawing.h"
#include "engine/core/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace luxdeck {

namespace {

using namespace report;

// A4 across [mm].
constexpr double kWidth = 297, kHeight = 210, kLeft = 15, kRight = 282;
constexpr double kPlotTop = 40, kPlotBottom = 152, kPlotWidth = 126;
constexpr double kFactsTop = 158, kFactRowMm = 9.4;
constexpr int kFactRows = 4;

using Fact = std::pair<QString, QString>;

QString degrees(const std::optional<double>& value) { return value ? line(formatNumber(*value, 3) + "°") : "–"; }

QString openingOf(const LuminousOpening& o) {
    if (o.shape == OpeningShape::Point) return "point";
    const auto mm = [](double metres) { return formatFixed(1000 * metres, 0); };
    const bool round = o.shape == OpeningShape::Disc || o.shape == OpeningShape::Cylinder || o.shape == OpeningShape::Sphere;
    auto size = round ? "Ø " + mm(o.lengthM) : mm(o.lengthM) + " × " + mm(o.widthM);
    if (o.heightM > 0 && o.shape != OpeningShape::Sphere) size += " × " + mm(o.heightM);
    return line(std::string(openingText(o.shape)) + ", " + size + " mm");
}

QString shareOf(double part, double whole) {
    return line(formatFixed(part, 0) + " lm" + (whole > 0 ? ", " + formatFixed(100 * part / whole, 1) + " %" : ""));
}

/// Column by column, kFactRows each.
std::vector<Fact> factsOf(const CheckedFile& checked) {
    const auto& p = checked.photometry;
    const auto& f = checked.facts;
    const auto& t = p.table;
    const auto deviation = std::min({f.deviation.axial, f.deviation.about0, f.deviation.about90});
    return {
        {"Luminous flux, integrated", line(formatFixed(f.lumens, 0) + " lm")},
        {"Declared", f.declaredRatio ? line(formatFixed(p.lumensDeclared, 0) + " lm, ratio " + fmt::format("{:.3f}", *f.declaredRatio)) : "none"},
        {"Downwards", shareOf(f.lumensDown, f.lumens)},
        {"Upwards", shareOf(f.lumensUp, f.lumens)},
        {"Maximum", line(formatNumber(f.peak.candela, 5) + " cd")},
        {"Towards", line(fmt::format("γ {:.4g}°, C {:.4g}°", f.peak.gammaDegrees, f.peak.planeDegrees))},
        {"Beam angle, 50 %", degrees(f.c0.beamDegrees) + " in C0, " + degrees(f.c90.beamDegrees) + " in C90"},
        {"Field angle, 10 %", degrees(f.c0.fieldDegrees) + " in C0, " + degrees(f.c90.fieldDegrees) + " in C90"},
        {"Symmetry, stored", symmetryText(p.symmetry)},
        {"Symmetry, measured", line(fmt::format("{}, off by {:.2f} %", symmetryText(f.measured), 100 * deviation))},
        {"Luminous opening", openingOf(p.opening)},
        {"Angles", QString("%1 γ × %2 C, type %3").arg(t.vertical().size()).arg(t.horizontal().size()).arg(typeText(t.type()))},
        {"Power", p.watts > 0 ? line(formatNumber(p.watts, 4) + " W") : "not given"},
        {"Efficacy", f.efficacy ? line(formatFixed(*f.efficacy, 0) + " lm/W") : "–"},
        {"Photometry", line(p.format + (p.absolute ? ", absolute" : ", relative"))},
        {"Lamp", p.lamp.empty() ? "–" : line(p.lamp)},
    };
}

void drawHead(Canvas& canvas, const CheckedFile& checked) {
    const auto& p = checked.photometry;
    canvas.text(kLeft, 15, "Photometry", {8, QFont::DemiBold, ink::kAccent});
    const auto title = p.name.empty() ? line("Luminaire without a name") : line(p.name);
    auto style = type::kTitle;
    while (style.sizePt > 13 && canvas.textWidth(title, style) > kRight - kLeft) style.sizePt -= 0.5;
    canvas.text(kLeft - 0.4, 24.5, canvas.elided(title, kRight - kLeft, style), style);
    const auto file = std::filesystem::path(checked.file).filename().string();
    const auto about = line(p.manufacturer.empty() ? file : p.manufacturer + "  ·  " + file);
    canvas.text(kLeft, 30, canvas.elided(about, kRight - kLeft, type::kBody), type::kBody.with(ink::kGrey));
    canvas.stroke(kLeft, 33, kRight, 33, ink::kBlack, 0.5);
}

void drawFacts(Canvas& canvas, const CheckedFile& checked) {
    const auto facts = factsOf(checked);
    constexpr int kColumns = 4;
    const double column = (kRight - kLeft) / kColumns;
    for (int row = 0; row < kFactRows; ++row) {
        const double y = kFactsTop + kFactRowMm * row;
        canvas.stroke(kLeft, y, kRight, y, row == 0 ? ink::kBlack : ink::kLight, row == 0 ? 0.35 : 0.2);
        for (int c = 0; c < kColumns; ++c) {
            const auto& [name, value] = facts[static_cast<std::size_t>(c * kFactRows + row)];
            const double x = kLeft + column * c;
            canvas.text(x, y + 3.4, name, type::kLabel);
            canvas.text(x, y + 7.6, canvas.elided(value, column - 3, type::kStrong), type::kStrong);
        }
    }
}

void drawFoot(Canvas& canvas, const CheckedFile& checked) {
    const auto& p = checked.photometry;
    canvas.stroke(kLeft, kFactsTop + kFactRowMm * kFactRows, kRight, kFactsTop + kFactRowMm * kFactRows, ink::kLight, 0.2);
    const auto program = line(fmt::format("Luxdeck {}  ·  {}", kVersion, p.fileHash));
    const double space = kRight - kLeft - canvas.textWidth(program, type::kSmall) - 8;
    auto note = "Flux: " + checked.facts.fluxJudgement;
    if (!p.repairs.empty()) note += fmt::format("  ·  {} repaired", p.repairs.size());
    const auto rows = canvas.wrap(line(note), space, type::kSmall);
    for (int i = 0; i < std::min<int>(2, rows.size()); ++i) {
        const auto text = i == 1 && rows.size() > 2 ? canvas.elided(rows[1] + " " + rows[2], space, type::kSmall) : rows[i];
        canvas.text(kLeft, 201 + i * Canvas::lineHeight(type::kSmall), text, type::kSmall.with(ink::kBlack));
    }
    canvas.text(kRight, 201, program, type::kSmall.aligned(Align::Right));
}

void drawSheet(Canvas& canvas, const CheckedFile& checked) {
    canvas.fillRect({0, 0, kWidth, kHeight}, ink::kWhite);
    drawHead(canvas, checked);
    const double second = kRight - kPlotWidth;
    canvas.text(kLeft, kPlotTop, "Polar curve, cd", type::kHeading);
    canvas.text(second, kPlotTop, "Intensity over γ by C plane, cd", type::kHeading);
    const auto& table = checked.photometry.table;
    drawPolar(canvas, {kLeft, kPlotTop + 3, kPlotWidth, kPlotBottom - kPlotTop - 3}, polarCurve(table));
    drawPlaneCurves(canvas, {second, kPlotTop + 3, kPlotWidth, kPlotBottom - kPlotTop - 3}, table);
    drawFacts(canvas, checked);
    drawFoot(canvas, checked);
}

QString titleOf(const CheckedFile& checked) {
    return line(checked.photometry.name.empty() ? checked.file : checked.photometry.name);
}

}  // namespace

Result<std::string> photometricSheet(const CheckedFile& checked, SheetFormat format) {
    return drawingFile({titleOf(checked), kWidth, kHeight, [&](Canvas& canvas) { drawSheet(canvas, checked); }}, format);
}

}  // namespace luxdeck

#include "analysis/report/compare_drawing.h"

#include "analysis/compare/compare_output.h"
#include "analysis/report/number_format.h"
#include "tonemap/colour_map.h"
#include "tonemap/isolines.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace luxdeck::report {

namespace {

constexpr double kScaleMm = 14;     // of the colours' scale, below the plans
constexpr double kHeadMm = 6.5;     // of an algorithm's name above its plan
constexpr double kGapMm = 6;
constexpr double kPlanLeastMm = 20, kPlanMostMm = 75;
constexpr double kDotMost = 0.95, kDotLeast = 0.45;  // radius [mm]

/// The part of the room that has points, seen from above.
struct Extent {
    double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
    [[nodiscard]] double width() const { return std::max(x1 - x0, 0.1); }
    [[nodiscard]] double height() const { return std::max(y1 - y0, 0.1); }
};

Extent extentOf(const Comparison& c) {
    Extent e;
    for (const auto& grid : c.grids)
        for (std::size_t i = 0; i < grid.x.size(); ++i)
            e.x0 = std::min(e.x0, grid.x[i]), e.x1 = std::max(e.x1, grid.x[i]), e.y0 = std::min(e.y0, grid.y[i]), e.y1 = std::max(e.y1, grid.y[i]);
    return e;
}

QColor colourAt(double t) {
    const auto c = tonemap::colourAt(tonemap::ColourMap::Balance, t);
    return {c[0], c[1], c[2]};
}

/// The nearest distance of two points of a grid, from above [m]: its dots must not cover each other.
double spacingOf(const ComparedGrid& grid) {
    double least = 1e300;
    for (std::size_t i = 1; i < grid.x.size(); ++i)
        for (const std::size_t j : {i - 1, i - std::min(i, static_cast<std::size_t>(std::max(grid.columns, 1)))}) {
            const double d = std::hypot(grid.x[i] - grid.x[j], grid.y[i] - grid.y[j]);
            if (d > 1e-6) least = std::min(least, d);
        }
    return least;
}

/// A plan of one algorithm's errors. Wide grids are drawn first, so that the task areas in them stay visible.
void drawPlan(Canvas& canvas, const QRectF& area, const Comparison& c, const std::string& algorithm, double range) {
    const auto extent = extentOf(c);
    const double margin = kDotMost + 1, scale = std::min((area.width() - 2 * margin) / extent.width(), (area.height() - 2 * margin) / extent.height());
    canvas.fillRect(area, ink::kPale);
    const QPointF corner(area.center().x() - extent.width() * scale / 2, area.center().y() + extent.height() * scale / 2);
    std::vector<const ComparedGrid*> grids;
    for (const auto& grid : c.grids) grids.push_back(&grid);
    std::ranges::stable_sort(grids, std::greater<>{}, [](const auto* grid) { return spacingOf(*grid); });
    for (const auto* grid : grids) {
        const auto map = std::ranges::find_if(c.maps, [&](const auto& m) { return m.algorithm == algorithm && m.grid == grid->name; });
        if (map == c.maps.end() || map->errors.size() != grid->x.size()) continue;
        const double radius = std::clamp(0.42 * spacingOf(*grid) * scale, kDotLeast, kDotMost);
        for (std::size_t i = 0; i < grid->x.size(); ++i) {
            const double x = corner.x() + (grid->x[i] - extent.x0) * scale, y = corner.y() - (grid->y[i] - extent.y0) * scale;
            canvas.disc(x, y, radius + 0.08, ink::kGrey);
            canvas.disc(x, y, radius, colourAt(0.5 + 0.5 * map->errors[i] / range));
        }
    }
}

std::vector<std::string> shownIn(const Comparison& c) {
    std::vector<std::string> shown;
    for (const auto& algorithm : c.algorithms)
        if (std::ranges::any_of(c.maps, [&](const auto& map) { return !map.grid.empty() && map.algorithm == algorithm.name; })) shown.push_back(algorithm.name);
    return shown;
}

/// Plans side by side, all of one size.
struct PlansLayout {
    int columns = 1, rows = 1;
    QSizeF plan;
    double cellHeight = 0;
};

PlansLayout layoutOf(const Comparison& c, std::size_t count, double widthMm) {
    const auto extent = extentOf(c);
    PlansLayout out;
    out.columns = count <= 1 ? 1 : count <= 4 ? 2 : 3;
    out.rows = (static_cast<int>(count) + out.columns - 1) / out.columns;
    const double width = (widthMm + kGapMm) / out.columns - kGapMm;
    out.plan = {width, std::clamp(width * extent.height() / extent.width(), kPlanLeastMm, kPlanMostMm)};
    out.cellHeight = kHeadMm + out.plan.height() + kGapMm;
    return out;
}

void drawScale(Canvas& canvas, const QPointF& at, double range) {
    constexpr double kWidth = 92, kHeight = 3;
    constexpr int kSteps = 256;
    QImage bar(kSteps, 1, QImage::Format_RGB32);
    for (int i = 0; i < kSteps; ++i) bar.setPixelColor(i, 0, colourAt((i + 0.5) / kSteps));
    canvas.image(at, {kWidth, 0}, {0, kHeight}, bar, false);
    const auto label = type::kSmall.aligned(Align::Centre);
    for (const double value : tonemap::roundLevels(-100 * range, 100 * range, 10, false)) {
        const double x = at.x() + kWidth * (0.5 + 0.005 * value / range);
        canvas.stroke(x, at.y() + kHeight, x, at.y() + kHeight + 1, ink::kGrey, 0.2);
        canvas.text(x, at.y() + kHeight + 3.9, line((value > 0 ? "+" : value < 0 ? "−" : "") + formatNumber(std::abs(value), 3)), label);
    }
    canvas.text(at.x() + kWidth + 5, at.y() + 2.5, "error in %: blue too dark, red too bright; the ends stand for more", type::kLabel);
}

}  // namespace

double errorPlansHeightMm(const Comparison& c, double widthMm) {
    const auto shown = shownIn(c);
    if (shown.empty()) return 0;
    const auto layout = layoutOf(c, shown.size(), widthMm);
    return layout.rows * layout.cellHeight + kScaleMm;
}

void drawErrorPlans(Canvas& canvas, QPointF at, double widthMm, const Comparison& c) {
    const auto shown = shownIn(c);
    if (shown.empty()) return;
    const auto layout = layoutOf(c, shown.size(), widthMm);
    const double range = errorRange(c, "grids");
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const int column = static_cast<int>(i) % layout.columns, row = static_cast<int>(i) / layout.columns;
        const double x = at.x() + (layout.plan.width() + kGapMm) * column, y = at.y() + layout.cellHeight * row;
        canvas.text(x, y + 4, line(shown[i]), type::kHeading.with(colourOf(c, shown[i])));
        drawPlan(canvas, {QPointF(x, y + kHeadMm), layout.plan}, c, shown[i], range);
    }
    drawScale(canvas, {at.x(), at.y() + layout.rows * layout.cellHeight + 3}, range);
}

}  // namespace luxdeck::report

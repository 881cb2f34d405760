#include "analysis/grids/grid_results.h"

#include "analysis/grids/solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace luxdeck {

namespace {

PointResult pointResult(const GridLayout& layout, std::size_t index, const PointSums& sums) {
    PointResult point;
    point.position = layout.points[index];
    point.normal = layout.normals[index];
    point.samples = sums.samples();
    if (sums.perReplicate == 0) {
        point.total.ci95 = point.direct.ci95 = point.indirect.ci95 = std::numeric_limits<double>::infinity();
        return point;
    }
    point.direct = sums.interval(sums.directMeans());
    point.indirect = sums.interval(sums.indirectMeans());
    point.total = sums.total();
    point.total.value = point.direct.value + point.indirect.value;  // exactly: the parts make the whole
    point.insideSolid = sums.backFaces * 2 > sums.samples();
    return point;
}

/// The strictest limit that any of the requirements sets.
template <class Member>
std::optional<double> strictest(const std::vector<Requirement>& requirements, Member member) {
    std::optional<double> limit;
    for (const auto& r : requirements)
        if (r.*member) limit = limit ? std::max(*limit, *(r.*member)) : *(r.*member);
    return limit;
}

JudgedInterval judged(const Interval& interval, std::optional<double> required) {
    return {interval, required, judge(interval, required)};
}

/// The mean over a grid whose points' errors go together: each replicate is a realisation of the whole grid.
Interval meanOfGrids(std::span<const PointSums> sums) {
    std::array<double, kReplicates> means{};
    for (const auto& s : sums) {
        const auto point = s.totalMeans();
        for (std::size_t r = 0; r < kReplicates; ++r) means[r] += point[r] / static_cast<double>(sums.size());
    }
    return meanOfReplicates(means);
}

/// What was not seen at the points, in the statistics of them all. The mean has the mean of it. The smallest can be no
/// more than the smallest upper end, and where the darkest point is not known, all that may be it have a part.
void addUnseen(GridInterval& statistics, std::span<const PointSums> sums) {
    double sum = 0, most = 0;
    for (const auto& s : sums) sum += s.unseen(), most = std::max(most, s.unseen());
    if (most == 0) return;
    const double ofMean = sum / static_cast<double>(sums.size());
    double lowestTop = std::numeric_limits<double>::infinity();
    for (const auto& s : sums) lowestTop = std::min(lowestTop, s.total().high());
    const double ofMinimum = std::min(most, std::max(0.0, lowestTop - statistics.minimum.high()));
    const auto mean = statistics.mean, uniformity = statistics.uniformity;
    statistics.mean = mean.widenedAbove(ofMean);
    statistics.minimum = statistics.minimum.widenedAbove(ofMinimum);
    const Interval unknown{uniformity.value, std::numeric_limits<double>::infinity()};
    if (!(mean.value > 0) || !std::isfinite(ofMean)) {
        statistics.uniformity = unknown;
        return;
    }
    const double lessBy = uniformity.value * ofMean / (mean.value + ofMean);
    statistics.uniformity = Interval::sides(uniformity.value, uniformity.below() + lessBy,
                                            uniformity.above() + ofMinimum / mean.value);
}

void addStatistics(GridResult& grid, std::span<const PointSums> sums, PointErrors errors) {
    Interval unknown{0, std::numeric_limits<double>::infinity()};
    GridInterval statistics{unknown, unknown, unknown, 0};
    const bool known = std::all_of(sums.begin(), sums.end(), [](const auto& s) { return s.perReplicate > 0; });
    if (known && !sums.empty()) {
        std::vector<double> replicates;
        replicates.reserve(sums.size() * kReplicates);
        for (const auto& s : sums)
            for (const double mean : s.totalMeans()) replicates.push_back(mean);
        statistics = gridInterval(replicates, sums.size());
        if (errors == PointErrors::GoTogether) statistics.mean = meanOfGrids(sums);
        addUnseen(statistics, sums);
    }
    grid.mean = judged(statistics.mean, strictest(grid.requirements, &Requirement::meanLux));
    grid.minimum = judged(statistics.minimum, strictest(grid.requirements, &Requirement::minimumLux));
    grid.uniformity = judged(statistics.uniformity, strictest(grid.requirements, &Requirement::uniformity));
    for (const auto& point : grid.points) grid.maximumLux = std::max(grid.maximumLux, point.total.value);
}

}  // namespace

std::vector<GridResult> gridResults(const Project& project, const std::vector<GridLayout>& layouts,
                                    const std::vector<PointSums>& sums, PointErrors errors) {
    std::vector<GridResult> results;
    std::size_t first = 0;
    for (std::size_t g = 0; g < layouts.size(); ++g) {
        const auto& layout = layouts[g];
        const auto& spec = project.grids[g];
        const auto own = std::span(sums).subspan(first, layout.points.size());
        first += layout.points.size();
        GridResult grid;
        grid.name = spec.name, grid.kind = spec.kind;
        grid.columns = layout.columns, grid.rows = layout.rows;
        grid.borderM = spec.borderM;
        grid.origin = layout.origin, grid.u = layout.u, grid.v = layout.v;
        if (layout.columns > 0) grid.spacingU = layout.u.length() / layout.columns;
        if (layout.rows > 0) grid.spacingV = layout.v.length() / layout.rows;
        grid.requirements = spec.requirements;
        for (std::size_t i = 0; i < own.size(); ++i) grid.points.push_back(pointResult(layout, i, own[i]));
        addStatistics(grid, own, errors);
        results.push_back(std::move(grid));
    }
    return results;
}

double relativeError(const Interval& interval) { return interval.relative(); }

double pointError(const GridResult& grid, const PointResult& point) {
    const double scale = std::max(point.total.value, kDarkPoint * grid.mean.interval.value);
    return Interval{scale, point.total.ci95}.relative();
}

double largestStatisticError(const std::vector<GridResult>& grids) {
    double largest = 0;
    for (const auto& grid : grids) {
        if (grid.columns > 0)
            for (const auto* s : {&grid.mean, &grid.minimum, &grid.uniformity}) {
                // A grid that is certainly dark has no uniformity: no sample will ever make it known.
                const bool dark = grid.mean.interval.value == 0 && grid.mean.interval.ci95 == 0;
                if (!(dark && s == &grid.uniformity)) largest = std::max(largest, relativeError(s->interval));
            }
        else
            for (const auto& point : grid.points) largest = std::max(largest, pointError(grid, point));
    }
    return largest;
}

double rmsPointError(const std::vector<GridResult>& grids) {
    double sum = 0;
    std::size_t count = 0;
    for (const auto& grid : grids)
        for (const auto& point : grid.points) {
            const double e = pointError(grid, point);
            sum += e * e, ++count;
        }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace luxdeck

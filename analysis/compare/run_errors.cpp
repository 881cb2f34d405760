#include "analysis/compare/run_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace luxdeck {

namespace {

constexpr std::size_t kWorst = 5;  // values that are named
constexpr double kSurely = 2;      // half-widths: one false alarm in some thousand comparisons of an unbiased algorithm

/// A grid's (or picture's) first value: each has one at column 0 of row 0.
bool opens(const Place& place) { return place.column == 0 && place.row == 0; }

}  // namespace

Field meanOf(const std::vector<Field>& repetitions) {
    Field mean(repetitions.front().size());
    for (const auto& field : repetitions)
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += field[i] / static_cast<double>(repetitions.size());
    return mean;
}

std::vector<ErrorMap> mapsOf(const Subject& subject, const std::string& algorithm, const Field& errors) {
    std::vector<ErrorMap> maps;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const auto place = subject.placeOf(i);
        if (opens(place)) maps.push_back({subject.name(), algorithm, place.grid, 0, 0, {}});
        auto& map = maps.back();
        map.columns = std::max(map.columns, place.column + 1), map.rows = std::max(map.rows, place.row + 1);
        map.errors.push_back(errors[i]);
    }
    return maps;
}

Field relativeErrors(const ReferenceFields& reference, const Field& values) {
    auto errors = reference.mean();
    for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = (values[i] - errors[i]) / reference.scale[i];
    return errors;
}

void enterErrors(const RunErrors& errors, ComparedRun& run) {
    if (const auto rms = errors.rms()) run.rms = rms->value, run.rmsCi95 = rms->ci95;
    run.rmsAtMost = errors.rmsAtMost();
    if (const auto bias = errors.bias()) run.bias = bias->value, run.biasCi95 = bias->ci95;
    run.meanError = errors.mean.value, run.meanErrorCi95 = errors.mean.ci95;
    run.max = errors.largest, run.p99 = errors.percentile99;
}

void addPlaces(const Subject& subject, const ReferenceFields& reference, const std::string& algorithm, const std::vector<Field>& repetitions, Comparison& c) {
    const auto truth = reference.mean(), variance = reference.variance(), value = meanOf(repetitions);
    const auto errors = relativeErrors(reference, value);
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto count = std::min(kWorst, order.size());
    std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(count), [&](std::size_t a, std::size_t b) {
        return std::abs(errors[a]) != std::abs(errors[b]) ? std::abs(errors[a]) > std::abs(errors[b]) : a < b;
    });
    const double t = studentT95(static_cast<double>(reference.parts.size()) - 1);
    for (std::size_t w = 0; w < count; ++w) {
        const auto i = order[w];
        const auto place = subject.placeOf(i);
        c.worst.push_back({subject.name(), algorithm, place.grid, place.position, place.column, place.row, truth[i], t * std::sqrt(variance[i]), value[i], errors[i]});
    }
    std::ranges::move(mapsOf(subject, algorithm, errors), std::back_inserter(c.maps));
}

void addGrids(const Subject& subject, Comparison& c) {
    for (std::size_t i = 0; i < subject.size() && !subject.isPicture(); ++i) {
        const auto place = subject.placeOf(i);
        if (opens(place)) c.grids.push_back({place.grid, 0, 0, {}, {}, {}});
        auto& grid = c.grids.back();
        grid.columns = std::max(grid.columns, place.column + 1), grid.rows = std::max(grid.rows, place.row + 1);
        grid.x.push_back(place.position.x), grid.y.push_back(place.position.y), grid.z.push_back(place.position.z);
    }
}

void addWarnings(Comparison& c) {
    for (const auto& r : c.reference)
        if (r.relativeError > r.asked * (1 + 1e-9))
            c.warnings.push_back(fmt::format("the reference of {} is known to {:.2g} %, {:.2g} % was asked for", r.subject, 100 * r.relativeError, 100 * r.asked));
    for (const auto& run : c.runs) {
        const bool largest = std::ranges::none_of(c.runs, [&](const auto& other) { return other.subject == run.subject && other.algorithm == run.algorithm && other.rung > run.rung; });
        if (!largest) continue;
        if (run.rejected > 0)
            c.warnings.push_back(fmt::format("{} on {}: {} samples met something without a value; errors are of the light "
                                             "that was found before", run.algorithm, run.subject, run.rejected));
        if (!run.rms) c.warnings.push_back(fmt::format("{} on {} is nearer to the truth than the reference is known to be: its error is at most {:.2g} %", run.algorithm, run.subject, 100 * run.rmsAtMost));
        const auto algorithm = std::ranges::find(c.algorithms, run.algorithm, &ComparedAlgorithm::name);
        if (run.bias && algorithm != c.algorithms.end() && algorithm->interreflection && *run.bias - kSurely * run.biasCi95 > algorithm->claimedBias)
            c.warnings.push_back(fmt::format("{} on {} is off by {:.2g} ± {:.2g} % however often it is repeated; it claims {:.2g} %", run.algorithm, run.subject, 100 * *run.bias, 100 * run.biasCi95,
                                             100 * algorithm->claimedBias));
    }
}

}  // namespace luxdeck

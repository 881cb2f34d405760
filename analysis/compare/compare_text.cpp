#include "analysis/compare/compare_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

std::string percent(double fraction) { return fmt::format("{:.3g}", 100 * fraction); }
std::string percent(const std::optional<double>& fraction) { return fraction ? percent(*fraction) : ""; }

/// A cell: quoted where it must be.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string bytesText(std::uint64_t bytes) {
    if (bytes == 0) return "–";
    return bytes < 10'000'000 ? fmt::format("{:.2g} MB", static_cast<double>(bytes) * 1e-6) : fmt::format("{:.0f} MB", static_cast<double>(bytes) * 1e-6);
}

std::string runRow(const ComparedRun& r) {
    const auto rms = r.rms ? fmt::format("{:.3g} ± {:.2g}", 100 * *r.rms, 100 * r.rmsCi95) : fmt::format("< {:.2g}", 100 * r.rmsAtMost);
    const auto bias = r.bias ? fmt::format("{:.2g} ± {:.2g}", 100 * *r.bias, 100 * r.biasCi95) : "none seen";
    return fmt::format("  {:<18} {:>8.3g} {:>8.2g} {:>9} {:>14} {:>8.3g} {:>8.3g} {:>14} {:>9}\n", r.algorithm, r.seconds, r.setupSeconds, r.samples, rms, 100 * r.p99, 100 * r.max, bias,
                       bytesText(r.preparedBytes));
}

std::string timeText(const TimeTo& t) {
    switch (t.how) {
        case Reached::Interpolated: return fmt::format("{:.3g} s", t.seconds);
        case Reached::AtOnce: return fmt::format("≤ {:.3g} s", t.seconds);
        case Reached::NotReached: break;
    }
    return "not reached";
}

/// fmt counts characters that take several bytes as one in width only from version 8 on; all here do.
std::string summaryRows(const Comparison& c, const std::string& subject) {
    std::string text = fmt::format("\n  {:<18} {:>5} {:>16} {:>12} {:>12} {:>12} {:>12}\n", "algorithm", "place", "slope", "to 10 %", "5 %", "2 %", "1 %");
    for (const auto& place : c.order) {
        if (place.subject != subject) continue;
        const auto of = [&](const auto& x) { return x.subject == subject && x.algorithm == place.algorithm; };
        const auto slope = std::ranges::find_if(c.slopes, of);
        text += fmt::format("  {:<18} {:>5} {:>16}", place.algorithm, place.place, slope == c.slopes.end() ? "–" : fmt::format("{:.2f} ± {:.2f}", std::round(100 * slope->slope) / 100 + 0.0, slope->ci95));
        for (const auto& time : c.timeTo)
            if (of(time)) text += fmt::format(" {:>12}", timeText(time.time));
        text += "\n";
    }
    return text;
}

std::string worstRows(const Comparison& c, const std::string& subject) {
    std::string text, last;
    for (const auto& w : c.worst) {
        if (w.subject != subject || w.algorithm == last) continue;  // the first of each
        last = w.algorithm;
        const auto place = w.grid.empty() ? fmt::format("pixel {}, {}", w.column, w.row) : fmt::format("{} at {:.2f} {:.2f} {:.2f}", w.grid, w.position.x, w.position.y, w.position.z);
        text += fmt::format("  {:<18} {:+.3g} %: {}, {:.4g} instead of {:.4g} ± {:.2g} {}\n", w.algorithm, 100 * w.error, place, w.value, w.reference, w.referenceCi95,
                            w.grid.empty() ? "cd/m²" : "lx");
    }
    return text.empty() ? "" : "\n  furthest off at the largest budget:\n" + text;
}

}  // namespace

std::string runsCsv(const Comparison& c) {
    std::string text = "subject,algorithm,rung,budget_s,seconds,setup_s,samples,effort,rms_percent,rms_ci95_percent,rms_at_most_percent,p99_percent,max_percent,bias_percent,bias_ci95_percent,"
                       "mean_error_percent,mean_error_ci95_percent,prepared_bytes,peak_bytes,rejected\n";
    for (const auto& r : c.runs)
        text += fmt::format("{},{},{},{:.5g},{:.5g},{:.5g},{},{:.4g},{},{},{},{},{},{},{},{},{},{},{},{}\n", cell(r.subject), r.algorithm, r.rung, r.budgetSeconds, r.seconds, r.setupSeconds,
                            r.samples, r.effort, percent(r.rms), r.rms ? percent(r.rmsCi95) : "", percent(r.rmsAtMost), percent(r.p99), percent(r.max), percent(r.bias), r.bias ? percent(r.biasCi95) : "",
                            percent(r.meanError), percent(r.meanErrorCi95), r.preparedBytes, r.peakBytes, r.rejected);
    return text;
}

std::string errorsCsv(const Comparison& c) {
    std::string text = "subject,algorithm,grid,column,row,x,y,z,error_percent\n";
    for (const auto& map : c.maps) {
        const auto grid = std::ranges::find(c.grids, map.grid, &ComparedGrid::name);
        const bool point = !map.grid.empty() && grid != c.grids.end() && grid->x.size() == map.errors.size();
        for (std::size_t i = 0; i < map.errors.size(); ++i)
            text += fmt::format("{},{},{},{},{},{},{:.4g}\n", cell(map.subject), map.algorithm, cell(map.grid), i % static_cast<std::size_t>(map.columns), i / static_cast<std::size_t>(map.columns),
                                point ? fmt::format("{:.6g},{:.6g},{:.6g}", grid->x[i], grid->y[i], grid->z[i]) : ",,", 100 * map.errors[i]);
    }
    return text;
}

namespace {

std::string volumeRows(const Comparison& c) {
    if (c.volumes.empty()) return {};
    std::string text = "\nvolumes: irradiance over all directions of all vertices, against path\n";
    text += fmt::format("  {:<18} {:<9} {:>8} {:>9} {:>9} {:>8} {:>8} {:>8} {:>9}\n", "algorithm", "part", "time s", "mean lx", "path lx", "rms %", "99th %", "max %", "noise %");
    for (const auto& v : c.volumes)
        text += fmt::format("  {:<18} {:<9} {:>8.1f} {:>9.4g} {:>9.4g} {:>8.2f} {:>8.2f} {:>8.1f} {:>9.2f}\n", v.algorithm, v.part, v.seconds, v.meanLux, v.referenceMeanLux, 100 * v.rms, 100 * v.p99,
                            100 * v.max, 100 * v.noise);
    return text;
}

}  // namespace

std::string compareText(const Comparison& c) {
    std::string text = fmt::format("{}: {} algorithms, {} repetitions of each run, seed {}, {:.0f} s{}\n", c.project, c.algorithms.size(), c.repetitions, c.seed, c.seconds,
                                   c.complete ? "" : ", incomplete: interrupted");
    for (const auto& reference : c.reference) {
        text += fmt::format("\n{}: {} {}, reference by {} known to {:.2g} % (95 %), {} paths each, {:.1f} s{}\n", reference.subject, reference.values, reference.picture ? "pixels" : "points",
                            reference.algorithm, 100 * reference.relativeError, reference.samples, reference.seconds, reference.reused ? ", reused" : "");
        if (c.coreTime) text += "  times are seconds of all cores together\n";
        text += fmt::format("  {:<18} {:>8} {:>8} {:>9} {:>14} {:>8} {:>8} {:>14} {:>9}\n", "algorithm", "time s", "set-up s", "samples", "rms error %", "99th %", "max %", "bias %", "prepared");
        for (const auto& run : c.runs)
            if (run.subject == reference.subject) text += runRow(run);
        text += summaryRows(c, reference.subject) + worstRows(c, reference.subject);
    }
    text += volumeRows(c);
    text += "\nErrors are relative to the value, in the dark to a tenth of the mean; intervals are 95 %. The reference's own noise is taken out of rms and bias, not of the 99th percentile and the largest error.\n";
    for (const auto& warning : c.warnings) text += "warning: " + warning + "\n";
    return text;
}

}  // namespace luxdeck

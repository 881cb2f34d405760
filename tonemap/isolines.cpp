#include "tonemap/isolines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace luxdeck::tonemap {

namespace {

/// An edge of the grid: 2 * sample for the one to its right, + 1 for the one below it. A line crosses it once.
using EdgeId = std::uint64_t;

struct Segment {
    EdgeId from = 0;
    EdgeId to = 0;
};

/// One level's lines over one field.
class LevelTracer {
public:
    LevelTracer(std::span<const double> values, int columns, int rows, double level)
        : values_(values), columns_(columns), rows_(rows), level_(level) {}

    void trace(std::vector<Isoline>& out) {
        for (int row = 0; row + 1 < rows_; ++row)
            for (int column = 0; column + 1 < columns_; ++column) addCell(column, row);
        join(out);
    }

private:
    [[nodiscard]] std::size_t sample(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    void addCell(int column, int row) {
        // Corners clockwise from the upper left; edge i runs from corner i to the next.
        const std::array<std::size_t, 4> corners{sample(column, row), sample(column + 1, row),
                                                 sample(column + 1, row + 1), sample(column, row + 1)};
        const std::array<EdgeId, 4> edges{2 * corners[0], 2 * corners[1] + 1, 2 * corners[3], 2 * corners[0] + 1};
        unsigned above = 0;
        double sum = 0;
        for (unsigned i = 0; i < 4; ++i) {
            const double v = values_[corners[i]];
            if (!std::isfinite(v)) return;
            sum += v;
            if (v >= level_) above |= 1U << i;
        }
        const auto add = [&](unsigned from, unsigned to) { segments_.push_back({edges[from], edges[to]}); };
        // A line begins where the border, walked clockwise, falls below the level and ends where it rises, so
        // that the higher side is on its right with rows downwards.
        const auto rises = [&](unsigned i) { return (above >> i & 1U) == 0 && (above >> ((i + 1) % 4) & 1U) == 1; };
        const auto falls = [&](unsigned i) { return (above >> i & 1U) == 1 && (above >> ((i + 1) % 4) & 1U) == 0; };
        const bool saddle = above == 5 || above == 10;
        const bool centreAbove = sum / 4 >= level_;
        for (unsigned i = 0; i < 4; ++i) {
            if (!falls(i)) continue;
            // Walking on clockwise from the fall cuts off the low corner; walking back cuts off the high one.
            unsigned partner = i;
            const unsigned step = saddle && !centreAbove ? 3 : 1;
            do partner = (partner + step) % 4;
            while (!rises(partner));
            add(i, partner);
        }
    }

    [[nodiscard]] std::array<double, 2> point(EdgeId edge) const {
        const std::size_t a = edge / 2, b = edge % 2 == 0 ? a + 1 : a + static_cast<std::size_t>(columns_);
        const double va = values_[a], vb = values_[b];
        const double t = std::clamp((level_ - va) / (vb - va), 0.0, 1.0);
        const std::size_t rowIndex = a / static_cast<std::size_t>(columns_);
        const auto column = static_cast<double>(a % static_cast<std::size_t>(columns_));
        const auto row = static_cast<double>(rowIndex);
        return edge % 2 == 0 ? std::array{column + t, row} : std::array{column, row + t};
    }

    void append(Isoline& line, EdgeId edge) const {
        const auto p = point(edge);
        if (line.points.empty() || line.points.back() != p) line.points.push_back(p);
    }

    /// Each edge begins at most one segment and ends at most one: lines are chains without branches.
    void join(std::vector<Isoline>& out) {
        std::unordered_map<EdgeId, std::size_t> beginsAt;
        std::unordered_map<EdgeId, bool> isEnd;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            beginsAt[segments_[i].from] = i;
            isEnd[segments_[i].to] = true;
        }
        std::vector<bool> used(segments_.size(), false);
        const auto follow = [&](std::size_t first) {
            Isoline line{level_, false, {}};
            append(line, segments_[first].from);
            for (std::size_t i = first;;) {
                used[i] = true;
                append(line, segments_[i].to);
                const auto next = beginsAt.find(segments_[i].to);
                if (next == beginsAt.end()) break;
                i = next->second;
                if (!used[i]) continue;
                line.closed = true;
                break;
            }
            if (line.closed && line.points.size() > 1 && line.points.front() == line.points.back())
                line.points.pop_back();
            if (line.points.size() >= 2) out.push_back(std::move(line));
        };
        for (std::size_t i = 0; i < segments_.size(); ++i)  // open lines first, from their beginnings
            if (!used[i] && !isEnd.contains(segments_[i].from)) follow(i);
        for (std::size_t i = 0; i < segments_.size(); ++i)
            if (!used[i]) follow(i);
    }

    std::span<const double> values_;
    int columns_;
    int rows_;
    double level_;
    std::vector<Segment> segments_;
};

/// 1, 2 or 5 times a power of ten, at least `step`.
double roundStep(double step) {
    const double decade = std::pow(10.0, std::floor(std::log10(step)));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * decade >= step * (1 - 1e-9)) return m * decade;
    return 10 * decade;
}

}  // namespace

std::vector<Isoline> isolines(std::span<const double> values, int columns, int rows, std::span<const double> levels) {
    std::vector<Isoline> out;
    if (columns < 2 || rows < 2 || values.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
        return out;
    for (const double level : levels)
        if (std::isfinite(level)) LevelTracer(values, columns, rows, level).trace(out);
    return out;
}

std::vector<double> roundLevels(double low, double high, int count, bool logarithmic) {
    std::vector<double> out;
    if (!(low < high) || !std::isfinite(low) || !std::isfinite(high) || (logarithmic && !(low > 0)) || count < 1)
        return out;
    constexpr double kSlack = 1e-9;  // the ends themselves count
    if (!logarithmic) {
        const double step = roundStep((high - low) / count);
        for (double i = std::ceil(low / step - kSlack) + 0.0; i * step <= high + kSlack * step; ++i)
            out.push_back(i * step);  // + 0.0: no -0
        return out;
    }
    const double decades = std::log10(high / low);
    const int every = std::max(1, static_cast<int>(std::ceil(decades / count)));
    const bool between = 3 * decades <= count + 1;
    for (int d = static_cast<int>(std::floor(std::log10(low))); d <= std::ceil(std::log10(high)); ++d) {
        for (const double m : {1.0, 2.0, 5.0}) {
            if (m > 1 && !between) continue;
            if (!between && d % every != 0) continue;
            const double level = m * std::pow(10.0, d);
            if (level >= low * (1 - kSlack) && level <= high * (1 + kSlack)) out.push_back(level);
        }
    }
    return out;
}

}  // namespace luxdeck::tonemap

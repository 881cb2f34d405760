#include "analysis/compare/comparison.h"

#include <algorithm>
#include <array>

namespace luxdeck {

namespace {

constexpr std::array<double, 4> kErrors{0.1, 0.05, 0.02, 0.01};

void addSlope(Comparison& c, const std::string& subject, const std::string& algorithm, const std::vector<CurvePoint>& curve) {
    const auto slope = logLogSlope(curve);
    if (slope) c.slopes.push_back({subject, algorithm, slope->value, slope->ci95, static_cast<int>(curve.size())});
}

/// Algorithms side by side at the time of the one whose largest run ended first.
void addOrder(Comparison& c, const std::string& subject, const std::vector<std::string>& names, const std::vector<std::vector<CurvePoint>>& curves) {
    if (curves.empty()) return;
    double seconds = curves.front().back().seconds;
    for (const auto& curve : curves) seconds = std::min(seconds, curve.back().seconds);
    std::vector<CurvePoint> there;
    for (const auto& curve : curves) there.push_back(errorAt(curve, seconds));
    const auto place = places(there);
    for (std::size_t i = 0; i < names.size(); ++i) c.order.push_back({subject, names[i], place[i], seconds, there[i].rms});
    std::stable_sort(c.order.end() - static_cast<std::ptrdiff_t>(names.size()), c.order.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
}

}  // namespace

std::vector<CurvePoint> curveOf(const Comparison& c, const std::string& subject, const std::string& algorithm) {
    std::vector<CurvePoint> curve;
    for (const auto& run : c.runs)
        if (run.subject == subject && run.algorithm == algorithm && run.rms && *run.rms > 0 && run.seconds > 0)
            curve.push_back({run.seconds, *run.rms, run.rmsCi95 / *run.rms});
    std::ranges::stable_sort(curve, {}, &CurvePoint::seconds);
    return curve;
}

void summarize(Comparison& c) {
    c.slopes.clear(), c.timeTo.clear(), c.order.clear();
    for (const auto& reference : c.reference) {
        std::vector<std::string> names;
        std::vector<std::vector<CurvePoint>> curves;
        for (const auto& algorithm : c.algorithms) {
            auto curve = curveOf(c, reference.subject, algorithm.name);
            addSlope(c, reference.subject, algorithm.name, curve);
            for (const double error : kErrors) c.timeTo.push_back({reference.subject, algorithm.name, error, timeToError(curve, error)});
            if (curve.empty()) continue;
            names.push_back(algorithm.name);
            curves.push_back(std::move(curve));
        }
        addOrder(c, reference.subject, names, curves);
    }
}

}  // namespace luxdeck

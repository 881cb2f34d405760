#include "analysis/stability/stability_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace luxdeck {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

std::string lux(double x) { return fmt::format("{:.5g}", x); }

std::string expectedText(const Criterion& c) {
    if (!c.refusal.empty()) return "refused";
    return c.lux ? lux(*c.lux) : "finite";
}

std::string deviationText(const StabilityResult& r) {
    if (!r.expected.lux || !r.refused.empty()) return "";
    const double deviation = r.lux.value - *r.expected.lux;
    return *r.expected.lux > 0 ? fmt::format("{:+.2f} %", 100 * deviation / *r.expected.lux) : fmt::format("{:+.2g} lx", deviation);
}

std::string row(const StabilityResult& r, bool first, std::size_t width) {
    const std::string value = r.refused.empty() ? fmt::format("{} ± {:.2g}", lux(r.lux.value), r.lux.ci95) : "refused";
    return fmt::format("{:<{}}  {:<11}  {:>19}  {:>8}  {:>9}  {:>8}  {:>8.1g}  {:>5.2f}  {}\n", first ? r.name : "", width, r.algorithm, value,
                       expectedText(r.expected), deviationText(r), r.counters.rejected, r.truncatedFraction(), r.seconds, verdictText(r.verdict));
}

}  // namespace

std::string stabilityText(const std::vector<StabilityResult>& results) {
    std::size_t width = 4;
    for (const auto& r : results) width = std::max(width, r.name.size());
    std::string text = fmt::format("{:<{}}  {:<11}  {:>19}  {:>8}  {:>9}  {:>8}  {:>8}  {:>5}  {}\n", "case", width, "algorithm", "value, lx", "expected",
                                   "deviation", "rejected", "cut off", "s", "verdict");
    std::string last, notes;
    std::set<std::string> said;
    for (const auto& r : results) {
        text += row(r, r.name != last, width);
        last = r.name;
        if (!r.refused.empty() && said.insert(r.name + r.refused).second) notes += fmt::format("{}: refused: {}\n", r.name, r.refused);
        if (r.verdict != StabilityVerdict::Met)
            notes += fmt::format("{}, {}: {}: expected {} within {:.2g} lx and {:g} standard errors ({})\n", r.name, r.algorithm, verdictText(r.verdict),
                                 expectedText(r.expected), r.expected.slackLux, kStabilitySigmas, r.expected.why);
    }
    const auto met = std::count_if(results.begin(), results.end(), [](const auto& r) { return r.verdict == StabilityVerdict::Met; });
    return text + "\n" + notes + fmt::format("{} of {} met. Intervals are 95 %; met: within {:g} standard errors and the slack of the case.\n", met, results.size(), kStabilitySigmas);
}

Json stabilityJson(const std::vector<StabilityResult>& results) {
    Json out = Json::array();
    for (const auto& r : results) {
        const bool refused = !r.refused.empty();
        out.push_back({{"case", r.name}, {"algorithm", r.algorithm}, {"verdict", verdictText(r.verdict)},
                       {"lx", refused ? Json(nullptr) : number(r.lux.value)}, {"ci95", refused ? Json(nullptr) : number(r.lux.ci95)},
                       {"expected", r.expected.lux ? number(*r.expected.lux) : Json(nullptr)}, {"slack", r.expected.slackLux},
                       {"why", r.expected.why}, {"refused", refused ? Json(r.refused) : Json(nullptr)},
                       {"samples", r.counters.paths}, {"rejectedSamples", r.counters.rejected},
                       {"truncatedFraction", r.truncatedFraction()}, {"seconds", r.seconds}});
    }
    return out;
}

bool allMet(const std::vector<StabilityResult>& results) {
    return std::all_of(results.begin(), results.end(), [](const auto& r) { return r.verdict == StabilityVerdict::Met || r.verdict == StabilityVerdict::KnownLimit; });
}

}  // namespace luxdeck

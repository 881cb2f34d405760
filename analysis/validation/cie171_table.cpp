#include "analysis/validation/cie171_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace luxdeck {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

constexpr const char* kFooter =
    "Validated against the analytical cases of CIE 171:2006, section 5, with references worked out anew: no printed table is\n"
    "used (that of 5.7 was made for another geometry). Sizes of rooms and points are our own. Masks of 5.13 and 5.14 have an\n"
    "even luminance, in the reference and in the scene. Section 4 (measured rooms) is left out: its data set is not in our hands.\n";

/// Name and size of the row with the largest deviation of each case.
std::string largestDeviations(const std::vector<Cie171Row>& rows) {
    std::string text = fmt::format("{:<5} {:>5} {:>10}  {}\n", "case", "rows", "largest", "subject");
    for (std::size_t i = 0; i < rows.size();) {
        std::size_t end = i;
        double most = 0;
        bool refused = false;
        for (; end < rows.size() && rows[end].number == rows[i].number; ++end) {
            refused = refused || !rows[end].refused.empty();
            if (std::abs(rows[end].deviation()) > std::abs(most)) most = rows[end].deviation();
        }
        text += fmt::format("{:<5} {:>5} {:>10}  {}\n", rows[i].number, end - i, refused ? "refused" : fmt::format("{:+.2f} %", 100 * most), rows[i].subject);
        i = end;
    }
    return text;
}

std::string line(const Cie171Row& r, std::size_t width) {
    const std::string value = r.refused.empty() ? fmt::format("{:.5g} ± {:.2g}", r.value.value, r.value.ci95) : "refused";
    const std::string deviation = r.refused.empty() ? fmt::format("{:+.2f} %", 100 * r.deviation()) : "";
    return fmt::format("  {:<{}}  {:<6}  {:>18} {:<2}  {:>9.5g}  {:>9}  {}{}\n", r.point, width, r.algorithm, value, r.unit, r.reference.value, deviation,
                       verdictText(r.verdict), r.reference.note.empty() ? "" : "; " + r.reference.note);
}

}  // namespace

std::string cie171Text(const std::vector<Cie171Row>& rows) {
    std::size_t width = 5;
    for (const auto& r : rows) width = std::max(width, r.point.size());
    std::string text = fmt::format("  {:<{}}  {:<6}  {:>18} {:<2}  {:>9}  {:>9}  {}\n", "point", width, "by", "value", "", "reference", "deviation", "verdict");
    std::string last, notes;
    double worstReference = 0;
    for (const auto& r : rows) {
        const auto title = fmt::format("{} {}: {}\n", r.number, r.subject, r.configuration);
        if (title != last) text += title, last = title;
        text += line(r, width);
        worstReference = std::max(worstReference, r.reference.error / r.reference.value);
        if (!r.refused.empty()) notes += fmt::format("{} {}, {}: refused: {}\n", r.number, r.configuration, r.algorithm, r.refused);
        else if (r.verdict != Cie171Verdict::Within)
            notes += fmt::format("{} {}, {}, {}: {}: {:.5g} ± {:.2g}, expected {:.5g}\n", r.number, r.configuration, r.point, r.algorithm, verdictText(r.verdict),
                                 r.value.value, r.value.ci95, r.reference.value);
    }
    const auto within = std::count_if(rows.begin(), rows.end(), [](const auto& r) { return r.verdict == Cie171Verdict::Within; });
    return text + "\n" + largestDeviations(rows) + "\n" + notes +
           fmt::format("{} of {} within {:g} % or {:g} standard errors of the reference. Intervals are 95 %; references by quadrature are good to {:.1g} %.\n",
                       within, rows.size(), 100 * kCie171Tolerance, kCie171Sigmas, 100 * worstReference) + kFooter;
}

Json cie171Json(const std::vector<Cie171Row>& rows) {
    Json out = Json::array();
    for (const auto& r : rows) {
        const bool refused = !r.refused.empty();
        out.push_back({{"case", r.number}, {"subject", r.subject}, {"configuration", r.configuration}, {"point", r.point}, {"algorithm", r.algorithm},
                       {"unit", r.unit}, {"value", refused ? Json(nullptr) : number(r.value.value)}, {"ci95", refused ? Json(nullptr) : number(r.value.ci95)},
                       {"reference", r.reference.value}, {"referenceError", r.reference.error},
                       {"deviation", refused ? Json(nullptr) : number(r.deviation())}, {"verdict", verdictText(r.verdict)}, {"note", r.reference.note},
                       {"refused", refused ? Json(r.refused) : Json(nullptr)}});
    }
    return out;
}

bool allWithin(const std::vector<Cie171Row>& rows) {
    return std::all_of(rows.begin(), rows.end(), [](const auto& r) { return r.verdict == Cie171Verdict::Within; });
}

}  // namespace luxdeck

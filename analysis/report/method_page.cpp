#include "analysis/report/method_page.h"

#include "analysis/grids/measurement.h"
#include "analysis/report/number_format.h"

#include <fmt/format.h>

namespace luxdeck::report {

namespace {

std::string rateText(const SolveResult& solve) {
    if (solve.seconds <= 0) return "–";
    return fmt::format("{} million rays/s", formatNumber(static_cast<double>(solve.rays) / solve.seconds / 1e6, 3));
}

std::vector<NamedText> runFacts(const SolveResult& solve) {
    std::vector<NamedText> facts{
        {"Algorithm", solve.algorithm},
        {"Random seed", std::to_string(solve.seed)},
        {"Run time", fmt::format("{} solving, {} loading and building", formatSeconds(solve.seconds), formatSeconds(solve.setupSeconds))}};
    if (solve.predictedSeconds > 0) facts.push_back({"Predicted run time", formatSeconds(solve.predictedSeconds)});
    facts.push_back({"Paths and rays", fmt::format("{} paths, {} rays, {}", formatCount(solve.samples), formatCount(solve.rays), rateText(solve))});
    facts.push_back({"Target error", solve.targetError <= 0 ? "none asked for"
                                     : formatPercent(solve.targetError) + (solve.targetReached ? ", reached" : ", not reached")});
    const auto withheld = withheldPoints(solve);
    facts.push_back({"Complete", solve.complete ? "yes" : withheld > 0 ? "no: numbers are withheld" : "no: interrupted"});
    if (solve.ambientLux != 0) facts.push_back({"Constant ambient term", formatNumber(solve.ambientLux) + " lx added to every value"});
    facts.push_back({"Paths cut off", fmt::format("at most {} of the energy", formatPercent(solve.truncatedFraction))});
    facts.push_back({"Condition", fmt::format("mean reflectance {}, 1/(1–ρ) = {:.1f}; {:.1f} of {} replicates count", formatPercent(solve.condition.meanReflectance),
                                              solve.condition.amplification, solve.condition.effectiveReplicates, kReplicates)});
    facts.push_back({"Failed samples", solve.rejectedSamples == 0 ? "none"
                                       : formatCount(solve.rejectedSamples) +
                                             " met something without a value; the intervals hold what they lack"});
    if (withheld > 0) facts.push_back({"Withheld", formatCount(withheld) + " points, of which too many samples failed"});
    return facts;
}

std::vector<NamedText> originFacts(const ReportContents& contents) {
    const auto& solve = contents.solve;
    std::vector<NamedText> facts{{"Luxdeck", solve.version.empty() ? "–" : solve.version},
                                 {"Ray casting", solve.kernel.empty() ? "–" : solve.kernel},
                                 {"Threads", std::to_string(solve.threads)},
                                 {"Scene hash", solve.sceneHash.empty() ? "–" : solve.sceneHash},
                                 {"Project hash", solve.projectHash.empty() ? "–" : solve.projectHash},
                                 {"Report made", contents.created}};
    facts.insert(facts.end(), contents.facts.begin(), contents.facts.end());
    return facts;
}

void drawLeftOut(Document& document) {
    const auto& leftOut = document.contents().solve.leftOut;
    document.heading("Left out because this scene does not need it", 12);
    if (leftOut.empty()) {
        document.y += document.canvas().paragraph(sheet::kLeft, document.y, sheet::kTextWidth, "Nothing was left out.", type::kBody) + 5;
        return;
    }
    std::vector<NamedText> facts;
    for (const auto& item : leftOut) facts.push_back({item.what, item.why});
    drawFacts(document, facts, sheet::kColumn + sheet::kGutter);
}

void drawWarnings(Document& document) {
    const auto& warnings = document.contents().solve.warnings;
    if (warnings.empty()) return;
    document.heading("Warnings", 12);
    std::vector<TableRow> rows;
    for (std::size_t i = 0; i < warnings.size(); ++i)
        rows.push_back({{{QString::number(i + 1), type::kLabel}, {line(warnings[i])}}});
    drawTable(document, {{"No.", 12}, {"What was seen", sheet::kTextWidth - 12}}, rows);
}

}  // namespace

void drawMethod(Document& document) {
    const auto& contents = document.contents();
    constexpr double kNames = sheet::kColumn + sheet::kGutter;
    document.startPage("Method", "How these numbers were made");
    if (!contents.methodText.empty())
        document.y += document.canvas().paragraph(sheet::kLeft, document.y, sheet::kTextWidth * 0.82, line(contents.methodText), {9.5}) + 4;
    document.heading("Computation", 12);
    drawFacts(document, runFacts(contents.solve), kNames);
    drawLeftOut(document);
    document.heading("Versions and inputs", 12);
    drawFacts(document, originFacts(contents), kNames);
    drawWarnings(document);
}

}  // namespace luxdeck::report

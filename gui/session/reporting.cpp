#include "gui/session/reporting.h"

#include "analysis/compare/compare_output.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace luxdeck::gui {

namespace {

constexpr double kThumbnailDotsPerMm = 2;

std::vector<ReportSection> leftOut(const ReportChoice& choice) {
    std::vector<ReportSection> out;
    if (!choice.grids) out.push_back(ReportSection::Grids);
    if (!choice.schedule) out.push_back(ReportSection::Schedule);
    if (!choice.accuracy) out.push_back(ReportSection::Accuracy);
    if (!choice.method) out.push_back(ReportSection::Method);
    return out;
}

const View* viewNamed(const Project& project, const std::string& name) {
    const auto at = std::find_if(project.views.begin(), project.views.end(), [&](const auto& view) { return view.name == name; });
    return at == project.views.end() ? nullptr : &*at;
}

}  // namespace

/// What a picture depends on, beside the project.
std::string Reporting::keyOf(const ReportChoice& choice, std::size_t view) {
    return fmt::format("{} {} {} {}", choice.views[view], choice.viewAlgorithm, choice.viewSeconds, view == 0 ? 2 : 1);
}

bool Reporting::isQuick(const ReportChoice& choice) const {
    if (!place_.project || !(solving_.current() || (current() && solved_))) return false;
    for (std::size_t i = 0; i < choice.views.size(); ++i)
        if (of_ != place_.project || views_.find(keyOf(choice, i)) == views_.end()) return false;
    return true;
}

Result<Reporting::Made> Reporting::made(const LitProject& project, const ReportChoice& choice, Made before, const std::shared_ptr<const Comparison>& comparison, const Progress& progress) {
    Made out = std::move(before);
    if (!out.solved) {
        auto solved = solve(project.project, project.lit, choice.solve, progress);
        if (!solved) return solved.error();
        out.solved = std::make_shared<const SolveResult>(*std::move(solved));
    }
    ReportParts parts;
    for (std::size_t i = 0; i < choice.views.size() && !progress.cancelled(); ++i) {
        const auto* view = viewNamed(project.project, choice.views[i]);
        if (view == nullptr) continue;
        auto at = out.views.find(keyOf(choice, i));
        if (at == out.views.end()) {
            // In false colour too, always: it is quick to make, and to leave out.
            const ReportViewSettings settings{choice.viewAlgorithm, {}, choice.solve.seed, choice.viewSeconds * (i == 0 ? 2 : 1), i == 0, {}};
            auto rendered = renderReportView(project.project, project.lit, *view, settings, progress);
            if (!rendered) return rendered.error();
            if (!*rendered) break;
            at = out.views.emplace(keyOf(choice, i), **std::move(rendered)).first;
        }
        parts.views.push_back(at->second);
        if (!choice.falseColour) parts.views.back().pages.resize(1);
    }
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, "stopped", {}};
    if (comparison && choice.comparison) parts.comparison = compareJson(*comparison);
    parts.leftOut = leftOut(choice);
    auto pages = PageImages::create(assembleReport(project.project, *out.solved, createdNow(), std::move(parts)));
    if (!pages) return pages.error();
    out.pages = std::make_shared<const PageImages>(*std::move(pages));
    out.thumbnails = out.pages->all(kThumbnailDotsPerMm);
    return out;
}

void Reporting::make(const ReportChoice& choice) {
    if (!place_.project) return;
    cancel();
    follow();
    const bool current = comparing_.current();
    Made before{{}, {}, views_, solving_.current() ? solving_.result() : solved_};
    place_.jobs.start(JobKind::Report, "Making the report",
                      [this, project = place_.project, choice, before, comparison = current ? comparing_.result() : nullptr](const Progress& progress, const Jobs::Tell&) -> Jobs::Delivery {
        auto result = made(*project, choice, before, comparison, progress);
        if (!result) return place_.complaint(result.error());
        return [this, project, all = std::make_shared<Made>(*std::move(result))] { take(project, std::move(*all)); };
    });
    place_.tell(Change::Jobs);
}

void Reporting::take(const std::shared_ptr<const LitProject>& project, Made made) {
    if (project != place_.project) return;  // edited meanwhile
    of_ = project;
    views_ = std::move(made.views);
    solved_ = std::move(made.solved);
    pages_ = std::move(made.pages);
    thumbnails_ = std::move(made.thumbnails);
    page_ = {};
    ++looks_;
    place_.tell(Change::Report);
}

void Reporting::look(std::size_t index, double dotsPerMm) {
    if (!pages_ || index >= pages_->count()) return;
    const auto number = ++looks_;
    place_.jobs.start(JobKind::Look, "Drawing a page", [this, number, pages = pages_, index, dotsPerMm](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
        return [this, number, index, page = std::make_shared<DisplayImage>(pages->page(index, dotsPerMm))] {
            if (number != looks_) return;
            lookedAt_ = index;
            page_ = std::move(*page);
            place_.tell(Change::Report);
        };
    });
}

Result<void> Reporting::save(const std::filesystem::path& pdf) {
    if (!pages_) return Error{ErrorCode::InvalidArgument, "there is no report to export yet", pdf.string()};
    if (lowerExtension(pdf) != ".pdf") return Error{ErrorCode::InvalidArgument, "expected a name that ends in .pdf", pdf.string()};
    place_.save("Exporting " + pdf.filename().string(), "Exported " + pdf.string() + " and its JSON twin", [pages = pages_, pdf] { return writeReport(pages->contents(), pdf); });
    return {};
}

void Reporting::follow() {
    if (of_ == place_.project) return;
    views_.clear();
    solved_.reset();
    place_.tell(Change::Report);
}

void Reporting::clear() {
    of_.reset(), solved_.reset(), pages_.reset();
    views_.clear();
    thumbnails_.clear();
    page_ = {};
    lookedAt_ = 0;
    ++looks_;
    place_.tell(Change::Report);
}

}  // namespace luxdeck::gui

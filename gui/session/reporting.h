#pragma once

#include "analysis/grids/solver.h"
#include "analysis/report/page_images.h"
#include "analysis/report/report_making.h"
#include "gui/session/comparing.h"
#include "gui/session/solving.h"
#include "gui/session/workplace.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::gui {

/// What goes into a report, beside cover and summary.
struct ReportChoice {
    std::vector<std::string> views;      ///< names, in the report's order; the first is on the cover
    bool falseColour = true;             ///< of the first view
    bool grids = true, schedule = true, accuracy = true, method = true;
    bool comparison = false;             ///< the session's, when it is of this project
    double viewSeconds = 6;              ///< of rendering each; the first takes twice as long
    std::string viewAlgorithm = "path";
    SolveSettings solve;                 ///< where nothing current was solved yet
};

/// The report of the project: made in the background of what was solved, previewed page by page, exported as `luxdeck
/// report` writes it. Pictures of views are kept, so that a change of what goes in costs no new rendering.
class Reporting {
public:
    Reporting(Workplace& place, const Solving& solving, const Comparing& comparing) : place_(place), solving_(solving), comparing_(comparing) {}

    /// In the background: solves if nothing current is there, renders views that were not, lays out the pages.
    void make(const ReportChoice& choice);
    void cancel() { place_.jobs.cancel(JobKind::Report); }
    /// make() of it would neither solve nor render.
    [[nodiscard]] bool isQuick(const ReportChoice& choice) const;

    /// What is to be exported; null: nothing was made yet.
    [[nodiscard]] const std::shared_ptr<const PageImages>& pages() const { return pages_; }
    /// All pages, small.
    [[nodiscard]] const std::vector<DisplayImage>& thumbnails() const { return thumbnails_; }
    /// Of the project as it is now.
    [[nodiscard]] bool current() const { return pages_ && of_ == place_.project; }

    /// Draws a page in the background: page() is it soon.
    void look(std::size_t index, double dotsPerMm);
    /// Which page page() is.
    [[nodiscard]] std::size_t lookedAt() const { return lookedAt_; }
    /// The page that was asked for last, or the one before while it is being drawn; empty: none.
    [[nodiscard]] const DisplayImage& page() const { return page_; }

    /// The PDF and its JSON twin beside it, in the background; failures go to the log.
    ///
    /// errors  InvalidArgument: nothing was made yet, another extension
    Result<void> save(const std::filesystem::path& pdf);

    /// The project has changed: pictures of another state are of no use.
    void follow();
    void clear();

private:
    using Views = std::map<std::string, RenderedView>;
    struct Made {
        std::shared_ptr<const PageImages> pages;
        std::vector<DisplayImage> thumbnails;
        Views views;
        std::shared_ptr<const SolveResult> solved;
    };
    [[nodiscard]] static std::string keyOf(const ReportChoice& choice, std::size_t view);
    static Result<Made> made(const LitProject& project, const ReportChoice& choice, Made before, const std::shared_ptr<const Comparison>& comparison, const Progress& progress);
    void take(const std::shared_ptr<const LitProject>& project, Made made);

    Workplace& place_;
    const Solving& solving_;
    const Comparing& comparing_;
    std::shared_ptr<const LitProject> of_;        // of the pages and pictures
    Views views_;                                 // rendered, by keyOf()
    std::shared_ptr<const SolveResult> solved_;   // for the report alone: where the session had nothing current
    std::shared_ptr<const PageImages> pages_;
    std::vector<DisplayImage> thumbnails_;
    std::size_t lookedAt_ = 0;
    std::uint64_t looks_ = 0;                     // the newest counts
    DisplayImage page_;
};

}  // namespace luxdeck::gui

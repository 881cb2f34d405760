#pragma once

#include "analysis/report/canvas.h"
#include "analysis/report/report_contents.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace luxdeck::report {

/// The page's grid, A4 upright [mm].
namespace sheet {
inline constexpr double kWidth = 210, kHeight = 297;
inline constexpr double kLeft = 20, kRight = 190;
inline constexpr double kTextWidth = kRight - kLeft;
inline constexpr double kTop = 46;      // of the content, below the title
inline constexpr double kBottom = 277;  // of the content, above the footer
inline constexpr double kGutter = 5;
inline constexpr double kColumn = (kTextWidth - 3 * kGutter) / 4;  // four columns

/// Left edge of column 0..3.
constexpr double column(int index) { return kLeft + index * (kColumn + kGutter); }
}  // namespace sheet

/// Pages that a first pass over the same contents found: how many, and on which page each key begins.
struct Pagination {
    int pages = 0;
    std::map<std::string, int> pageOf;
};

/// The report while it is laid out, page after page. Every page gets its header and footer; `y` is where
/// the next thing goes. Because totals and references to later pages are printed, the report is laid out
/// twice: the first pass finds the Pagination that the second prints.
class Document {
public:
    /// newPage  what the canvas draws on becomes the next page
    Document(std::function<void()> newPage, Canvas& canvas, const ReportContents& contents, const Pagination* known);

    /// A page without header and footer, for the cover.
    void startCover();
    /// A page with `section` small above `title`; y is below them.
    void startPage(const QString& section, const QString& title);
    /// Goes on on a new page of the same section unless `heightMm` still fits; true when it turned the page.
    bool turnUnlessFits(double heightMm);
    /// A heading at y, kept together with `heightMm` of what follows.
    void heading(const QString& text, double heightMm);

    void remember(const std::string& key) { found_.pageOf[key] = found_.pages; }
    /// The page `remember(key)` was called on, as the first pass saw it; empty during the first pass.
    [[nodiscard]] QString pageOf(const std::string& key) const;

    [[nodiscard]] Canvas& canvas() { return canvas_; }
    [[nodiscard]] const ReportContents& contents() const { return contents_; }
    [[nodiscard]] const Pagination& pagination() const { return found_; }

    double y = 0;  // [mm]

private:
    void turn();
    void incompleteBand();
    void footer();

    std::function<void()> newPage_;
    Canvas& canvas_;
    const ReportContents& contents_;
    const Pagination* known_;
    Pagination found_;
    QString section_, title_;
};

struct TableColumn {
    QString title;  // may hold line ends
    double widthMm = 20;
    Align align = Align::Left;
};

struct TableCell {
    QString text;
    TextStyle style = type::kBody;
    Verdict verdict = Verdict::None;  // drawn as a symbol before the text
};

struct TableRow {
    std::vector<TableCell> cells;
    bool opensGroup = true;  // a rule above it
};

/// Draws a table at document.y; columns' widths should add up to sheet::kTextWidth. Cells wrap; the header
/// is repeated where the table breaks over pages, and a row is never split.
void drawTable(Document& document, const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows);

/// Names and texts in two columns, wrapped, with hairlines; breaks over pages.
void drawFacts(Document& document, const std::vector<NamedText>& facts, double nameWidthMm);

/// A cell that shows a verdict by colour, symbol and word.
TableCell verdictCell(Verdict verdict);

}  // namespace luxdeck::report

#include "analysis/report/page_layout.h"

#include "analysis/report/number_format.h"

#include <algorithm>
#include <utility>

namespace luxdeck::report {

namespace {

constexpr double kCellPadMm = 1.15;   // above and below a row's text
constexpr double kSymbolMm = 3.1;

struct LaidOutRow {
    std::vector<QStringList> lines;
    double heightMm = 0;
};

double textInset(const TableCell& cell) { return cell.verdict == Verdict::None ? 0 : kSymbolMm + 1.4; }

LaidOutRow layOut(const Canvas& canvas, const std::vector<TableColumn>& columns, const TableRow& row) {
    LaidOutRow out;
    for (std::size_t i = 0; i < row.cells.size() && i < columns.size(); ++i) {
        const auto& cell = row.cells[i];
        const double width = std::max(5.0, columns[i].widthMm - 2.5 - textInset(cell));
        out.lines.push_back(canvas.wrap(cell.text, width, cell.style));
        // No cell may outgrow a page; what is longer than that is cut with a mark.
        const int most = static_cast<int>((sheet::kBottom - sheet::kTop - 25) / Canvas::lineHeight(cell.style));
        if (out.lines.back().size() > most) {
            out.lines.back() = out.lines.back().mid(0, most);
            out.lines.back().last() += " …";
        }
        out.heightMm = std::max(out.heightMm, out.lines.back().size() * Canvas::lineHeight(cell.style));
    }
    out.heightMm += 2 * kCellPadMm;
    return out;
}

double anchor(double x, const TableColumn& column) {
    if (column.align == Align::Left) return x;
    return column.align == Align::Right ? x + column.widthMm : x + column.widthMm / 2;
}

QStringList headerLines(const Canvas& canvas, const TableColumn& column) {
    QStringList lines;
    for (const auto& part : column.title.split('\n')) lines << canvas.wrap(part, column.widthMm - 2, type::kLabel);
    return lines;
}

double headerHeight(const Canvas& canvas, const std::vector<TableColumn>& columns) {
    int lines = 1;
    for (const auto& column : columns)
        lines = std::max(lines, static_cast<int>(headerLines(canvas, column).size()));
    return lines * Canvas::lineHeight(type::kLabel) + 1.6;
}

void drawHeader(Document& document, const std::vector<TableColumn>& columns) {
    auto& canvas = document.canvas();
    const double height = headerHeight(canvas, columns);
    double x = sheet::kLeft, right = sheet::kLeft;
    for (const auto& column : columns) right += column.widthMm;
    for (const auto& column : columns) {
        const auto lines = headerLines(canvas, column);
        double y = document.y + height - 2.2 - (lines.size() - 1) * Canvas::lineHeight(type::kLabel);
        for (const auto& text : lines) {
            canvas.text(anchor(x, column), y, text, type::kLabel.aligned(column.align));
            y += Canvas::lineHeight(type::kLabel);
        }
        x += column.widthMm;
    }
    document.y += height;
    canvas.stroke(sheet::kLeft, document.y, right, document.y, ink::kBlack, 0.35);
}

void drawRow(Document& document, const std::vector<TableColumn>& columns, const TableRow& row, const LaidOutRow& laid) {
    auto& canvas = document.canvas();
    double x = sheet::kLeft, cap = 0;  // all cells of a row stand on one baseline
    for (const auto& cell : row.cells) cap = std::max(cap, Canvas::capHeight(cell.style));
    for (std::size_t i = 0; i < laid.lines.size(); ++i) {
        const auto& cell = row.cells[i];
        const double inset = textInset(cell);
        double baseline = document.y + kCellPadMm + cap * 1.25;
        if (inset > 0)
            canvas.verdictSymbol(x + kSymbolMm / 2, baseline - Canvas::capHeight(cell.style) / 2, kSymbolMm, cell.verdict);
        for (const auto& text : laid.lines[i]) {
            canvas.text(anchor(x + inset, columns[i]), baseline, text, cell.style.aligned(columns[i].align));
            baseline += Canvas::lineHeight(cell.style);
        }
        x += columns[i].widthMm;
    }
    document.y += laid.heightMm;
}

double tableRight(const std::vector<TableColumn>& columns) {
    double right = sheet::kLeft;
    for (const auto& column : columns) right += column.widthMm;
    return right;
}

}  // namespace

Document::Document(std::function<void()> newPage, Canvas& canvas, const ReportContents& contents, const Pagination* known)
    : newPage_(std::move(newPage)), canvas_(canvas), contents_(contents), known_(known) {}

void Document::turn() {
    if (found_.pages > 0) newPage_();
    ++found_.pages;
    if (!contents_.solve.complete) incompleteBand();
}

void Document::incompleteBand() {
    canvas_.fillRect({0, 0, sheet::kWidth, 9}, ink::kUndecided);
    canvas_.text(sheet::kLeft, 5.8, "INCOMPLETE RESULT",
                 {8, QFont::Bold, ink::kWhite});
    canvas_.text(sheet::kRight, 5.8,
                 withheldPoints(contents_.solve) > 0
                     ? line("Something has no value: numbers that rest on it are not known.")
                     : line("Interrupted after " + formatSeconds(contents_.solve.seconds) +
                            ". The intervals hold for the samples taken."),
                 {7.5, QFont::Medium, ink::kWhite, Align::Right});
}

void Document::footer() {
    const double rule = 283, baseline = 288;
    canvas_.stroke(sheet::kLeft, rule, sheet::kRight, rule, ink::kLight, 0.2);
    const auto total = known_ != nullptr ? QString(" / %1").arg(known_->pages) : QString();
    const double dateAt = sheet::column(3);
    canvas_.text(sheet::kLeft, baseline,
                 canvas_.elided(line(contents_.info.name), dateAt - sheet::kLeft - 4, type::kSmall), type::kSmall);
    const auto number = QString::number(found_.pages) + total;
    const double numberWidth = canvas_.textWidth(number, type::kSmall);
    canvas_.text(dateAt, baseline,
                 canvas_.elided(line(contents_.info.date.empty() ? contents_.created.substr(0, 10) : contents_.info.date),
                                sheet::kRight - dateAt - numberWidth - 3, type::kSmall), type::kSmall);
    canvas_.text(sheet::kRight, baseline, number, type::kSmall.with(ink::kBlack).aligned(Align::Right));
}

void Document::startCover() { turn(); }

void Document::startPage(const QString& section, const QString& title) {
    turn();
    footer();
    section_ = section;
    title_ = title;
    canvas_.text(sheet::kLeft, 21, section, {8, QFont::DemiBold, ink::kAccent});
    auto style = type::kTitle;
    // A long title shrinks to 13 pt, then takes two lines, then is cut.
    while (style.sizePt > 13 && canvas_.textWidth(title, style) > sheet::kTextWidth) style.sizePt -= 0.5;
    auto lines = canvas_.wrap(title, sheet::kTextWidth, style);
    if (lines.size() > 2) lines = QStringList{lines[0], canvas_.elided(lines[1] + " " + lines[2], sheet::kTextWidth, style)};
    double baseline = lines.size() > 1 ? 29 : 31;
    for (const auto& row : lines) {
        canvas_.text(sheet::kLeft - 0.4, baseline, row, style);
        baseline += Canvas::lineHeight(style) * 0.92;
    }
    canvas_.stroke(sheet::kLeft, 38, sheet::kRight, 38, ink::kBlack, 0.5);
    y = sheet::kTop;
}

bool Document::turnUnlessFits(double heightMm) {
    if (y + heightMm <= sheet::kBottom) return false;
    auto title = title_;
    if (!title.endsWith(" (continued)")) title += " (continued)";
    startPage(section_, title);
    return true;
}

void Document::heading(const QString& text, double heightMm) {
    turnUnlessFits(heightMm + 9);
    canvas_.text(sheet::kLeft, y + 4, text, type::kHeading);
    y += 8;
}

QString Document::pageOf(const std::string& key) const {
    if (known_ == nullptr) return {};
    const auto at = known_->pageOf.find(key);
    return at == known_->pageOf.end() ? QString() : QString::number(at->second);
}

void drawTable(Document& document, const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows) {
    auto& canvas = document.canvas();
    const double header = headerHeight(canvas, columns);
    bool needsHeader = true;
    std::vector<LaidOutRow> all;
    for (const auto& row : rows) all.push_back(layOut(canvas, columns, row));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& row = rows[i];
        const auto& laid = all[i];
        double together = laid.heightMm;  // a group stays on one page when it fits on one
        for (std::size_t j = i + 1; row.opensGroup && j < rows.size() && !rows[j].opensGroup; ++j) together += all[j].heightMm;
        if (together > sheet::kBottom - sheet::kTop - header) together = laid.heightMm;
        if (document.turnUnlessFits(together + (needsHeader ? header : 0))) needsHeader = true;
        const bool first = needsHeader;
        if (needsHeader) drawHeader(document, columns);
        needsHeader = false;
        if (row.opensGroup && !first)
            canvas.stroke(sheet::kLeft, document.y, tableRight(columns), document.y, ink::kLight, 0.2);
        drawRow(document, columns, row, laid);
    }
    canvas.stroke(sheet::kLeft, document.y, tableRight(columns), document.y, ink::kLight, 0.2);
    document.y += 6;
}

void drawFacts(Document& document, const std::vector<NamedText>& facts, double nameWidthMm) {
    auto& canvas = document.canvas();
    const std::vector<TableColumn> columns{{"", nameWidthMm}, {"", sheet::kTextWidth - nameWidthMm}};
    for (const auto& fact : facts) {
        const TableRow row{{{line(fact.name), type::kLabel}, {line(fact.text)}}};
        const auto laid = layOut(canvas, columns, row);
        document.turnUnlessFits(laid.heightMm);
        canvas.stroke(sheet::kLeft, document.y, sheet::kRight, document.y, ink::kLight, 0.2);
        drawRow(document, columns, row, laid);
    }
    document.y += 5;
}

TableCell verdictCell(Verdict verdict) {
    auto style = type::kStrong;
    style.colour = verdictColour(verdict);
    return {line(verdict == Verdict::None ? "–" : verdictText(verdict)), style, verdict};
}

}  // namespace luxdeck::report

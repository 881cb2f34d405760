#include "analysis/report/cover_page.h"

#include "analysis/report/number_format.h"
#include "analysis/report/plan_drawing.h"

#include <algorithm>

namespace luxdeck::report {

const ReportView* coverView(const ReportContents& contents) {
    for (const auto& view : contents.views)
        if (!view.scale) return &view;
    return nullptr;
}

namespace {

const QRectF kPictureFrame{sheet::kLeft, 104, sheet::kWidth - sheet::kLeft, 122};  // bleeds off the right edge

/// Fills the frame with the middle of the picture.
void drawPicture(Canvas& canvas, const QImage& picture) {
    const double wanted = kPictureFrame.width() / kPictureFrame.height();
    const double seen = static_cast<double>(picture.width()) / picture.height();
    QRect part(0, 0, picture.width(), picture.height());
    if (seen > wanted) {
        const int width = std::max(1, static_cast<int>(picture.height() * wanted));
        part = {(picture.width() - width) / 2, 0, width, picture.height()};
    } else {
        const int height = std::max(1, static_cast<int>(picture.width() / wanted));
        part = {0, (picture.height() - height) / 2, picture.width(), height};
    }
    canvas.image(kPictureFrame, picture.copy(part));
}

/// Without a picture the plan stands for the room.
void drawPlanInstead(Canvas& canvas, const RoomPlan& plan) {
    canvas.fillRect(kPictureFrame, ink::kPale);
    const auto bounds = boundsOf(plan);
    if (bounds.empty()) return;
    drawRoom(canvas, PlanScale(bounds, kPictureFrame.adjusted(14, 10, -24, -10)), plan, {0.6, true, false});
}

void drawName(Document& document) {
    auto& canvas = document.canvas();
    const auto name = line(document.contents().info.name.empty() ? "Untitled project" : document.contents().info.name);
    auto style = type::kDisplay;
    auto lines = canvas.wrap(name, sheet::kTextWidth, style);
    while (lines.size() > 3 && style.sizePt > 14) {
        style.sizePt -= 2;
        lines = canvas.wrap(name, sheet::kTextWidth, style);
    }
    if (lines.size() > 4) {
        lines = lines.mid(0, 4);
        lines.last() = canvas.elided(lines.last() + " …", sheet::kTextWidth - 3, style) + "…";
    }
    double baseline = 49;
    for (const auto& row : lines) {
        canvas.text(sheet::kLeft - 0.8, baseline, row, style);
        baseline += Canvas::lineHeight(style) * 0.86;
    }
    baseline += 6 - Canvas::lineHeight(style) * 0.86;  // the description's top: a fixed gap below the last line
    const auto description = line(document.contents().info.description);
    if (description.isEmpty() || baseline > 90) return;
    auto words = canvas.wrap(description, sheet::kTextWidth * 0.72, {11});
    const int most = static_cast<int>((100 - baseline) / Canvas::lineHeight({11}));
    if (words.size() > most) words = words.mid(0, most), words.last() += " …";
    canvas.paragraph(sheet::kLeft, baseline, sheet::kTextWidth * 0.75, words.join(" "), {11, QFont::Normal, ink::kGrey});
}

void drawParties(Document& document) {
    auto& canvas = document.canvas();
    const auto& info = document.contents().info;
    const std::vector<NamedText> parties{{"Client", info.client}, {"Designer", info.designer},
                                         {"Location", info.location}, {"Date", info.date}};
    int index = 0;
    for (const auto& party : parties) {
        const double x = sheet::column(index++);
        canvas.stroke(x, 240, x + sheet::kColumn, 240, ink::kBlack, 0.35);
        canvas.text(x, 245, line(party.name), type::kLabel);
        auto lines = canvas.wrap(line(party.text.empty() ? "–" : party.text), sheet::kColumn, {9});
        if (lines.size() > 5) lines = lines.mid(0, 5), lines.last() = canvas.elided(lines.last() + " …", sheet::kColumn, {9});
        double baseline = 250.5;
        for (const auto& row : lines) {
            canvas.text(x, baseline, row, {9});
            baseline += Canvas::lineHeight({9});
        }
    }
}

}  // namespace

void drawCover(Document& document) {
    document.startCover();
    auto& canvas = document.canvas();
    const auto& contents = document.contents();
    canvas.fillRect({sheet::kLeft, 20, 8, 2.2}, ink::kAccent);
    canvas.text(sheet::kLeft, 29.5, "Lighting report", {11, QFont::DemiBold, ink::kAccent});
    drawName(document);
    QImage picture;
    if (const auto* view = coverView(contents))
        picture = QImage::fromData(reinterpret_cast<const uchar*>(view->png.data()), static_cast<int>(view->png.size()));
    picture.isNull() ? drawPlanInstead(canvas, contents.plan) : drawPicture(canvas, picture);
    if (!contents.solve.complete) {
        canvas.fillRect({sheet::kLeft, 104, 62, 10}, ink::kUndecided);
        canvas.text(sheet::kLeft + 4, 110.4, "Incomplete result", {10.5, QFont::Bold, ink::kWhite});
    }
    drawParties(document);
    canvas.text(sheet::kLeft, 288, line("Luxdeck " + contents.solve.version), type::kSmall);
    canvas.text(sheet::kRight, 288, "Every number with its 95 % interval", type::kSmall.aligned(Align::Right));
}

}  // namespace luxdeck::report

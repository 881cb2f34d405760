#include "analysis/report/views_page.h"

#include "analysis/report/number_format.h"
#include "tonemap/colour_map.h"
#include "tonemap/isolines.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::report {

namespace {

constexpr double kMostPictureMm = 92;  // two landscape pictures share a page

QString captionOf(const ReportView& view) {
    std::string text = view.operatorText;
    const auto add = [&](const std::string& more) { text += (text.empty() ? "" : " ") + more; };
    if (!view.exposure.empty()) add("Exposure: " + view.exposure + ".");
    if (view.seconds > 0) add("Rendered in " + formatSeconds(view.seconds) + ".");
    if (view.relativeError > 0) add("Mean 95 % interval of a pixel: ± " + formatPercent(view.relativeError) + ".");
    return line(text);
}

/// The picture's own scale: equal steps of the legend are equal steps of colour.
void drawScale(Canvas& canvas, double y, const ColourScale& scale) {
    constexpr int kSteps = 256;
    const double width = 92, height = 3;
    QImage bar(kSteps, 1, QImage::Format_RGB32);
    const auto map = tonemap::colourMapNamed(scale.map);
    for (int i = 0; i < kSteps; ++i) {
        const auto c = tonemap::colourAt(map ? *map : tonemap::ColourMap::Dusk, (i + 0.5) / kSteps);
        bar.setPixel(i, 0, qRgb(c[0], c[1], c[2]));
    }
    canvas.image({sheet::kLeft, y}, {width, 0}, {0, height}, bar, false);
    const TextStyle label{6.5, QFont::Normal, ink::kGrey, Align::Centre};
    const bool logarithmic = scale.logarithmic && scale.minimum > 0 && scale.maximum > scale.minimum;
    for (const double value : tonemap::roundLevels(scale.minimum, scale.maximum, 6, logarithmic)) {
        const double t = logarithmic ? std::log(value / scale.minimum) / std::log(scale.maximum / scale.minimum)
                                     : (value - scale.minimum) / (scale.maximum - scale.minimum);
        canvas.stroke(sheet::kLeft + width * t, y + height, sheet::kLeft + width * t, y + height + 1, ink::kGrey, 0.2);
        canvas.text(sheet::kLeft + width * t, y + height + 3.8, line(formatNumber(value, 2)), label);
    }
    canvas.text(sheet::kLeft + width + 5, y + 2.5, line(scale.unit + (logarithmic ? ", logarithmic" : "")),
                {7, QFont::Medium, ink::kGrey});
}

void drawView(Document& document, const ReportView& view) {
    auto& canvas = document.canvas();
    const auto picture = QImage::fromData(reinterpret_cast<const uchar*>(view.png.data()), static_cast<int>(view.png.size()));
    if (picture.isNull()) return;  // writePdf has refused it already
    double width = sheet::kTextWidth;
    double height = width * picture.height() / std::max(picture.width(), 1);
    if (height > kMostPictureMm) width *= kMostPictureMm / height, height = kMostPictureMm;
    width = std::max(width, 0.5), height = std::max(height, 0.5);
    const auto caption = canvas.wrap(captionOf(view), sheet::kTextWidth, type::kSmall);
    const double below = 7 + caption.size() * Canvas::lineHeight(type::kSmall) + (view.scale ? 10 : 0);
    document.turnUnlessFits(height + below);
    view.scale ? canvas.image({sheet::kLeft, document.y}, {width, 0}, {0, height}, picture, true)
               : canvas.image({sheet::kLeft, document.y, width, height}, picture);
    document.y += height + 5;
    const auto heading = line(view.name);
    const double right = std::max(sheet::kLeft + width, sheet::column(2));  // the operator ends with its picture
    const auto name = canvas.elided(heading, (right - sheet::kLeft) * 0.62, type::kStrong);
    canvas.text(sheet::kLeft, document.y, name, type::kStrong);
    canvas.text(right, document.y, line((view.scale ? "" : "Operator: ") + view.operatorName),
                type::kStrong.with(ink::kAccent).aligned(Align::Right));
    document.y += 1.2;
    document.y += canvas.paragraph(sheet::kLeft, document.y, sheet::kTextWidth, captionOf(view), type::kSmall);
    if (view.scale) {
        drawScale(canvas, document.y + 2, *view.scale);
        document.y += 10;
    }
    document.y += 6;
}

}  // namespace

void drawViews(Document& document) {
    const auto& views = document.contents().views;
    if (views.empty()) return;
    document.startPage("Views", "The room as it will be seen");
    for (const auto& view : views) drawView(document, view);
}

}  // namespace luxdeck::report

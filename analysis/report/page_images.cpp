#include "analysis/report/page_images.h"

#include "analysis/report/offscreen.h"
#include "analysis/report/report_drawing.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace luxdeck {

namespace {

using namespace report;

constexpr double kDotsPerMm = kDotsPerInch / 25.4;

DisplayImage displayImageOf(const QImage& page) {
    const auto rgb = page.convertToFormat(QImage::Format_RGB888);
    DisplayImage out{rgb.width(), rgb.height(), {}, {}};
    for (int y = 0; y < rgb.height(); ++y) out.rgb.insert(out.rgb.end(), rgb.constScanLine(y), rgb.constScanLine(y) + 3 * rgb.width());
    return out;
}

/// Laid out in the PDF's dots and scaled to the picture's, so that lines break where they do there.
class Pages {
public:
    /// only  -1: all
    Pages(double dotsPerMm, int only) : scale_(dotsPerMm / kDotsPerMm), only_(only), size_(static_cast<int>(sheet::kWidth * dotsPerMm), static_cast<int>(sheet::kHeight * dotsPerMm)) {
        begin();
    }
    ~Pages() {
        if (painter_.isActive()) painter_.end();
    }
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;

    QPainter& painter() { return painter_; }
    void turn() {
        finish();
        ++page_;
        begin();
    }
    std::vector<DisplayImage> taken() {
        finish();
        return std::move(done_);
    }

private:
    [[nodiscard]] bool wanted() const { return only_ < 0 || page_ == only_; }
    void begin() {
        image_ = QImage(wanted() ? size_ : QSize(1, 1), QImage::Format_RGB32);
        image_.fill(Qt::white);
        painter_.begin(&image_);
        painter_.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        painter_.scale(scale_, scale_);
    }
    void finish() {
        painter_.end();
        if (wanted()) done_.push_back(displayImageOf(image_));
    }

    double scale_;
    int only_, page_ = 0;
    QSize size_;
    QImage image_;
    QPainter painter_;
    std::vector<DisplayImage> done_;
};

}  // namespace

Result<PageImages> PageImages::create(ReportContents contents) {
    ensureApplication();
    if (auto possible = checkReport(contents); !possible) return possible.error();
    if (const auto installed = requireFont(); !installed) return installed.error();
    PageImages out;
    out.contents_ = std::move(contents);
    Pages pages(1, 0);
    Canvas canvas(pages.painter(), kDotsPerMm, reportFontFamily());
    out.pages_ = drawReport(canvas, [&] { pages.turn(); }, out.contents_, nullptr).pages;
    return out;
}

DisplayImage PageImages::page(std::size_t index, double dotsPerMm) const {
    auto one = draw(dotsPerMm, static_cast<int>(index));
    return one.empty() ? DisplayImage{} : std::move(one.front());
}

std::vector<DisplayImage> PageImages::draw(double dotsPerMm, int only) const {
    const auto family = reportFontFamily();
    Pages first(1, 0);  // finds which page is which
    Canvas blank(first.painter(), kDotsPerMm, family);
    const auto known = drawReport(blank, [&] { first.turn(); }, contents_, nullptr);
    Pages pages(std::clamp(dotsPerMm, 1.0, 40.0), only);
    Canvas canvas(pages.painter(), kDotsPerMm, family);
    drawReport(canvas, [&] { pages.turn(); }, contents_, &known);
    return pages.taken();
}

}  // namespace luxdeck

#include "analysis/report/pdf_writer.h"

#include "analysis/compare/compare_output.h"
#include "analysis/report/compare_page.h"
#include "analysis/report/convergence_page.h"
#include "analysis/report/cover_page.h"
#include "analysis/report/method_page.h"
#include "analysis/report/offscreen.h"
#include "analysis/report/page_layout.h"
#include "analysis/report/plan_page.h"
#include "analysis/report/schedule_page.h"
#include "analysis/report/summary_page.h"
#include "analysis/report/views_page.h"
#include "engine/core/file.h"

#include <QBuffer>
#include <QPdfWriter>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace luxdeck {

namespace {

using namespace report;

constexpr int kDotsPerInch = 1200;

void layOut(QPdfWriter& writer, const ReportContents& contents, const QString& family, const Pagination* known,
            Pagination& found) {
    QPainter painter(&writer);
    Canvas canvas(painter, kDotsPerInch / 25.4, family);
    Document document(writer, canvas, contents, known);
    drawCover(document);
    drawSummary(document);
    drawViews(document);
    for (std::size_t i = 0; i < contents.solve.grids.size(); ++i) drawGridPage(document, i);
    drawSchedule(document);
    drawConvergence(document);
    drawComparison(document);
    drawMethod(document);
    found = document.pagination();
}

std::string onePass(const ReportContents& contents, const QString& family, const Pagination* known, Pagination& found) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(0, 0, 0, 0));
        writer.setResolution(kDotsPerInch);
        writer.setTitle(line(contents.info.name + " — lighting report"));
        writer.setCreator(line("Luxdeck " + contents.solve.version));
        layOut(writer, contents, family, known, found);
    }
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

Result<void> checkViews(const ReportContents& contents) {
    for (const auto& view : contents.views) {
        const auto picture = QImage::fromData(reinterpret_cast<const uchar*>(view.png.data()), static_cast<int>(view.png.size()));
        if (picture.isNull())
            return Error{ErrorCode::InvalidArgument, fmt::format("{} bytes that are no picture, expected a PNG", view.png.size()),
                         fmt::format("view \"{}\"", view.name)};
    }
    return {};
}

}  // namespace

Result<std::string> pngBytes(const DisplayImage& image) {
    const auto bytesNeeded = static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0)) * 3;
    if (bytesNeeded == 0 || image.rgb.size() != bytesNeeded)
        return Error{ErrorCode::InvalidArgument, fmt::format("a picture of {} x {} with {} bytes, expected {}", image.width,
                                                             image.height, image.rgb.size(), bytesNeeded)};
    const QImage picture(image.rgb.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG")) return Error{ErrorCode::Internal, "Qt cannot write a PNG"};
    return std::string(bytes.constData(), static_cast<std::size_t>(bytes.size()));
}

Result<std::string> pdfBytes(const ReportContents& contents) {
    ensureApplication();
    const FixedHashOrder fixedOrder;
    if (auto checked = checkViews(contents); !checked) return checked.error();
    if (contents.comparison)
        if (const auto comparison = readCompareJson(*contents.comparison, "comparison"); !comparison) return comparison.error();
    const auto installed = requireFont();
    if (!installed) return installed.error();
    const QString& family = *installed;
    Pagination pages, again;
    onePass(contents, family, nullptr, pages);
    auto pdf = onePass(contents, family, &pages, again);
    fixPdfDate(pdf, contents.created);
    return pdf;
}

Result<void> writePdf(const ReportContents& contents, const std::filesystem::path& path) {
    auto pdf = pdfBytes(contents);
    if (!pdf) return pdf.error();
    return writeFileAtomically(path, std::string_view(*pdf));
}

}  // namespace luxdeck

#include "analysis/report/pdf_writer.h"

#include "analysis/report/offscreen.h"
#include "analysis/report/report_drawing.h"
#include "engine/core/file.h"

#include <QBuffer>
#include <QPdfWriter>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace luxdeck {

namespace {

using namespace report;

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
        QPainter painter(&writer);
        Canvas canvas(painter, kDotsPerInch / 25.4, family);
        found = drawReport(canvas, [&] { writer.newPage(); }, contents, known);
    }
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
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
    if (auto possible = checkReport(contents); !possible) return possible.error();
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

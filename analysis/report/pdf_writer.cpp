#include "analysis/report/pdf_writer.h"

#include "analysis/report/convergence_page.h"
#include "analysis/report/cover_page.h"
#include "analysis/report/method_page.h"
#include "analysis/report/page_layout.h"
#include "analysis/report/plan_page.h"
#include "analysis/report/schedule_page.h"
#include "analysis/report/summary_page.h"
#include "analysis/report/views_page.h"
#include "engine/core/file.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QLoggingCategory>
#include <QHash>
#include <QPdfWriter>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace luxdeck {

namespace {

using namespace report;

constexpr int kDotsPerInch = 1200;

/// Qt needs an application for fonts; the command line has none, the desktop program has its own.
void ensureApplication() {
    if (QCoreApplication::instance() != nullptr) return;
    // Its notes on desktop services ("XDG_RUNTIME_DIR not set") would stand between ours; what matters is in the Result.
    QLoggingCategory::setFilterRules("default.warning=false");
    static int count = 3;
    static char name[] = "luxdeck", option[] = "-platform", platform[] = "offscreen";
    static char* arguments[] = {name, option, platform, nullptr};
    new QGuiApplication(count, arguments);  // kept to the end of the process: Qt allows only one, ever
}

/// Qt writes a PDF's fonts in the order of a hash table, which is random from process to process unless its
/// seed is fixed. Tables that exist keep the seed they were made with, so this disturbs nobody.
class FixedHashOrder {
public:
    FixedHashOrder() { qSetGlobalQHashSeed(0); }
    ~FixedHashOrder() { qSetGlobalQHashSeed(before_ == 0 ? 0 : -1); }
    FixedHashOrder(const FixedHashOrder&) = delete;
    FixedHashOrder& operator=(const FixedHashOrder&) = delete;

private:
    int before_ = qGlobalQHashSeed();
};

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

/// "D:20261122184000" of "2026-11-22T18:40:00Z"; a fixed day when the contents have no date.
std::string pdfDate(const std::string& created) {
    std::string digits;
    std::copy_if(created.begin(), created.end(), std::back_inserter(digits), [](unsigned char c) { return std::isdigit(c); });
    if (digits.size() < 8) digits = "20000101";
    digits.resize(14, '0');
    return "D:" + digits;
}

/// Qt writes the time of writing: puts the contents' own in its place, at the same length, so that the
/// table of offsets at the end of the file stays right.
void fixDate(std::string& pdf, const std::string& created) {
    constexpr std::string_view kKey = "/CreationDate (";
    const auto at = pdf.rfind(kKey);
    if (at == std::string::npos) return;
    const auto begin = at + kKey.size(), end = pdf.find(')', begin);
    auto date = pdfDate(created) + "Z00'00'";
    date.resize(end - begin, ' ');
    pdf.replace(begin, end - begin, date);
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
    const auto family = reportFontFamily();
    if (family.isEmpty())
        return Error{ErrorCode::OutOfResources, "no font is installed, expected Inter or DejaVu Sans (packages fonts-inter, fonts-dejavu-core)"};
    Pagination pages, again;
    onePass(contents, family, nullptr, pages);
    auto pdf = onePass(contents, family, &pages, again);
    fixDate(pdf, contents.created);
    return pdf;
}

Result<void> writePdf(const ReportContents& contents, const std::filesystem::path& path) {
    auto pdf = pdfBytes(contents);
    if (!pdf) return pdf.error();
    return writeFileAtomically(path, std::string_view(*pdf));
}

}  // namespace luxdeck

#include "analysis/report/drawing_file.h"

#include "analysis/report/offscreen.h"
#include "engine/core/file.h"
#include "engine/core/version.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <fmt/format.h>

namespace luxdeck {

namespace report {

namespace {

std::string toText(const QByteArray& bytes) { return {bytes.constData(), static_cast<std::size_t>(bytes.size())}; }

std::string png(const Drawing& drawing, const QString& family) {
    constexpr double kDots = 8;  // a millimetre
    QImage image(static_cast<int>(drawing.widthMm * kDots), static_cast<int>(drawing.heightMm * kDots), QImage::Format_RGB32);
    image.setDotsPerMeterX(static_cast<int>(1000 * kDots));
    image.setDotsPerMeterY(static_cast<int>(1000 * kDots));
    {
        QPainter painter(&image);
        Canvas canvas(painter, kDots, family);
        drawing.draw(canvas);
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return toText(bytes);
}

std::string pdf(const Drawing& drawing, const QString& family) {
    constexpr int kDotsPerInch = 1200;
    const FixedHashOrder fixedOrder;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        // Sizes are given upright: Qt knows A4 across by its orientation alone.
        const bool across = drawing.widthMm > drawing.heightMm;
        const QSizeF upright(across ? drawing.heightMm : drawing.widthMm, across ? drawing.widthMm : drawing.heightMm);
        writer.setPageLayout({QPageSize(upright, QPageSize::Millimeter), across ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)});
        writer.setResolution(kDotsPerInch);
        writer.setTitle(drawing.title);
        writer.setCreator(line(fmt::format("Luxdeck {}", kVersion)));
        QPainter painter(&writer);
        Canvas canvas(painter, kDotsPerInch / 25.4, family);
        drawing.draw(canvas);
    }
    auto text = toText(bytes);
    fixPdfDate(text, {});
    return text;
}

std::string svg(const Drawing& drawing, const QString& family) {
    constexpr double kDots = 20;  // a millimetre: sizes of type are whole dots
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setResolution(static_cast<int>(kDots * 25.4));
        generator.setSize({static_cast<int>(drawing.widthMm * kDots), static_cast<int>(drawing.heightMm * kDots)});
        generator.setViewBox(QRectF(0, 0, drawing.widthMm * kDots, drawing.heightMm * kDots));
        generator.setTitle(drawing.title);
        QPainter painter(&generator);
        Canvas canvas(painter, kDots, family);
        drawing.draw(canvas);
    }
    return toText(bytes);
}

}  // namespace

Result<std::string> drawingFile(const Drawing& drawing, SheetFormat format) {
    ensureApplication();
    const auto family = requireFont();
    if (!family) return family.error();
    switch (format) {
        case SheetFormat::Png: return png(drawing, *family);
        case SheetFormat::Pdf: return pdf(drawing, *family);
        case SheetFormat::Svg: return svg(drawing, *family);
    }
    return Error{ErrorCode::Internal, "a format of drawings that is not known"};
}

}  // namespace report

Result<SheetFormat> sheetFormatOf(const std::filesystem::path& path) {
    const auto extension = lowerExtension(path);
    for (const auto format : {SheetFormat::Png, SheetFormat::Pdf, SheetFormat::Svg})
        if (extension == extensionOf(format)) return format;
    return Error{ErrorCode::InvalidArgument, fmt::format("saw \"{}\", expected a name that ends in .png, .pdf or .svg", extension), path.string()};
}

const char* extensionOf(SheetFormat format) { return format == SheetFormat::Png ? ".png" : format == SheetFormat::Pdf ? ".pdf" : ".svg"; }

}  // namespace luxdeck

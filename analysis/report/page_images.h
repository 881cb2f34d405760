#pragma once

#include "analysis/report/report_contents.h"
#include "engine/core/image.h"

#include <cstddef>
#include <string>
#include <vector>

namespace luxdeck {

/// The pages of a report as pictures, drawn and broken as in the PDF. From any thread, once Qt has an application.
class PageImages {
public:
    /// errors  as pdfBytes()
    static Result<PageImages> create(ReportContents contents);

    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(pages_); }
    /// All pages at once, so many dots a millimetre (1 .. 40).
    [[nodiscard]] std::vector<DisplayImage> all(double dotsPerMm) const { return draw(dotsPerMm, -1); }
    /// One page; an empty picture where there is no such page.
    [[nodiscard]] DisplayImage page(std::size_t index, double dotsPerMm) const;
    [[nodiscard]] const ReportContents& contents() const { return contents_; }

private:
    [[nodiscard]] std::vector<DisplayImage> draw(double dotsPerMm, int only) const;

    ReportContents contents_;
    int pages_ = 0;
};

}  // namespace luxdeck

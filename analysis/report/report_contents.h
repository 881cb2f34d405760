#pragma once

#include "analysis/grids/solve_result.h"
#include "analysis/report/plan_section.h"
#include "engine/core/image.h"
#include "engine/io/project.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

/// Points whose numbers are withheld, as too many of their samples met something without a value; the solve counts them as
/// well, but the report's twin keeps points alone.
inline std::size_t withheldPoints(const SolveResult& solve) {
    std::size_t count = 0;
    for (const auto& grid : solve.grids)
        for (const auto& point : grid.points) count += point.samples > 0 && !std::isfinite(point.total.ci95) ? 1 : 0;
    return count;
}

/// One line of the luminaire schedule: luminaires of one product that run alike.
struct ScheduleRow {
    std::string id;                  // mark in the plan
    std::string description;
    std::string manufacturer;
    int count = 0;
    double lumensEach = 0;           // new and undimmed [lm]
    double wattsEach = 0;            // input power, undimmed [W]; 0: not known
    double maintenanceFactor = 1;    // [-]
    double dimming = 1;              // 0..1 of the full output
    std::optional<double> cctK;      // correlated colour temperature [K]
    std::string file;                // of the photometry, as the project names it
    std::string fileHash;
};

/// One line of the table of materials.
struct MaterialRow {
    std::string name;
    std::string kind;                // "matte", "glass" ...
    double reflectance = 0;          // luminous; of glass the transmittance [-]
    std::string source;              // where the number is from
};

/// The colours of a false-colour picture, from the darkest to the brightest value. The report prints the legend:
/// the picture itself should have none.
struct ColourScale {
    std::string unit;                // "cd/m²"
    double minimum = 0;
    double maximum = 0;
    bool logarithmic = false;        // equal steps of colour are equal ratios
    std::string map = "dusk";        // as tonemap::colourMapNamed() knows it
};

/// A picture of the room, ready to print.
struct ReportView {
    std::string name;
    std::string operatorName;        // "human", "linear" ... or "false colour"
    std::string operatorText;        // what the operator did, in a sentence
    std::string exposure;            // "1 = 640 cd/m²", or empty
    double seconds = 0;              // of rendering
    double relativeError = 0;        // mean 95 % half-width over value of the picture's luminance; 0: not known
    std::string png;                 // the file's bytes
    std::optional<ColourScale> scale;// false colour alone
};

struct NamedText {
    std::string name;
    std::string text;
};

/// What a report may be without; cover and summary are always there, views and comparison where there are any.
enum class ReportSection { Grids, Schedule, Accuracy, Method };

/// Everything the report prints, as plain data: the same contents give the same PDF, byte for byte.
struct ReportContents {
    ProjectInfo info;
    std::string created;             // "2026-11-22T18:40:00Z"; the PDF's date too
    std::vector<ScheduleRow> schedule;
    std::optional<double> floorAreaM2;
    std::string floorAreaSource;     // how the area was found
    std::vector<MaterialRow> materials;
    RoomPlan plan;
    SolveResult solve;
    std::vector<ReportView> views;
    std::optional<std::string> comparison;  // of algorithms on this project, as compareJson() writes it
    std::string methodText;          // what the algorithm does, a paragraph
    std::optional<std::vector<ReportSection>> leftOut;  // sections that are not printed
    std::vector<NamedText> facts;    // machine, libraries, settings: printed on the method page as they are

    [[nodiscard]] bool has(ReportSection section) const {
        return !leftOut || std::find(leftOut->begin(), leftOut->end(), section) == leftOut->end();
    }
};

/// The bytes of a PNG file of `image`. Deterministic.
Result<std::string> pngBytes(const DisplayImage& image);

}  // namespace luxdeck

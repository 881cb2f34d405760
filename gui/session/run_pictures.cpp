#include "gui/session/run_pictures.h"

#include "analysis/pictures/show.h"
#include "analysis/compare/compare_output.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::gui {

namespace {

constexpr int kLeastSide = 240;  // pixels of what is shown: a point of a grid is a square

/// Every value as a square of so many pixels; grids begin at the bottom, pictures at the top.
tonemap::Field field(const double* values, int columns, int rows, bool fromBelow) {
    const int zoom = std::max(1, kLeastSide / std::max(1, std::min(columns, rows)));
    tonemap::Field out{columns * zoom, rows * zoom, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int row = fromBelow ? rows - 1 - y / zoom : y / zoom;
            out.values.push_back(values[row * columns + x / zoom]);
        }
    return out;
}

Result<RunPicture> coloured(std::string title, const tonemap::Field& values, tonemap::ColourMap map, const tonemap::ScaleRange& range, std::string unit) {
    tonemap::FalseColourSettings settings;
    settings.map = map, settings.logarithmic = false, settings.range = range, settings.legend = false;
    auto image = tonemap::falseColour(values, settings);
    if (!image) return image.error();
    return RunPicture{std::move(title), *std::move(image), std::move(unit), map, range};
}

/// Both by the reference's exposure, so that a difference in brightness is seen.
Result<RunPicture> seen(std::string title, const ComparedValues& picture, double exposure) {
    Image image(picture.columns, picture.rows, {"Y"});
    std::transform(picture.values.begin(), picture.values.end(), image.channel("Y").begin(), [](double v) { return static_cast<float>(v); });
    tonemap::ToneMapSettings settings;
    settings.op = tonemap::Operator::Linear, settings.exposure = exposure;
    auto shown = show(image, settings);
    if (!shown) return shown.error();
    return RunPicture{std::move(title), std::move(shown->image), {}, {}, {}};
}

/// Shows the upper quarter of the values brighter than white: what is bright is more than lamps.
double exposureOf(std::vector<double> values) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at > 0 ? 75 / *at : 1;
}

Result<RunPicture> difference(const ErrorMap& map, double range, const std::string& of) {
    auto percent = map.errors;
    for (auto& e : percent) e *= 100;
    return coloured("Difference" + of, field(percent.data(), map.columns, map.rows, !map.grid.empty()), tonemap::ColourMap::Balance, {-100 * range, 100 * range}, "%");
}

Result<void> addGrid(const ComparedValues& run, const ComparedValues& reference, const ErrorMap& map, std::size_t first, double range, std::vector<RunPicture>& out) {
    const auto* own = run.values.data() + first;
    const auto* truth = reference.values.data() + first;
    const auto there = field(truth, map.columns, map.rows, true);
    const auto scale = tonemap::roundedRange(there, false);
    const auto of = ", " + map.grid;
    auto pictures = {coloured(run.algorithm + of, field(own, map.columns, map.rows, true), tonemap::ColourMap::Dusk, scale, "lx"),
                     coloured("Reference" + of, there, tonemap::ColourMap::Dusk, scale, "lx"), difference(map, range, of)};
    for (const auto& each : pictures) {
        if (!each) return each.error();
        out.push_back(*each);
    }
    return {};
}

}  // namespace

double differenceRange(const ComparedValues& run) {
    Comparison one;
    one.maps = run.maps;
    return errorRange(one, run.subject);
}

Result<std::vector<RunPicture>> runPictures(const ComparedValues& run, const ComparedValues& reference, double range) {
    std::vector<RunPicture> out;
    if (run.columns == 0) {
        std::size_t first = 0;
        for (const auto& map : run.maps) {
            if (auto added = addGrid(run, reference, map, first, range, out); !added) return added.error();
            first += map.errors.size();
        }
        return out;
    }
    const double exposure = exposureOf(reference.values);
    for (auto& each : {seen(run.algorithm, run, exposure), seen("Reference", reference, exposure), difference(run.maps.front(), range, "")}) {
        if (!each) return each.error();
        out.push_back(*each);
    }
    return out;
}

}  // namespace luxdeck::gui

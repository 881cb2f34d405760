#include "analysis/compare/compare_output.h"
#include "tonemap/falsecolor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace luxdeck {

namespace {

constexpr int kLeastSide = 480;  // of a picture's shorter side, that the legend stands in proportion to

/// Every value as a square of `zoom` pixels. Rows of grids begin at v = 0, which is shown at the bottom; those of pictures at the top.
tonemap::Field zoomed(const ErrorMap& map, int zoom) {
    tonemap::Field field{map.columns * zoom, map.rows * zoom, {}};
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            const int row = map.grid.empty() ? y / zoom : map.rows - 1 - y / zoom;
            field.values.push_back(100 * map.errors[static_cast<std::size_t>(row * map.columns + x / zoom)]);
        }
    return field;
}

double roundedUp(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * decade >= value * (1 - 1e-9)) return m * decade;
    return 10 * decade;
}

}  // namespace

Result<DisplayImage> errorPicture(const ErrorMap& map, double range, const std::string& name) {
    if (map.errors.empty()) return Error{ErrorCode::InvalidArgument, "a map without values", map.algorithm};
    tonemap::FalseColourSettings settings;
    settings.map = tonemap::ColourMap::Balance;
    settings.logarithmic = false;
    settings.range = {-100 * range, 100 * range};
    settings.quantity = name;
    settings.unit = "error in %";
    return tonemap::falseColour(zoomed(map, std::max(1, kLeastSide / std::max(1, std::min(map.columns, map.rows)))), settings);
}

double errorRange(const Comparison& c, const std::string& subject) {
    std::map<std::string, std::vector<double>> sizes;  // by algorithm
    for (const auto& map : c.maps)
        if (map.subject == subject)
            for (const double e : map.errors) sizes[map.algorithm].push_back(std::abs(e));
    std::vector<double> typical;
    for (auto& [algorithm, all] : sizes) {
        const auto at = all.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(all.size() - 1));
        std::ranges::nth_element(all, at);
        typical.push_back(*at);
    }
    if (typical.empty()) return 1;
    std::ranges::sort(typical);
    return roundedUp(std::clamp(typical[(typical.size() - 1) / 2], 0.01, 1.0));
}

}  // namespace luxdeck

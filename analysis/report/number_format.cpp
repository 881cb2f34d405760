#include "analysis/report/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck {

namespace {

constexpr const char* kThinSpace = "\u2009";

/// Puts thin spaces between groups of three in the whole part, from five digits on (1000 stays whole).
std::string grouped(std::string digits) {
    const std::size_t start = digits.starts_with('-') ? 1 : 0;
    const std::size_t end = std::min(digits.find('.'), digits.size());
    if (end - start < 5) return digits;
    for (std::size_t at = end; at > start + 3;) {
        at -= 3;
        digits.insert(at, kThinSpace);
    }
    return digits;
}

/// Decimals that show a value of magnitude `size` with `digits` significant digits; negative: round tens.
int decimalsFor(double size, int digits) {
    return digits - 1 - static_cast<int>(std::floor(std::log10(size)));
}

double roundTo(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
}

}  // namespace

std::string formatFixed(double value, int decimals) {
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
    if (decimals < 0) return grouped(fmt::format("{:.0f}", roundTo(value, decimals)));
    return grouped(fmt::format("{:.{}f}", value, decimals));
}

std::string formatNumber(double value, int digits) {
    if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : formatFixed(value, 0);
    const double size = std::abs(value);
    if (size < 1e-4 || size >= 1e7) return fmt::format("{:.{}g}", value, digits);
    auto text = fmt::format("{:.{}f}", value, std::max(0, decimalsFor(size, digits)));
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.ends_with('.')) text.pop_back();
    }
    return grouped(text);
}

std::string formatInterval(const Interval& interval) {
    const double ci = interval.ci95;
    if (!std::isfinite(interval.value)) return "–";
    if (!std::isfinite(ci)) return "not known";
    if (ci <= 0) return formatNumber(interval.value, 4);
    const double leading = ci / std::pow(10.0, std::floor(std::log10(ci)));
    int decimals = decimalsFor(ci, leading < 2 ? 2 : 1);
    const double scale = std::pow(10.0, decimals);
    // Up, so that the printed interval covers the computed one; 1e-9 forgives a half-width that is round already.
    double shown = std::ceil(ci * scale * (1 - 1e-9)) / scale;
    if (decimals > 6) return formatNumber(interval.value, 6) + " ± " + formatNumber(shown, 2);
    return formatFixed(interval.value, decimals) + " ± " + formatFixed(shown, decimals);
}

double knownLux(const Interval& lux) {
    return std::isfinite(lux.ci95) ? lux.value : std::numeric_limits<double>::quiet_NaN();
}

std::string formatGridLux(double lux) {
    if (!std::isfinite(lux)) return "–";
    return std::abs(lux) < 9.95 && lux != 0 ? fmt::format("{:.1f}", lux) : formatFixed(lux, 0);
}

std::string formatSeconds(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0) return "–";
    if (seconds < 0.9995) return fmt::format("{:.0f} ms", seconds * 1e3);
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string formatCount(unsigned long long count) { return grouped(fmt::format("{}", count)); }

std::string formatPercent(double fraction) {
    if (!std::isfinite(fraction)) return "∞";
    const double percent = fraction * 100;
    if (percent == 0) return "0 %";
    return formatNumber(percent, percent < 0.1 ? 1 : 2) + " %";
}

}  // namespace luxdeck

#include "cli/ray_lines.h"

#include "cli/streams.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace luxdeck::cli {

namespace {

/// The six numbers of a line; false: not six numbers in their range, or a direction without length.
bool parse(const std::string& line, std::array<double, 6>& v) {
    const char* at = line.data();
    const char* end = at + line.size();
    for (auto& x : v) {
        while (at < end && (*at == ' ' || *at == '\t' || *at == ',')) ++at;
        const auto [next, error] = std::from_chars(at, end, x);
        if (error != std::errc{} || !std::isfinite(x)) return false;
        if (&x < &v[3] && std::abs(x) > kFarthestM) return false;
        at = next;
    }
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
    return at == end && (v[3] != 0 || v[4] != 0 || v[5] != 0);
}

/// Of length one; large and tiny numbers neither overflow nor vanish on the way.
Vec3 directionOf(const std::array<double, 6>& v) {
    const double largest = std::max({std::abs(v[3]), std::abs(v[4]), std::abs(v[5])});
    return Vec3(Vec3d(v[3] / largest, v[4] / largest, v[5] / largest).normalized());
}

}  // namespace

std::optional<RayLine> parseRayLine(const std::string& line, const Vec3d& origin) {
    std::array<double, 6> v{};
    if (!parse(line, v)) return std::nullopt;
    return RayLine{Vec3(Vec3d(v[0], v[1], v[2]) - origin), directionOf(v)};
}

std::optional<RayLine> parseRayLine(const std::string& line, const Scene& scene) { return parseRayLine(line, scene.origin); }

bool isBlank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

void complainOfRayLine(const std::string& line, std::uint64_t number) {
    auto shown = line.substr(0, 80);  // short, and without what would upset a terminal
    for (auto& c : shown)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
    say(fmt::format("luxdeck: stdin:{}: \"{}\", expected six numbers: x y z (at most {:g} m) and dx dy dz (not all 0)\n", number, shown, kFarthestM));
}

}  // namespace luxdeck::cli

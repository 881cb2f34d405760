#include "engine/io/photometry_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::photometry {
namespace {

/// Angles closer than this are the same plane: files round to 0.01 degree at the finest.
constexpr double kSameAngleDegrees = 1e-4;

/// How far the two sides of a step stand apart: less than any file resolves, more than a float does.
constexpr double kStepDegrees = 1e-3;

struct Plane {
    double angle;              // degree
    const double* candela;     // #V, in the stored distribution
};

double turned(double angle) {
    const double once = std::fmod(angle, 360.0);
    return once < 0 ? once + 360 : once;
}

/// The stored planes first, then their images, so that a stable sort keeps the stored one of equals.
std::vector<Plane> withImages(const StoredPlanes& stored) {
    std::vector<Plane> planes;
    const std::size_t nV = stored.vertical.size();
    const auto add = [&](auto image) {
        for (std::size_t h = 0; h < stored.horizontal.size(); ++h) {
            planes.push_back({turned(image(stored.horizontal[h])), stored.candela.data() + h * nV});
        }
    };
    const auto symmetry = stored.symmetry;
    const bool about0to180 =
        symmetry == PhotometrySymmetry::Bilateral0to180 || symmetry == PhotometrySymmetry::Quadrant;
    const bool about90to270 =
        symmetry == PhotometrySymmetry::Bilateral90to270 || symmetry == PhotometrySymmetry::Quadrant;
    add([](double c) { return c; });
    if (about0to180) add([](double c) { return -c; });
    if (about90to270) add([](double c) { return 180 - c; });
    if (about0to180 && about90to270) add([](double c) { return 180 + c; });
    std::stable_sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.angle < b.angle; });
    const auto same = [](const Plane& a, const Plane& b) { return b.angle - a.angle < kSameAngleDegrees; };
    planes.erase(std::unique(planes.begin(), planes.end(), same), planes.end());
    return planes;
}

void append(StoredPlanes& out, double angle, const double* candela) {
    out.horizontal.push_back(angle);
    out.candela.insert(out.candela.end(), candela, candela + out.vertical.size());
}

/// The plane at 0 between the last one and the first one of the next turn.
std::vector<double> seam(const Plane& last, const Plane& first, std::size_t nV) {
    const double gap = first.angle + 360 - last.angle;
    const double t = (360 - last.angle) / gap;
    std::vector<double> values(nV);
    for (std::size_t v = 0; v < nV; ++v) values[v] = last.candela[v] + (first.candela[v] - last.candela[v]) * t;
    return values;
}

StoredPlanes expandedTypeC(const StoredPlanes& stored) {
    StoredPlanes out{stored.type, stored.symmetry, stored.vertical, {}, {}};
    if (stored.symmetry == PhotometrySymmetry::Axial || stored.horizontal.size() == 1) {
        append(out, 0, stored.candela.data());
        return out;
    }
    std::vector<Plane> planes = withImages(stored);
    // An angle a rounding error short of a full turn is the plane at 0.
    if (planes.size() > 1 && planes.back().angle > 360 - kSameAngleDegrees) planes.pop_back();

    if (planes.front().angle < kSameAngleDegrees) {
        planes.front().angle = 0;
    } else {
        const auto values = seam(planes.back(), planes.front(), out.vertical.size());
        append(out, 0, values.data());
    }
    for (const Plane& plane : planes) append(out, plane.angle, plane.candela);

    // A file that stores 360 itself keeps it, even where it differs from its plane at 0.
    const std::size_t nV = out.vertical.size();
    const auto stored360 = std::find(stored.horizontal.begin(), stored.horizontal.end(), 360.0);
    const double* closing =
        stored360 == stored.horizontal.end()
            ? out.candela.data()
            : stored.candela.data() + static_cast<std::size_t>(stored360 - stored.horizontal.begin()) * nV;
    const std::vector<double> row(closing, closing + nV);
    append(out, 360, row.data());
    return out;
}

/// Indices into a half set 0..last that make it whole: n-1 .. 1, 0 .. n-1, or just 0 .. n-1.
std::vector<std::size_t> mirrored(std::size_t count, bool mirror) {
    std::vector<std::size_t> order;
    for (std::size_t i = count; mirror && i-- > 1;) order.push_back(i);
    for (std::size_t i = 0; i < count; ++i) order.push_back(i);
    return order;
}

std::vector<double> mirroredAngles(const std::vector<double>& half, bool mirror) {
    std::vector<double> out;
    for (std::size_t i = half.size(); mirror && i-- > 1;) out.push_back(-half[i]);
    out.insert(out.end(), half.begin(), half.end());
    return out;
}

}  // namespace

StoredPlanes expanded(const StoredPlanes& stored, bool mirrorsVertical) {
    if (stored.type == PhotometryType::C) return expandedTypeC(stored);
    const bool mirrorsHorizontal =
        stored.symmetry == PhotometrySymmetry::Bilateral0to180 || stored.symmetry == PhotometrySymmetry::Quadrant;
    StoredPlanes out{stored.type,
                     stored.symmetry,
                     mirroredAngles(stored.vertical, mirrorsVertical),
                     mirroredAngles(stored.horizontal, mirrorsHorizontal),
                     {}};
    out.candela.reserve(out.vertical.size() * out.horizontal.size());
    const auto verticalOrder = mirrored(stored.vertical.size(), mirrorsVertical);
    for (const std::size_t h : mirrored(stored.horizontal.size(), mirrorsHorizontal)) {
        for (const std::size_t v : verticalOrder) out.candela.push_back(stored.candela[h * stored.vertical.size() + v]);
    }
    return out;
}

void separateEqualAngles(StoredPlanes& stored, std::vector<std::string>& repairs, std::vector<std::string>& warnings) {
    const auto& angles = stored.vertical;
    const std::size_t nV = angles.size();
    const auto agree = [&](std::size_t a, std::size_t b) {
        for (std::size_t h = 0; h < stored.horizontal.size(); ++h)
            if (stored.candela[h * nV + a] != stored.candela[h * nV + b]) return false;
        return true;
    };
    std::vector<std::size_t> rows;
    std::vector<double> kept;
    std::size_t dropped = 0;
    std::string steps;
    for (std::size_t first = 0, next = 0; first < nV; first = next) {
        for (next = first + 1; next < nV && angles[next] == angles[first];) ++next;
        const std::size_t last = next - 1;
        rows.push_back(first), kept.push_back(angles[first]);
        dropped += last - first;
        if (agree(first, last)) continue;
        --dropped;
        rows.push_back(last), kept.push_back(angles[first]);
        // Away from the end of the range, so that the distribution still reaches it.
        if (next < nV) kept.back() += std::min(kStepDegrees, 0.5 * (angles[next] - angles[first]));
        else if (first > 0)
            kept[kept.size() - 2] -= std::min(kStepDegrees, 0.5 * (angles[first] - angles[first - 1]));
        steps += fmt::format("{}{:.6g}", steps.empty() ? "" : ", ", angles[first]);
    }
    if (rows.size() == nV && steps.empty()) return;
    if (dropped > 0) repairs.push_back(fmt::format("{} duplicate vertical angle(s) dropped", dropped));
    if (!steps.empty())
        warnings.push_back(
            fmt::format("vertical angle(s) {} stand twice with different intensities: taken as steps", steps));
    StoredPlanes out{stored.type, stored.symmetry, std::move(kept), stored.horizontal, {}};
    for (std::size_t h = 0; h < stored.horizontal.size(); ++h)
        for (const auto row : rows) out.candela.push_back(stored.candela[h * nV + row]);
    stored = std::move(out);
}

void clampNegative(std::vector<double>& candela, std::vector<std::string>& warnings) {
    std::size_t count = 0;
    double worst = 0;
    for (double& value : candela) {
        if (value >= 0) continue;
        worst = std::min(worst, value);
        value = 0;
        ++count;
    }
    if (count > 0)
        warnings.push_back(fmt::format("{} negative intensities (down to {:.6g} cd) set to 0", count, worst));
}

void warnIfSeamDiffers(const StoredPlanes& full, std::vector<std::string>& warnings) {
    if (full.type != PhotometryType::C || full.horizontal.size() < 2) return;
    const std::size_t nV = full.vertical.size();
    const double largest = *std::max_element(full.candela.begin(), full.candela.end());
    double difference = 0;
    for (std::size_t v = 0; v < nV; ++v) {
        difference = std::max(difference, std::abs(full.candela[v] - full.candela[full.candela.size() - nV + v]));
    }
    if (difference > 1e-3 * largest) {
        warnings.push_back(
            fmt::format("the planes at 0 and 360 degrees, one and the same, differ by up to {:.3g} cd "
                        "({:.1f} % of the maximum); both kept",
                        difference, 100 * difference / largest));
    }
}

}  // namespace luxdeck::photometry

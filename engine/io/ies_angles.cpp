#include "engine/io/ies_angles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace luxdeck::photometry {
namespace {

/// Files round angles to 0.1 or 0.01 degree; a limit missed by less than this is the limit.
constexpr double kRoundingDegrees = 0.05;

bool is(double angle, double limit) { return std::abs(angle - limit) <= kRoundingDegrees; }

Error refused(std::string message) { return Error{ErrorCode::Parse, std::move(message), ""}; }

/// Keeps the rows (vertical or horizontal) of `stored` listed in `keep`, in that order.
void keepVertical(StoredPlanes& stored, const std::vector<std::size_t>& keep) {
    StoredPlanes out{stored.type, stored.symmetry, {}, stored.horizontal, {}};
    for (const std::size_t v : keep) out.vertical.push_back(stored.vertical[v]);
    for (std::size_t h = 0; h < stored.horizontal.size(); ++h) {
        for (const std::size_t v : keep) out.candela.push_back(stored.candela[h * stored.vertical.size() + v]);
    }
    stored = std::move(out);
}

void keepHorizontal(StoredPlanes& stored, const std::vector<std::size_t>& keep) {
    StoredPlanes out{stored.type, stored.symmetry, stored.vertical, {}, {}};
    const std::size_t nV = stored.vertical.size();
    for (const std::size_t h : keep) {
        out.horizontal.push_back(stored.horizontal[h]);
        const double* plane = stored.candela.data() + h * nV;
        out.candela.insert(out.candela.end(), plane, plane + nV);
    }
    stored = std::move(out);
}

/// The indices of `angles` in rising order; equal ones stay, in the order that fits.
Result<std::vector<std::size_t>> risingOrder(const std::vector<double>& angles, const char* what, Photometry& p) {
    const bool falling =
        angles.size() > 1 && std::is_sorted(angles.rbegin(), angles.rend()) && angles.front() > angles.back();
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const std::size_t i = falling ? angles.size() - 1 - k : k;
        const double previous = order.empty() ? -std::numeric_limits<double>::infinity() : angles[order.back()];
        if (angles[i] < previous) {
            return refused(fmt::format("{} angle {} is {:.6g}, expected more than the one before, {:.6g}", what, i + 1,
                                       angles[i], previous));
        }
        order.push_back(i);
    }
    if (falling) p.repairs.push_back(fmt::format("{} angles fall: turned round", what));
    return order;
}

/// Planes at the same horizontal angle become their mean: which of them is meant nobody can say.
void mergeEqualPlanes(StoredPlanes& stored, Photometry& p) {
    const std::size_t nV = stored.vertical.size(), nH = stored.horizontal.size();
    StoredPlanes out{stored.type, stored.symmetry, stored.vertical, {}, {}};
    bool differ = false;
    for (std::size_t first = 0, next = 0; first < nH; first = next) {
        for (next = first + 1; next < nH && stored.horizontal[next] == stored.horizontal[first];) ++next;
        out.horizontal.push_back(stored.horizontal[first]);
        for (std::size_t v = 0; v < nV; ++v) {
            double sum = 0;
            for (std::size_t h = first; h < next; ++h) {
                sum += stored.candela[h * nV + v];
                differ |= stored.candela[h * nV + v] != stored.candela[first * nV + v];
            }
            out.candela.push_back(next - first == 1 ? sum : sum / static_cast<double>(next - first));
        }
    }
    const std::size_t dropped = nH - out.horizontal.size();
    if (dropped == 0) return;
    if (differ)
        p.warnings.push_back(fmt::format("{} horizontal angle(s) stand twice with different intensities: their mean is "
                                         "taken", dropped));
    else p.repairs.push_back(fmt::format("{} duplicate horizontal angle(s) dropped", dropped));
    stored = std::move(out);
}

/// Angles a rounding error off the ends of their range, put on them.
void snap(std::vector<double>& angles, std::initializer_list<double> limits) {
    if (angles.size() < 2) return;
    for (const double limit : limits) {
        for (double* end : {&angles.front(), &angles.back()}) {
            if (is(*end, limit)) *end = limit;
        }
    }
}

/// The symmetry that the horizontal angles of type C stand for.
Result<PhotometrySymmetry> symmetryOfC(const std::vector<double>& h) {
    const double first = h.front();
    const double last = h.back();
    const double span = last - first;
    if (h.size() == 1) return PhotometrySymmetry::Axial;
    if (span > 360 + kRoundingDegrees || first < -360 || last > 720) {
        return refused(fmt::format("horizontal angles from {:.6g} to {:.6g}, expected at most one turn", first, last));
    }
    if (span > 180 + kRoundingDegrees) return PhotometrySymmetry::None;

    // Within half a turn: the mirror planes are those at the ends, which may fall short of them by rounding or
    // by a missing last plane. A quarter or half that starts elsewhere (180..360) is the same by symmetry.
    const auto within = [&](double from, double to) {
        return first >= from - kRoundingDegrees && last <= to + kRoundingDegrees && (is(first, from) || is(last, to));
    };
    for (const double from : {-180.0, -90.0, 0.0, 90.0, 180.0, 270.0}) {
        if (within(from, from + 90)) return PhotometrySymmetry::Quadrant;
    }
    for (const double from : {-180.0, 0.0, 180.0}) {
        if (within(from, from + 180)) return PhotometrySymmetry::Bilateral0to180;
    }
    for (const double from : {-90.0, 90.0, 270.0}) {
        if (within(from, from + 180)) return PhotometrySymmetry::Bilateral90to270;
    }
    return refused(fmt::format("horizontal angles from {:.6g} to {:.6g}, expected 0; 0..90; 0..180; 90..270 or 0..360",
                               first, last));
}

/// A warning where a type C set leaves a hole between its last plane and the next image of its first.
void warnIfIncomplete(const StoredPlanes& stored, Photometry& p) {
    const auto full = expanded(stored);
    double largest = 0;
    double usual = 0;
    for (std::size_t i = 1; i < stored.horizontal.size(); ++i) {
        usual = std::max(usual, stored.horizontal[i] - stored.horizontal[i - 1]);
    }
    for (std::size_t i = 1; i < full.horizontal.size(); ++i) {
        largest = std::max(largest, full.horizontal[i] - full.horizontal[i - 1]);
    }
    const double first = stored.horizontal.front();
    const double last = stored.horizontal.back();
    if (largest > usual * 1.01 + kRoundingDegrees) {
        p.warnings.push_back(fmt::format("horizontal angles {:.6g}..{:.6g} leave a gap of {:.6g} degrees, interpolated",
                                         first, last, largest));
    } else if (stored.symmetry == PhotometrySymmetry::None && last - first < 360) {
        p.repairs.push_back(fmt::format("horizontal angles {:.6g}..{:.6g} closed to a full turn", first, last));
    }
}

Result<void> settleTypeC(StoredPlanes& stored, Photometry& p) {
    snap(stored.vertical, {0, 90, 180});
    if (stored.vertical.front() < 0 || stored.vertical.back() > 180) {
        return refused(
            fmt::format("vertical angles from {:.6g} to {:.6g} in type C, expected 0..180 (types A and B "
                        "have -90..90)",
                        stored.vertical.front(), stored.vertical.back()));
    }
    snap(stored.horizontal, {-180, -90, 0, 90, 180, 270, 360});
    const auto symmetry = symmetryOfC(stored.horizontal);
    if (!symmetry) return symmetry.error();
    stored.symmetry = *symmetry;
    if (*symmetry == PhotometrySymmetry::Axial && stored.horizontal.front() != 0) {
        p.repairs.push_back(
            fmt::format("the single plane at {:.6g} degrees taken as axial symmetry", stored.horizontal.front()));
    }
    if (*symmetry != PhotometrySymmetry::Axial) warnIfIncomplete(stored, p);
    return {};
}

Result<void> settleTypeAB(StoredPlanes& stored, bool& mirrorsVertical, Photometry& p) {
    for (auto* angles : {&stored.vertical, &stored.horizontal}) {
        const char* what = angles == &stored.vertical ? "vertical" : "horizontal";
        snap(*angles, {-90, 0, 90});
        if (angles->size() < 2 || angles->front() < -90 || angles->back() > 90) {
            return refused(
                fmt::format("{} {} angles from {:.6g} to {:.6g} in type A or B, expected at least 2 within -90..90",
                            angles->size(), what, angles->front(), angles->back()));
        }
    }
    const bool mirrorsHorizontal = stored.horizontal.front() == 0;
    mirrorsVertical = stored.vertical.front() == 0;
    if (mirrorsVertical) {
        p.repairs.push_back(
            fmt::format("vertical angles 0..{:.6g} mirrored to both sides of the aim", stored.vertical.back()));
    }
    stored.symmetry = mirrorsHorizontal && mirrorsVertical ? PhotometrySymmetry::Quadrant
                      : mirrorsHorizontal                  ? PhotometrySymmetry::Bilateral0to180
                      : mirrorsVertical                    ? PhotometrySymmetry::Bilateral90to270
                                                           : PhotometrySymmetry::None;
    return {};
}

}  // namespace

Result<void> settleAngles(StoredPlanes& stored, bool& mirrorsVertical, Photometry& p) {
    const auto verticalOrder = risingOrder(stored.vertical, "vertical", p);
    if (!verticalOrder) return verticalOrder.error();
    keepVertical(stored, *verticalOrder);
    if (stored.vertical.front() == stored.vertical.back())
        return refused("one vertical angle, expected at least 2");
    separateEqualAngles(stored, p.repairs, p.warnings);
    const auto horizontalOrder = risingOrder(stored.horizontal, "horizontal", p);
    if (!horizontalOrder) return horizontalOrder.error();
    keepHorizontal(stored, *horizontalOrder);
    mergeEqualPlanes(stored, p);
    mirrorsVertical = false;
    return stored.type == PhotometryType::C ? settleTypeC(stored, p) : settleTypeAB(stored, mirrorsVertical, p);
}

}  // namespace luxdeck::photometry

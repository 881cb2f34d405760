#include "engine/scene/candela_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck {
namespace {

constexpr float kDegreesPerRadian = 180.0F / kPi;

/// Directions are floats: one exactly on the last angle of a table may come out this far beyond it.
constexpr float kAngleSlackDegrees = 1e-3F;

/// atan2 to 2e-8 rad plus float rounding. The choice of octant is arithmetic: directions come in no order, and
/// a mispredicted branch costs more than the polynomial.
/// source  Abramowitz & Stegun 4.4.49
float fastAtan2(float y, float x) {
    const float ax = std::abs(x);
    const float ay = std::abs(y);
    const float larger = std::max(ax, ay);
    if (!(larger > 0)) return 0;
    const float t = std::min(ax, ay) / larger;
    const float s = t * t;
    float p = 0.0028662257F;
    p = p * s - 0.0161657367F;
    p = p * s + 0.0429096138F;
    p = p * s - 0.0752896400F;
    p = p * s + 0.1065626393F;
    p = p * s - 0.1420889944F;
    p = p * s + 0.1999355085F;
    p = p * s - 0.3333314528F;
    float angle = t + t * s * p;
    angle += static_cast<float>(ay > ax) * (0.5F * kPi - 2 * angle);
    angle += static_cast<float>(x < 0) * (kPi - 2 * angle);
    return std::copysign(angle, y);
}

struct Range {
    double low;
    double high;
};

Range verticalRange(PhotometryType type) { return type == PhotometryType::C ? Range{0, 180} : Range{-90, 90}; }
Range horizontalRange(PhotometryType type) { return type == PhotometryType::C ? Range{0, 360} : Range{-90, 90}; }

Result<void> checkAngles(const std::vector<double>& degrees, Range range, const char* what) {
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        if (!(degrees[i] >= range.low && degrees[i] <= range.high)) {
            return Error{ErrorCode::InvalidArgument, fmt::format("{} angle {} is {}, expected {}..{} degrees", what, i,
                                                                 degrees[i], range.low, range.high)};
        }
        if (i > 0 && !(degrees[i] > degrees[i - 1])) {
            return Error{ErrorCode::InvalidArgument,
                         fmt::format("{} angle {} is {}, expected more than the one before, {}", what, i, degrees[i],
                                     degrees[i - 1])};
        }
    }
    return {};
}

Result<void> checkExtent(PhotometryType type, const std::vector<double>& vertical,
                         const std::vector<double>& horizontal) {
    if (vertical.size() < 2) {
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("{} vertical angle(s), expected at least 2", vertical.size())};
    }
    if (type == PhotometryType::C) {
        const bool axial = horizontal.size() == 1 && horizontal.front() == 0;
        const bool full = horizontal.size() >= 2 && horizontal.front() == 0 && horizontal.back() == 360;
        if (!axial && !full) {
            return Error{
                ErrorCode::InvalidArgument,
                fmt::format("{} horizontal angles from {} to {}, expected the single 0 or 0..360", horizontal.size(),
                            horizontal.empty() ? 0 : horizontal.front(), horizontal.empty() ? 0 : horizontal.back())};
        }
    } else if (horizontal.size() < 2) {
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("{} horizontal angle(s) in type A or B, expected at least 2", horizontal.size())};
    }
    return {};
}

Result<void> checkCandela(const std::vector<double>& candela, std::size_t verticalCount, std::size_t horizontalCount) {
    if (candela.size() / verticalCount != horizontalCount || candela.size() % verticalCount != 0) {
        return Error{ErrorCode::InvalidArgument, fmt::format("{} candela values, expected {} x {}", candela.size(),
                                                             horizontalCount, verticalCount)};
    }
    // Floats hold the table in the inner loop, so "finite" means finite there.
    const auto bad = std::find_if(candela.begin(), candela.end(),
                                  [](double c) { return !(c >= 0 && c <= std::numeric_limits<float>::max()); });
    if (bad != candela.end()) {
        const auto i = static_cast<std::size_t>(bad - candela.begin());
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("candela value {} of plane {} is {}, expected finite and >= 0", i % verticalCount,
                                 i / verticalCount, *bad)};
    }
    return {};
}

/// Integral of f(t) sin t over [t0, t1], f linear with f(t0) = a, f(t1) = b (by parts).
double integralTimesSine(double t0, double t1, double a, double b) {
    return a * std::cos(t0) - b * std::cos(t1) + (b - a) / (t1 - t0) * (std::sin(t1) - std::sin(t0));
}

/// The same for f(t) cos t.
double integralTimesCosine(double t0, double t1, double a, double b) {
    return b * std::sin(t1) - a * std::sin(t0) + (b - a) / (t1 - t0) * (std::cos(t1) - std::cos(t0));
}

float inverseStepOf(const std::vector<double>& degrees) {
    if (degrees.size() < 2) return 0;
    const double step = (degrees.back() - degrees.front()) / static_cast<double>(degrees.size() - 1);
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        // A millionth of a step moves no value by more than a millionth of its difference to the next.
        if (std::abs(degrees[i] - degrees.front() - step * static_cast<double>(i)) > 1e-6 * step) return 0;
    }
    return static_cast<float>(1.0 / step);
}

/// Where an angle lies between the angles of an axis: in cell `index`, a `fraction` of it along.
struct Position {
    std::size_t index;
    float fraction;
};

Position locate(const std::vector<float>& degrees, float inverseStep, float angle) {
    const std::size_t lastCell = degrees.size() - 2;
    if (inverseStep > 0) {
        const float t = std::max((angle - degrees.front()) * inverseStep, 0.0F);
        const auto index = std::min(static_cast<std::size_t>(static_cast<int>(t)), lastCell);
        return {index, std::min(t - static_cast<float>(index), 1.0F)};
    }
    std::size_t index = 0;  // binary search without branches; the last angle at or below `angle` is in [index, +count)
    for (std::size_t count = lastCell + 1; count > 1;) {
        const std::size_t half = count / 2;
        index += static_cast<std::size_t>(degrees[index + half] <= angle) * half;
        count -= half;
    }
    const float t = (angle - degrees[index]) / (degrees[index + 1] - degrees[index]);
    return {index, std::clamp(t, 0.0F, 1.0F)};
}

float mix(float a, float b, float t) { return a + (b - a) * t; }

}  // namespace

Result<CandelaTable> CandelaTable::create(PhotometryType type, std::vector<double> vertical,
                                          std::vector<double> horizontal, std::vector<double> candela) {
    if (auto ok = checkExtent(type, vertical, horizontal); !ok) return ok.error();
    if (auto ok = checkAngles(vertical, verticalRange(type), "vertical"); !ok) return ok.error();
    if (auto ok = checkAngles(horizontal, horizontalRange(type), "horizontal"); !ok) return ok.error();
    if (auto ok = checkCandela(candela, vertical.size(), horizontal.size()); !ok) return ok.error();

    CandelaTable table;
    table.type_ = type;
    table.vertical_ = std::move(vertical);
    table.horizontal_ = std::move(horizontal);
    table.candela_ = std::move(candela);
    table.prepareLookup();
    table.integrate();
    return table;
}

void CandelaTable::prepareLookup() {
    verticalAxis_ = {{vertical_.begin(), vertical_.end()}, inverseStepOf(vertical_)};
    horizontalAxis_ = {{horizontal_.begin(), horizontal_.end()}, inverseStepOf(horizontal_)};
    cells_.assign(candela_.begin(), candela_.end());
    maxIntensity_ = *std::max_element(cells_.begin(), cells_.end());
}

void CandelaTable::integrate() {
    const std::size_t nV = vertical_.size();
    const std::size_t nH = horizontal_.size();
    const bool latitudeIsHorizontal = type_ == PhotometryType::B;
    const auto& polar = latitudeIsHorizontal ? horizontal_ : vertical_;
    const auto& around = latitudeIsHorizontal ? vertical_ : horizontal_;
    const auto at = [&](std::size_t iAround, std::size_t iPolar) {
        return latitudeIsHorizontal ? candela_[iPolar * nV + iAround] : candela_[iAround * nV + iPolar];
    };

    // A bilinear cell integrates in two steps: over the angle about the pole to the mean of its two
    // sides times the width, which is linear in the polar angle, and that in closed form.
    std::vector<double> ring(polar.size(), 0.0);  // integral over the angle about the pole [cd rad]
    for (std::size_t p = 0; p < polar.size(); ++p) {
        if (nH == 1) ring[p] = 2 * kPiD * at(0, p);
        for (std::size_t a = 0; nH > 1 && a + 1 < around.size(); ++a) {
            ring[p] += 0.5 * (at(a, p) + at(a + 1, p)) * (around[a + 1] - around[a]) * kDegree;
        }
    }
    for (std::size_t p = 0; p + 1 < polar.size(); ++p) {
        const double t0 = polar[p] * kDegree;
        const double t1 = polar[p + 1] * kDegree;
        if (type_ != PhotometryType::C) {
            lumens_ += integralTimesCosine(t0, t1, ring[p], ring[p + 1]);
            continue;
        }
        lumens_ += integralTimesSine(t0, t1, ring[p], ring[p + 1]);
        const double horizon = std::min(t1, 0.5 * kPiD);
        if (t0 < horizon) {
            const double atHorizon = ring[p] + (ring[p + 1] - ring[p]) * (horizon - t0) / (t1 - t0);
            lumensDown_ += integralTimesSine(t0, horizon, ring[p], atHorizon);
        }
    }
    // Types A and B reach 90 degrees from their aim at most, which is straight down.
    if (type_ != PhotometryType::C) lumensDown_ = lumens_;
}

float CandelaTable::intensity(const Vec3& d) const {
    if (cells_.empty()) return 0;
    float vertical = 0;
    float horizontal = 0;
    switch (type_) {
        case PhotometryType::C:
            vertical = fastAtan2(std::sqrt(d.x * d.x + d.y * d.y), -d.z);
            if (horizontalAxis_.degrees.size() > 1) {
                horizontal = fastAtan2(d.y, d.x);
                horizontal += static_cast<float>(horizontal < 0) * 2 * kPi;
            }
            break;
        case PhotometryType::B:
            vertical = fastAtan2(d.x, -d.z);
            horizontal = fastAtan2(-d.y, std::sqrt(d.x * d.x + d.z * d.z));
            break;
        case PhotometryType::A:
            vertical = fastAtan2(d.x, std::sqrt(d.y * d.y + d.z * d.z));
            horizontal = fastAtan2(-d.y, -d.z);
            break;
    }
    return interpolate(vertical * kDegreesPerRadian, horizontal * kDegreesPerRadian);
}

float CandelaTable::interpolate(float vertical, float horizontal) const {
    const auto inside = [](const Axis& axis, float angle) {  // false for NaN too
        return angle >= axis.degrees.front() - kAngleSlackDegrees && angle <= axis.degrees.back() + kAngleSlackDegrees;
    };
    if (!inside(verticalAxis_, vertical)) return 0;
    const Position v = locate(verticalAxis_.degrees, verticalAxis_.inverseStep, vertical);
    if (horizontalAxis_.degrees.size() == 1) return mix(cells_[v.index], cells_[v.index + 1], v.fraction);

    if (!inside(horizontalAxis_, horizontal)) return 0;
    const Position h = locate(horizontalAxis_.degrees, horizontalAxis_.inverseStep, horizontal);
    const float* near = cells_.data() + h.index * verticalAxis_.degrees.size() + v.index;
    const float* far = near + verticalAxis_.degrees.size();
    return mix(mix(near[0], near[1], v.fraction), mix(far[0], far[1], v.fraction), h.fraction);
}

}  // namespace luxdeck

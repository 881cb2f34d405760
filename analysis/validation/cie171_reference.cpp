#include "analysis/validation/cie171_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace luxdeck::cie171 {

namespace {

/// The part of a polygon in front of a plane. Source: Sutherland & Hodgman 1974.
std::vector<Vec3d> inFront(const std::vector<Vec3d>& polygon, const Vec3d& at, const Vec3d& normal) {
    std::vector<Vec3d> out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = (a - at).dot(normal), db = (b - at).dot(normal);
        if (da >= 0) out.push_back(a);
        if ((da < 0) != (db < 0)) out.push_back(a + (b - a) * (da / (da - db)));
    }
    return out;
}

/// a, b, c, d, e of the types 1 .. 15. Source: CIE S 011/E:2003, table 1; a second copy, so that a slip in the engine's shows.
constexpr std::array<std::array<double, 5>, 15> kStandardSkies{{
    {4.0, -0.70, 0, -1.0, 0.00},   {4.0, -0.70, 2, -1.5, 0.15},   {1.1, -0.8, 0, -1.0, 0.00},
    {1.1, -0.8, 2, -1.5, 0.15},    {0.0, -1.0, 0, -1.0, 0.00},    {0.0, -1.0, 2, -1.5, 0.15},
    {0.0, -1.0, 5, -2.5, 0.30},    {0.0, -1.0, 10, -3.0, 0.45},   {-1.0, -0.55, 2, -1.5, 0.15},
    {-1.0, -0.55, 5, -2.5, 0.30},  {-1.0, -0.55, 10, -3.0, 0.45}, {-1.0, -0.32, 10, -3.0, 0.45},
    {-1.0, -0.32, 16, -3.0, 0.30}, {-1.0, -0.15, 16, -3.0, 0.30}, {-1.0, -0.15, 24, -2.8, 0.15},
}};

/// Through two surfaces that reflect r, with what is left of the light between them.
double slab(double r, double inside) { return (1 - r) * (1 - r) * inside / (1 - r * r * inside * inside); }

double midpoints(const Patch& opening, const Vec3d& at, const Vec3d& normal, const std::function<double(const Vec3d&)>& luminance, int n) {
    const Vec3d facing = opening.u.cross(opening.v).normalized();
    double sum = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Vec3d way = opening.corner + opening.u * ((i + 0.5) / n) + opening.v * ((j + 0.5) / n) - at;
            const double d2 = way.length2();
            const Vec3d w = way / std::sqrt(d2);
            sum += luminance(w) * std::max(0.0, w.dot(normal)) * std::abs(w.dot(facing)) / d2;
        }
    return sum * opening.area() / (double{1} * n * n);
}

double skyMidpoints(const ReferenceSky& sky, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double z = kPiD / 2 * (i + 0.5) / n;
        for (int j = 0; j < 2 * n; ++j) {
            const double azimuth = kPiD * (j + 0.5) / n;
            sum += sky.luminance({std::sin(z) * std::cos(azimuth), std::sin(z) * std::sin(azimuth), std::cos(z)}) * std::sin(z) * std::cos(z);
        }
    }
    return sum * (kPiD / 2 / n) * (kPiD / n);
}

}  // namespace

double configurationFactor(const std::vector<Vec3d>& polygon, const Vec3d& at, const Vec3d& normal) {
    const auto seen = inFront(polygon, at, normal);
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Vec3d a = (seen[i] - at).normalized(), b = (seen[(i + 1) % seen.size()] - at).normalized(), c = a.cross(b);
        if (c.length() > 0) sum += std::atan2(c.length(), a.dot(b)) * normal.dot(c.normalized());
    }
    return std::abs(sum) / (2 * kPiD);
}

ReferenceGlass::ReferenceGlass(double atNormal, double ior) : ior_(ior), inside_(1) {
    const double r = std::pow((ior - 1) / (ior + 1), 2);
    double low = 0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + inside_) / 2;
        (slab(r, middle) < atNormal ? low : inside_) = middle;
    }
}

double ReferenceGlass::transmittance(double cosine) const {
    const double in = std::sqrt(1 - (1 - cosine * cosine) / (ior_ * ior_)), inside = std::pow(inside_, 1 / in);
    const double s = std::pow((cosine - ior_ * in) / (cosine + ior_ * in), 2), p = std::pow((in - ior_ * cosine) / (in + ior_ * cosine), 2);
    return (slab(s, inside) + slab(p, inside)) / 2;
}

double mitalas(double atNormal, double cosine) {
    return 1.018 * atNormal * cosine * (1 + std::pow(1 - cosine * cosine, 1.5));
}

double ReferenceSky::luminance(const Vec3d& direction) const {
    const double cosine = std::max(direction.z, 1e-9);
    if (type == 0) return 1;
    if (type == 16) return (1 + 2 * cosine) / 3;
    const auto& [a, b, c, d, e] = kStandardSkies.at(static_cast<std::size_t>(type - 1));
    const auto indicatrix = [&](double angle) { return 1 + c * (std::exp(d * angle) - std::exp(d * kPiD / 2)) + e * std::pow(std::cos(angle), 2); };
    const double fromSun = std::atan2(direction.cross(sun).length(), direction.dot(sun));
    return (1 + a * std::exp(b / cosine)) / (1 + a * std::exp(b)) * indicatrix(fromSun) / indicatrix(std::acos(sun.z));
}

Cie171Reference ReferenceSky::horizontal() const {
    if (type == 0) return {kPiD, 0, ""};
    if (type == 16) return {7 * kPiD / 9, 0, ""};
    const double fine = skyMidpoints(*this, 80);
    return {fine, std::abs(fine - skyMidpoints(*this, 40)), ""};
}

Cie171Reference throughOpening(const Patch& opening, const Vec3d& at, const Vec3d& normal, const std::function<double(const Vec3d&)>& luminance) {
    if (opening.area() <= 0) return {};
    const double fine = midpoints(opening, at, normal, luminance, 64);
    return {fine, std::abs(fine - midpoints(opening, at, normal, luminance, 32)), ""};
}

GaussRule gaussRule(int n) {
    GaussRule rule;
    for (int i = 0; i < n; ++i) {
        double x = std::cos(kPiD * (i + 0.75) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 50; ++step) {  // Newton on Legendre's polynomial
            double p = 1, before = 0;
            for (int k = 1; k <= n; ++k) {
                const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p, p = next;
            }
            slope = n * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        rule.points.push_back((1 + x) / 2), rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace luxdeck::cie171

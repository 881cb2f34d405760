#include "engine/volume/moments.h"

#include "engine/core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace luxdeck {

namespace {

/// A square part of a bin's square.
struct Patch {
    double u, v, side;
};

constexpr int kNodes = 9;     // Gauss-Legendre, 3 x 3
constexpr int kDeepest = 9;   // of subdivision: the last patch is a 2.6e5th of the bin
// Of a bin's mean. Only bins on the horizon or on a diagonal of the map's square come near it, 100 of 578: were they all
// off to one side, 100 / 578 * 4 pi * 4e-7 = 9e-7 of a row that sums to pi.
constexpr double kTolerance = 4e-7;

double kernel(int order, double cosine) {
    if (cosine <= 0) return 0;
    return order == 1 ? cosine : 0.5 * (order + 1) * std::pow(cosine, order);
}

/// Directions at a patch's nodes, of one hemisphere.
using Nodes = std::array<Vec3d, kNodes>;

Nodes nodesOf(const Patch& patch, bool lower) {
    static const std::array<double, 3> at{0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
    Nodes nodes;
    for (int i = 0; i < kNodes; ++i) {
        nodes[i] = concentricHemisphere(patch.u + at[i % 3] * patch.side, patch.v + at[i / 3] * patch.side);
        if (lower) nodes[i].z = -nodes[i].z;
    }
    return nodes;
}

/// The kernel's mean over a patch.
double meanKernel(const Nodes& nodes, const Vec3d& out, int order) {
    static constexpr std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (int i = 0; i < kNodes; ++i) sum += weight[i % 3] * weight[i / 3] * kernel(order, nodes[i].dot(out));
    return sum;
}

std::array<Patch, 4> quarters(const Patch& p) {
    const double half = p.side / 2;
    return {{{p.u, p.v, half}, {p.u + half, p.v, half}, {p.u, p.v + half, half}, {p.u + half, p.v + half, half}}};
}

struct Bin {
    Patch patch;
    bool lower;
    Vec3d middle;
    double cosineOfReach;  // of the angle between the middle and the farthest part
};

Bin binOf(const DirectionBins& bins, int index) {
    const int side = bins.side(), cell = index % (side * side);
    Bin b;
    b.lower = index >= side * side;
    b.patch = {static_cast<double>(cell % side) / side, static_cast<double>(cell / side) / side, 1.0 / side};
    b.middle = nodesOf(b.patch, b.lower)[kNodes / 2];
    b.cosineOfReach = 1;
    for (const double u : {b.patch.u, b.patch.u + b.patch.side})
        for (const double v : {b.patch.v, b.patch.v + b.patch.side}) {
            auto corner = concentricHemisphere(u, v);
            if (b.lower) corner.z = -corner.z;
            b.cosineOfReach = std::min(b.cosineOfReach, corner.dot(b.middle));
        }
    return b;
}

double refine(const Patch& patch, bool lower, const Vec3d& out, int order, double coarse, double tolerance, int depth) {
    const auto parts = quarters(patch);
    std::array<double, 4> means{};
    double fine = 0;
    for (int i = 0; i < 4; ++i) fine += (means[i] = meanKernel(nodesOf(parts[i], lower), out, order)) / 4;
    if (depth >= kDeepest || std::abs(fine - coarse) < tolerance) return fine;
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += refine(parts[i], lower, out, order, means[i], tolerance * 2, depth + 1) / 4;
    return sum;
}

/// The kernel's mean over a bin. A lobe narrower than the bin falls between the nodes: then the bin is divided first.
double binMean(const Bin& bin, const Vec3d& out, int order, double tolerance) {
    const double reach = std::acos(std::min(bin.cosineOfReach, 1.0));
    const double nearest = std::acos(std::clamp(bin.middle.dot(out), -1.0, 1.0)) - reach;
    if (nearest >= kPiD / 2) return 0;  // wholly below the horizon of `out`
    if (nearest > 0 && kernel(order, std::cos(nearest)) < tolerance) return 0;
    const double lobe = 1 / std::sqrt(static_cast<double>(order));  // half-width of cos^n [rad]
    const bool narrow = lobe < 4 * reach;
    const double coarse = narrow ? -1 : meanKernel(nodesOf(bin.patch, bin.lower), out, order);
    return refine(bin.patch, bin.lower, out, order, coarse, tolerance, lobe < reach / 4 ? 0 : 1);
}

/// One of the sixteen ways in which the map of directions looks the same: mirrored in x, y, z, and turned over the diagonal.
struct Symmetry {
    bool flipU, flipV, swap, flipHemisphere;

    /// The one that brings a bin to a column and row in the first eighth of the upper hemisphere's square.
    static Symmetry toFirstEighth(int bin, int side) {
        const int hemisphere = bin / (side * side), u = bin % side, v = bin / side % side;
        Symmetry s{u > side - 1 - u, v > side - 1 - v, false, hemisphere == 1};
        s.swap = std::min(v, side - 1 - v) < std::min(u, side - 1 - u);
        return s;
    }
    [[nodiscard]] int operator()(int bin, int side) const {
        int hemisphere = bin / (side * side), u = bin % side, v = bin / side % side;
        if (flipU) u = side - 1 - u;
        if (flipV) v = side - 1 - v;
        if (swap) std::swap(u, v);
        if (flipHemisphere) hemisphere = 1 - hemisphere;
        return (hemisphere * side + v) * side + u;
    }
};

std::vector<double> rowOf(const std::vector<Bin>& bins, std::size_t row, int order, Quadrature quadrature, double solidAngle) {
    const auto out = bins[row].middle.normalized();
    std::vector<double> weights(bins.size());
    for (std::size_t i = 0; i < bins.size(); ++i)
        weights[i] = solidAngle * (quadrature == Quadrature::Midpoint ? kernel(order, bins[i].middle.normalized().dot(out))
                                                                      : binMean(bins[i], out, order, kTolerance));
    if (quadrature == Quadrature::Midpoint) return weights;
    // What the subdivision left is shared out, so that a uniform field comes out exact.
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (auto& w : weights) w *= kPiD / sum;
    return weights;
}

}  // namespace

float momentKernel(int order, float cosine) { return static_cast<float>(kernel(order, double{cosine})); }

MomentWeights::MomentWeights(const DirectionBins& bins, int order, Quadrature quadrature)
    : count_(bins.count()), weights_(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_)) {
    const int side = bins.side();
    std::vector<Bin> all;
    for (int i = 0; i < count_; ++i) all.push_back(binOf(bins, i));
    // Rows of the first eighth are integrated, the others are these in another order.
    std::vector<std::size_t> firsts;
    for (int i = 0; i < count_; ++i)
        if (Symmetry::toFirstEighth(i, side)(i, side) == i) firsts.push_back(static_cast<std::size_t>(i));
    std::vector<std::vector<double>> rows(all.size());
    parallelFor(firsts.size(), [&](std::size_t i) { rows[firsts[i]] = rowOf(all, firsts[i], order, quadrature, bins.solidAngleSr()); });
    parallelFor(all.size(), [&](std::size_t out) {
        const auto symmetry = Symmetry::toFirstEighth(static_cast<int>(out), side);
        const auto& row = rows[static_cast<std::size_t>(symmetry(static_cast<int>(out), side))];
        for (int i = 0; i < count_; ++i)
            weights_[static_cast<std::size_t>(i) * all.size() + out] = static_cast<float>(row[static_cast<std::size_t>(symmetry(i, side))]);
    });
}

}  // namespace luxdeck

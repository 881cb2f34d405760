#include "engine/transport/radiosity/link_matrix.h"

#include "engine/transport/radiosity/element_groups.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr int kMostRounds = 500;
constexpr int kSweeps = 3;              // of one round, before the mean is corrected
constexpr double kLeastLoss = 1e-6;     // of the area's light: below it the mean is not corrected

Vec3d asVector(const Rgb& c) { return {c.r, c.g, c.b}; }
Rgb asColour(const Vec3d& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

}  // namespace

LinkMatrix::LinkMatrix(std::span<const std::vector<ElementLink>> rows) : first_{0} {
    for (const auto& row : rows) {
        links_.insert(links_.end(), row.begin(), row.end());
        first_.push_back(links_.size());
        Lux sum(0, 0, 0);
        for (const auto& link : row) sum += asVector(link.weight);
        sums_.push_back(sum);
    }
    ElementGroups groups(rows.size());
    for (std::uint32_t i = 0; i < rows.size(); ++i)
        for (const auto& link : rows[i]) groups.join(i, link.to);
    for (std::uint32_t i = 0; i < rows.size(); ++i) groups_.push_back(groups.of(i));
}

LinkMatrix::Lux LinkMatrix::received(std::size_t row, std::span<const Lux> lux) const {
    Lux sum(0, 0, 0);
    for (std::size_t i = first_[row]; i < first_[row + 1]; ++i) sum += asVector(links_[i].weight) * lux[links_[i].to];
    return sum;
}

double LinkMatrix::solve(std::span<const Rgb> constant, std::span<const float> areasM2, std::span<Rgb> lux) const {
    std::vector<Lux> solution;
    for (const auto& c : constant) solution.push_back(asVector(c));
    double left = 1;
    for (int round = 0; round < kMostRounds && left > kEnough; ++round) {
        for (int sweep = 0; sweep < kSweeps; ++sweep)
            for (std::size_t i = 0; i < solution.size(); ++i) solution[i] = asVector(constant[i]) + received(i, solution);
        left = correct(constant, areasM2, solution);
    }
    std::transform(solution.begin(), solution.end(), lux.begin(), asColour);
    return left;
}

/// Adds to all elements of a group alike what makes their residual vanish on average, and returns how large all were before.
double LinkMatrix::correct(std::span<const Rgb> constant, std::span<const float> areasM2, std::span<Lux> lux) const {
    struct Sums {
        Lux residual{0, 0, 0}, lost{0, 0, 0};
        double area = 0;
    };
    std::vector<Sums> ofGroups(lux.size());
    Lux size(0, 0, 0), light(0, 0, 0);
    for (std::size_t i = 0; i < lux.size(); ++i) {
        auto& sums = ofGroups[groups_[i]];
        const double a = areasM2[i];
        const Lux r = asVector(constant[i]) + received(i, lux) - lux[i];
        sums.area += a, sums.residual += r * a, sums.lost += (Lux(1, 1, 1) - sums_[i]) * a;
        light += lux[i] * a, size += Lux(std::abs(r.x), std::abs(r.y), std::abs(r.z)) * a;
    }
    double left = 0;
    for (int c = 0; c < 3; ++c)
        if (light[c] > 0) left = std::max(left, size[c] / light[c]);
    if (left <= kEnough) return left;
    for (std::size_t i = 0; i < lux.size(); ++i) {
        const auto& sums = ofGroups[groups_[i]];
        for (int c = 0; c < 3; ++c)
            if (sums.lost[c] > kLeastLoss * sums.area) lux[i][c] = std::max(0.0, lux[i][c] + sums.residual[c] / sums.lost[c]);
    }
    return left;
}

}  // namespace luxdeck

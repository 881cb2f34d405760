#include "engine/transport/irradiance_cache/hemisphere.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// The edges of a ring, and what its cells weigh by.
struct Ring {
    float sineLow, sineHigh;  // at its edge towards the zenith, and at the other
    float meanTangent;        // of the angle to the zenith, over projected solid angle
};

Ring ringOf(const HemisphereCells& grid, int j) {
    const double low = std::sqrt(double(j) / grid.rings), high = std::sqrt(double(j + 1) / grid.rings);
    // The integral of sin^2 over that of sin cos.
    const auto integral = [](double sine) { return std::asin(sine) / 2 - sine * std::sqrt(std::max(0.0, 1 - sine * sine)) / 2; };
    const double tangent = (integral(high) - integral(low)) * 2 / (high * high - low * low);
    return {static_cast<float>(low), static_cast<float>(high), static_cast<float>(tangent)};
}

Vec3 azimuth(float angle) { return {std::cos(angle), std::sin(angle), 0}; }

/// What each cell's radiance adds to the translational gradient, per cd/m^2: of its four edges, those that it gains by
/// and those that it loses by. An edge moves with the nearer of the two cells.
std::vector<Vec3> translationWeights(const HemisphereCells& grid, std::span<const HemisphereCell> cells, float leastDistance) {
    std::vector<Vec3> weights(cells.size(), Vec3(0, 0, 0));
    const float step = 2 * kPi / static_cast<float>(grid.sectors);
    const auto edge = [&](std::size_t gains, std::size_t loses, const Vec3& moves) {
        const Vec3 weight = moves / std::max(std::min(cells[gains].distance, cells[loses].distance), leastDistance);
        weights[gains] += weight, weights[loses] -= weight;
    };
    for (int j = 0; j < grid.rings; ++j) {
        const auto ring = ringOf(grid, j);
        for (int k = 0; k < grid.sectors; ++k) {
            const auto cell = static_cast<std::size_t>(j * grid.sectors + k);
            const auto before = static_cast<std::size_t>(j * grid.sectors + (k + grid.sectors - 1) % grid.sectors);
            edge(cell, before, azimuth(step * static_cast<float>(k) + kPi / 2) * (ring.sineHigh - ring.sineLow));
            if (j == 0) continue;
            const Vec3 outwards = azimuth(step * (static_cast<float>(k) + 0.5F));
            edge(cell, cell - static_cast<std::size_t>(grid.sectors), outwards * (step * ring.sineLow * (1 - ring.sineLow * ring.sineLow)));
        }
    }
    return weights;
}

/// Square of the noise of one cell: what it differs by from the mean of its neighbours in the ring, which have half of
/// that noise. Edges count as noise too.
float noise2(const HemisphereCells& grid, std::span<const HemisphereCell> cells) {
    float sum = 0;
    for (int j = 0; j < grid.rings; ++j)
        for (int k = 0; k < grid.sectors; ++k) {
            const auto at = [&](int sector) { return luminance(cells[static_cast<std::size_t>(j * grid.sectors + (sector + grid.sectors) % grid.sectors)].radiance); };
            const float off = at(k) - (at(k - 1) + at(k + 1)) / 2;
            sum += off * off / 1.5F;
        }
    return sum / static_cast<float>(grid.count());
}

/// How much of a gradient to believe, given how much of it noise alone would make. Source: James & Stein 1961.
float believed(const ColourGradient& gradient, std::span<const Vec3> weights, float cellNoise2) {
    const Vec3 grey(gradient.along({1, 0, 0}).g, gradient.along({0, 1, 0}).g, gradient.along({0, 0, 1}).g);
    float byNoise = 0;
    for (const auto& w : weights) byNoise += w.length2() * cellNoise2;
    const float size2 = grey.length2();
    return size2 > byNoise ? 1 - byNoise / size2 : 0.0F;
}

}  // namespace

HemisphereCells HemisphereCells::about(double count) {
    HemisphereCells grid;
    grid.rings = std::max(2, static_cast<int>(std::lround(std::sqrt(count / kPiD))));
    grid.sectors = std::max(4, static_cast<int>(std::lround(count / grid.rings)));
    return grid;
}

Vec3 HemisphereCells::direction(int cell, Vec2 within) const {
    const float sine2 = (static_cast<float>(cell / sectors) + within.x) / static_cast<float>(rings);
    const float angle = 2 * kPi * (static_cast<float>(cell % sectors) + within.y) / static_cast<float>(sectors);
    return azimuth(angle) * std::sqrt(sine2) + Vec3(0, 0, std::sqrt(std::max(0.0F, 1 - sine2)));
}

IrradianceAndGradients irradianceAndGradients(const HemisphereCells& grid, std::span<const HemisphereCell> cells, float leastDistance) {
    IrradianceAndGradients out;
    const float step = 2 * kPi / static_cast<float>(grid.sectors), weight = kPi / static_cast<float>(grid.count());
    const auto weights = translationWeights(grid, cells, leastDistance);
    for (int j = 0; j < grid.rings; ++j) {
        const auto ring = ringOf(grid, j);
        for (int k = 0; k < grid.sectors; ++k) {
            const auto i = static_cast<std::size_t>(j * grid.sectors + k);
            const auto& radiance = cells[i].radiance;
            out.irradiance += radiance * weight;
            out.rotation.add(azimuth(step * (static_cast<float>(k) + 0.5F)) * (weight * ring.meanTangent), radiance);
            out.translation.add(weights[i], radiance);
        }
    }
    out.translation *= believed(out.translation, weights, noise2(grid, cells));
    return out;
}

float harmonicMean(std::span<const HemisphereCell> cells) {
    float sum = 0;
    for (const auto& cell : cells) sum += 1 / cell.distance;
    return static_cast<float>(cells.size()) / sum;
}

}  // namespace luxdeck

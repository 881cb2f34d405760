#include "engine/volume/field.h"

#include "engine/core/parallel.h"
#include "engine/volume/corners.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace luxdeck {

Result<VolumeField> VolumeField::make(const IrradianceVolume& volume, const FieldSettings& settings) {
    if (settings.order < 0 || settings.order > 1'000'000)
        return Error{ErrorCode::InvalidArgument, fmt::format("a moment of order {}, expected 0 (radiance) .. 1000000", settings.order)};
    std::optional<MomentWeights> weights;
    if (settings.order > 0) weights.emplace(volume.bins(), settings.order, settings.quadrature);
    return make(volume, settings, weights ? &*weights : nullptr);
}

Result<VolumeField> VolumeField::make(const IrradianceVolume& volume, const FieldSettings& settings, const MomentWeights* weights) {
    if (settings.degree < 0 || settings.degree > 8)
        return Error{ErrorCode::InvalidArgument, fmt::format("spherical harmonics of degree {}, expected 0 .. 8", settings.degree)};
    VolumeField out(volume, settings);
    settings.basis == Basis::Bins ? out.fillBins(weights) : out.fillHarmonics(weights);
    return out;
}

/// One vertex' values for all bins.
std::vector<Rgb> VolumeField::sphere(std::size_t vertex, const MomentWeights* weights) const {
    const std::size_t count = volume_->binCount();
    const bool direct = settings_.part != LightPart::Indirect, indirect = settings_.part != LightPart::Direct;
    const auto fromDirect = volume_->directAt(vertex), fromIndirect = volume_->indirectAt(vertex);
    const auto& sources = volume_->sources[vertex];
    const auto wanted = [&](const SourceRay& ray) { return ray.direct ? direct : indirect; };
    std::vector<Rgb> radiance(count), values(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (direct) radiance[i] += fromDirect[i];
        if (indirect) radiance[i] += fromIndirect[i];
    }
    if (weights == nullptr) {  // radiance itself: sources spread over their bins
        for (const auto& ray : sources)
            if (wanted(ray)) radiance[static_cast<std::size_t>(bins_.binOf(ray.direction.normalized()))] += ray.lux * static_cast<float>(1 / bins_.solidAngleSr());
        return radiance;
    }
    std::array<std::vector<float>, 3> sums;
    for (auto& channel : sums) channel.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto spread = weights->of(static_cast<int>(i));
        const std::array<float, 3> light{radiance[i].r, radiance[i].g, radiance[i].b};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            float* to = sums[channel].data();
            if (light[channel] != 0)
                for (std::size_t out = 0; out < count; ++out) to[out] += spread[out] * light[channel];
        }
    }
    for (std::size_t out = 0; out < count; ++out) {
        values[out] = {sums[0][out], sums[1][out], sums[2][out]};
        const Vec3 direction = bins_.centre(static_cast<int>(out));
        for (const auto& ray : sources)
            if (wanted(ray)) values[out] += ray.lux * momentKernel(settings_.order, dot(ray.direction, direction));
    }
    return values;
}

void VolumeField::fillBins(const MomentWeights* weights) {
    const std::size_t vertices = volume_->vertexCount(), bins = volume_->binCount();
    values_.resize(vertices * bins);
    parallelFor(vertices, [&](std::size_t v) {
        const auto values = sphere(v, weights);
        for (std::size_t bin = 0; bin < bins; ++bin) values_[bin * vertices + v] = values[bin];
    });
}

void VolumeField::fillHarmonics(const MomentWeights* weights) {
    const std::size_t vertices = volume_->vertexCount(), bins = volume_->binCount();
    const auto terms = static_cast<std::size_t>((settings_.degree + 1) * (settings_.degree + 1));
    std::vector<float> basis(bins * terms);
    for (std::size_t bin = 0; bin < bins; ++bin)
        sphericalHarmonics(bins_.centre(static_cast<int>(bin)), settings_.degree, {basis.data() + bin * terms, terms});
    values_.resize(vertices * terms);
    std::vector<double> error2(vertices), value2(vertices), worst2(vertices);
    const auto solidAngle = static_cast<float>(bins_.solidAngleSr());
    parallelFor(vertices, [&](std::size_t v) {
        const auto values = sphere(v, weights);
        std::vector<Rgb> coefficients(terms);
        for (std::size_t bin = 0; bin < bins; ++bin)
            for (std::size_t k = 0; k < terms; ++k) coefficients[k] += values[bin] * (basis[bin * terms + k] * solidAngle);
        for (std::size_t bin = 0; bin < bins; ++bin) {
            Rgb back;
            for (std::size_t k = 0; k < terms; ++k) back += coefficients[k] * basis[bin * terms + k];
            const double y = luminance(values[bin], volume_->weights), off = luminance(back, volume_->weights) - y;
            error2[v] += off * off, value2[v] += y * y, worst2[v] = std::max(worst2[v], off * off);
        }
        for (std::size_t k = 0; k < terms; ++k) values_[k * vertices + v] = coefficients[k];
    });
    double error = 0, value = 0, worst = 0;
    for (std::size_t v = 0; v < vertices; ++v) error += error2[v], value += value2[v], worst = std::max(worst, worst2[v]);
    if (!(value > 0)) return;
    basisErrorRms_ = std::sqrt(error / value);
    basisErrorMax_ = std::sqrt(worst * static_cast<double>(vertices * bins) / value);
}

VolumeField::Look VolumeField::look(const Vec3& direction) const {
    Look out;
    if (settings_.basis == Basis::Harmonics) {
        out.count = (settings_.degree + 1) * (settings_.degree + 1);
        sphericalHarmonics(direction, settings_.degree, out.harmonics);
    } else if (settings_.blendBins) {
        out.count = 4;
        out.blend = bins_.blend(direction);
    } else {
        out.blend.bin[0] = bins_.binOf(direction), out.blend.weight[0] = 1;
    }
    return out;
}

Rgb VolumeField::atVertex(std::uint32_t vertex, const Look& look) const {
    const std::size_t vertices = volume_->vertexCount();
    if (settings_.basis == Basis::Bins && look.count == 1) return values_[static_cast<std::size_t>(look.blend.bin[0]) * vertices + vertex];
    Rgb sum;
    for (int i = 0; i < look.count; ++i) {
        const bool bins = settings_.basis == Basis::Bins;
        const auto row = static_cast<std::size_t>(bins ? look.blend.bin[i] : i);
        sum += values_[row * vertices + vertex] * (bins ? look.blend.weight[i] : look.harmonics[static_cast<std::size_t>(i)]);
    }
    return sum;
}

Rgb VolumeField::at(const Vec3& position, const Vec3& direction) const {
    Rgb value;
    at({&position, 1}, {&direction, 1}, {&value, 1});
    return value;
}

void VolumeField::at(std::span<const Vec3> positions, std::span<const Vec3> directions, std::span<Rgb> values) const {
    constexpr std::size_t kBlock = 32;  // memory of so many questions is asked for before the first is answered
    const std::size_t vertices = volume_->vertexCount();
    const auto& lattice = volume_->lattice;
    const bool quick = settings_.basis == Basis::Bins && !settings_.blendBins;
    std::array<Lattice::Place, kBlock> places{};
    std::array<const Rgb*, kBlock> rows{};
    for (std::size_t first = 0; first < positions.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, positions.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            places[i] = lattice.locate(positions[first + i]);
            if (!quick) continue;
            rows[i] = values_.data() + static_cast<std::size_t>(bins_.binOf(directions[first + i])) * vertices;
            const auto& corners = lattice.cells()[places[i].cell].vertices;
            for (const auto corner : corners) __builtin_prefetch(rows[i] + corner);
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto& corners = lattice.cells()[places[i].cell].vertices;
            const auto weights = trilinearWeights(places[i].fraction);
            Rgb sum;
            if (quick) {
                for (std::size_t c = 0; c < 8; ++c) sum += rows[i][corners[c]] * weights[c];
            } else {
                const auto seen = look(directions[first + i]);
                for (std::size_t c = 0; c < 8; ++c) sum += atVertex(corners[c], seen) * weights[c];
            }
            values[first + i] = sum;
        }
    }
}

void sphericalHarmonics(const Vec3& direction, int degree, std::span<float> values) {
    const double x = direction.x, y = direction.y, z = direction.z;
    // Legendre's functions without their sine, which cos(m a) and sin(m a) carry as powers of x and y: stable at the poles.
    std::array<std::array<double, 9>, 9> p{};
    p[0][0] = 1;
    for (int m = 1; m <= degree; ++m) p[m][m] = (2 * m - 1) * p[m - 1][m - 1];
    for (int m = 0; m < degree; ++m) p[m + 1][m] = z * (2 * m + 1) * p[m][m];
    for (int m = 0; m <= degree; ++m)
        for (int l = m + 2; l <= degree; ++l) p[l][m] = (z * (2 * l - 1) * p[l - 1][m] - (l + m - 1) * p[l - 2][m]) / (l - m);
    double c = 1, s = 0;
    for (int m = 0; m <= degree; ++m) {
        for (int l = m; l <= degree; ++l) {
            double ratio = 1;
            for (int k = l - m + 1; k <= l + m; ++k) ratio /= k;
            const double scale = std::sqrt((2 * l + 1) / (4 * kPiD) * ratio * (m == 0 ? 1 : 2));
            const auto middle = static_cast<std::size_t>(l * (l + 1));
            values[middle + static_cast<std::size_t>(m)] = static_cast<float>(scale * p[l][m] * c);
            if (m > 0) values[middle - static_cast<std::size_t>(m)] = static_cast<float>(scale * p[l][m] * s);
        }
        const double next = x * c - y * s;
        s = x * s + y * c, c = next;
    }
}

}  // namespace luxdeck

#include "engine/transport/surface/microfacet.h"

#include "engine/sampling/sobol.h"
#include "engine/sampling/warp.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck {

float Ggx::distribution(const Vec3& h) const {
    const float a2 = alpha * alpha;
    const float sin2 = h.x * h.x + h.y * h.y;  // not 1 - z^2, which cancels for narrow lobes
    const float t = a2 * h.z * h.z + sin2;
    return a2 / (kPi * t * t);
}

float Ggx::lambda(float cosine) const {
    const float c2 = cosine * cosine;
    return 0.5F * (std::sqrt(1 + alpha * alpha * std::max(0.0F, 1 - c2) / c2) - 1);
}

float Ggx::lobe(const Vec3& wo, const Vec3& wi) const {
    const Vec3 h = (wo + wi).normalized();
    return distribution(h) / ((1 + lambda(wo.z) + lambda(wi.z)) * 4 * wo.z * wi.z);
}

Vec3 Ggx::sampleVisible(const Vec3& wo, Vec2 u) const {
    const Vec3 stretched = Vec3(alpha * wo.x, alpha * wo.y, wo.z).normalized();
    const float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
    const Vec3 t1 = length2 > 0 ? Vec3(-stretched.y, stretched.x, 0) / std::sqrt(length2) : Vec3(1, 0, 0);
    const Vec3 t2 = cross(stretched, t1);
    const float radius = std::sqrt(u.x), angle = 2 * kPi * u.y;
    const float p1 = radius * std::cos(angle);
    const float s = 0.5F * (1 + stretched.z);
    const float p2 = (1 - s) * std::sqrt(std::max(0.0F, 1 - p1 * p1)) + s * radius * std::sin(angle);
    const Vec3 n = t1 * p1 + t2 * p2 + stretched * std::sqrt(std::max(0.0F, 1 - p1 * p1 - p2 * p2));
    return Vec3(alpha * n.x, alpha * n.y, std::max(1e-6F, n.z)).normalized();
}

float Ggx::pdf(const Vec3& wo, const Vec3& wi) const {
    const Vec3 h = (wo + wi).normalized();
    return distribution(h) / ((1 + lambda(wo.z)) * 4 * wo.z);
}

namespace {

constexpr int kSide = 32;

/// Directional albedo over (cosine, roughness = sqrt(alpha)), cell centres inside, ends on the ends.
struct AlbedoTable {
    std::array<std::array<LobeAlbedo, kSide>, kSide> directional;  // [roughness][cosine]
    std::array<LobeAlbedo, kSide> mean;

    AlbedoTable();
};

LobeAlbedo integrateLobe(float cosine, float alpha) {
    constexpr std::uint32_t kPoints = 1024;
    const Ggx ggx{alpha};
    const Vec3 wo{std::sqrt(std::max(0.0F, 1 - cosine * cosine)), 0, cosine};
    double bare = 0, grazing = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const Vec2 u{(static_cast<float>(i) + 0.5F) / kPoints, unitFloat(reverseBits(i))};
        const Vec3 h = ggx.sampleVisible(wo, u);
        const float woDotH = dot(wo, h);
        const Vec3 wi = h * (2 * woDotH) - wo;
        if (wi.z <= 0) continue;
        const float weight = (1 + ggx.lambda(wo.z)) / (1 + ggx.lambda(wo.z) + ggx.lambda(wi.z));
        const float fresnel = schlick(std::clamp(woDotH, 0.0F, 1.0F));
        bare += weight * (1 - fresnel);
        grazing += weight * fresnel;
    }
    return {static_cast<float>(bare / kPoints), static_cast<float>(grazing / kPoints)};
}

AlbedoTable::AlbedoTable() {
    for (int r = 0; r < kSide; ++r) {
        const float roughness = static_cast<float>(r) / (kSide - 1), alpha = std::max(roughness * roughness, 1e-4F);
        double bare = 0, grazing = 0, weight = 0;
        for (int c = 0; c < kSide; ++c) {
            const float cosine = std::max(static_cast<float>(c) / (kSide - 1), 1e-3F);
            auto& e = directional[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = integrateLobe(cosine, alpha);
            // Trapezoid rule of 2 cos over the same nodes that interpolation uses.
            const double w = (c == 0 || c == kSide - 1 ? 0.5 : 1.0) * 2 * cosine;
            bare += w * e.bare, grazing += w * e.grazing, weight += w;
        }
        mean[static_cast<std::size_t>(r)] = {static_cast<float>(bare / weight), static_cast<float>(grazing / weight)};
    }
}

const AlbedoTable& albedoTable() {
    static const AlbedoTable table;
    return table;
}

LobeAlbedo between(const LobeAlbedo& a, const LobeAlbedo& b, float t) {
    return {a.bare + t * (b.bare - a.bare), a.grazing + t * (b.grazing - a.grazing)};
}

struct Cell {
    std::size_t low;
    float fraction;
};
Cell cellOf(float x) {
    const float scaled = std::clamp(x, 0.0F, 1.0F) * (kSide - 1);
    const auto low = std::min(static_cast<std::size_t>(scaled), static_cast<std::size_t>(kSide - 2));
    return {low, scaled - static_cast<float>(low)};
}

}  // namespace

LobeAlbedo lobeAlbedo(float cosine, float alpha) {
    const auto& table = albedoTable().directional;
    const auto r = cellOf(std::sqrt(alpha)), c = cellOf(cosine);
    return between(between(table[r.low][c.low], table[r.low][c.low + 1], c.fraction),
                   between(table[r.low + 1][c.low], table[r.low + 1][c.low + 1], c.fraction), r.fraction);
}

LobeAlbedo meanLobeAlbedo(float alpha) {
    const auto r = cellOf(std::sqrt(alpha));
    return between(albedoTable().mean[r.low], albedoTable().mean[r.low + 1], r.fraction);
}

}  // namespace luxdeck

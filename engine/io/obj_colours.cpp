#include "engine/io/obj_colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::obj {

namespace {

/// Texels of a row, and rows. With more colours than fit, all are rounded to fewer steps.
constexpr std::uint32_t kSide = 256;

std::uint8_t step(float value, int bits) {
    const auto most = static_cast<float>((1 << bits) - 1);
    return static_cast<std::uint8_t>(std::lround(std::round(value * most) / most * 255.0F));
}

}  // namespace

void VertexColours::add(std::size_t vertex, const Vec3& colour) {
    if (vertex >= colours_.size()) {
        colours_.resize(vertex + 1);
        known_.resize(vertex + 1, false);
    }
    colours_[vertex] = colour;
    known_[vertex] = true;
}

std::uint32_t VertexColours::face(const std::vector<std::uint32_t>& vertices) {
    Vec3 sum(0.0F);
    for (const auto vertex : vertices) sum += colours_[vertex];
    sum /= static_cast<float>(vertices.size());
    const auto [known, isNew] = numbers_.try_emplace({sum.x, sum.y, sum.z}, static_cast<std::uint32_t>(faces_.size()));
    if (isNew) faces_.push_back(sum);
    return known->second;
}

std::uint32_t VertexColours::addMaterial(Scene& scene, const std::string& name) {
    if (texture_ < 0) {
        texture_ = static_cast<std::int32_t>(scene.textures.size());
        scene.textures.emplace_back().name = "vertex colours";
    }
    materials_.push_back(static_cast<std::uint32_t>(scene.materials.size()));
    auto& material = scene.materials.emplace_back();
    material.name = name.empty() ? "vertex colours" : name;
    material.source = "the colours of the vertices, a face's mean, taken as reflectances";
    material.reflectanceTexture.texture = texture_;
    return materials_.back();
}

Vec2 VertexColours::uv(std::uint32_t face) const {
    const auto texel = texels_[face];
    return {(static_cast<float>(texel % width_) + 0.5F) / static_cast<float>(width_),
            (static_cast<float>(texel / width_) + 0.5F) / static_cast<float>(height_)};
}

void VertexColours::finish(Scene& scene, WarningList& warnings, bool mayCountTo255) {
    if (materials_.empty()) return;
    warnings.add("vertex colours are taken as reflectances (linear), each face with the mean of its corners");
    float most = 0;
    bool clamped = false;
    for (const auto& c : faces_) most = std::max({most, c.x, c.y, c.z});
    const bool bytes = most > 1 && mayCountTo255;
    const float unit = bytes ? 255.0F : 1.0F;
    if (bytes) warnings.add("vertex colours go beyond 1: taken as counting to 255");
    for (auto& c : faces_)
        for (auto* x : {&c.x, &c.y, &c.z}) {
            const float fraction = std::clamp(*x / unit, 0.0F, 1.0F);
            clamped |= fraction != *x / unit;
            *x = fraction;
        }
    if (clamped) warnings.add("vertex colours below 0 or above their range are clamped");

    Vec3 largest(0.0F);  // the material's reflectance, of which the texels are fractions
    for (const auto& c : faces_)
        largest = {std::max(largest.x, c.x), std::max(largest.y, c.y), std::max(largest.z, c.z)};
    const auto part = [](float value, float of) { return of > 0 ? value / of : 0.0F; };
    std::map<std::array<std::uint8_t, 3>, std::uint32_t> palette;
    for (int bits = 8;; --bits) {
        palette.clear(), texels_.clear();
        for (const auto& c : faces_) {
            const std::array<std::uint8_t, 3> code{step(part(c.x, largest.x), bits), step(part(c.y, largest.y), bits),
                                                   step(part(c.z, largest.z), bits)};
            texels_.push_back(palette.try_emplace(code, static_cast<std::uint32_t>(palette.size())).first->second);
        }
        if (palette.size() <= kSide * kSide) {
            if (bits < 8)
                warnings.add(fmt::format("vertex colours are rounded to {} steps of each channel", (1 << bits) - 1));
            break;
        }
    }
    const auto count = static_cast<std::uint32_t>(palette.size());
    width_ = std::min(count, kSide), height_ = (count + width_ - 1) / width_;
    auto& texture = scene.textures[static_cast<std::size_t>(texture_)];
    texture.width = static_cast<int>(width_), texture.height = static_cast<int>(height_);
    texture.srgb = false;
    texture.wrapU = texture.wrapV = TextureWrap::Clamp;
    texture.rgba.assign(std::size_t{4} * width_ * height_, 255);
    for (const auto& [code, texel] : palette)
        std::copy(code.begin(), code.end(), texture.rgba.begin() + 4 * std::ptrdiff_t{texel});
    for (const auto material : materials_) scene.materials[material].reflectance = {largest.x, largest.y, largest.z};
}

}  // namespace luxdeck::obj

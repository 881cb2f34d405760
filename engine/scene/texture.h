#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace luxdeck {

enum class TextureWrap { Repeat, Clamp, Mirror };

/// An 8-bit RGBA picture, rows from the top, looked up bilinearly; `srgb` texels are decoded to linear.
struct Texture {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  ///< #P x 4
    bool srgb = true;
    TextureWrap wrapU = TextureWrap::Repeat;
    TextureWrap wrapV = TextureWrap::Repeat;

    /// Linear colour at (u, v), v down from the top row (glTF's convention).
    [[nodiscard]] Rgb sample(Vec2 uv) const;
    /// The alpha channel there, 0..1, looked up the same way.
    [[nodiscard]] float alpha(Vec2 uv) const;
};

/// A use of a texture: which one (-1: none), and the transform of its coordinates
/// (KHR_texture_transform): uv' = T * R * S * uv.
struct TextureSlot {
    std::int32_t texture = -1;
    Vec2 offset{0, 0};
    Vec2 scale{1, 1};
    float rotation = 0;  ///< radians, counter-clockwise

    [[nodiscard]] bool used() const { return texture >= 0; }
    [[nodiscard]] Vec2 apply(Vec2 uv) const;
};

}  // namespace luxdeck

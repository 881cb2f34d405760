#pragma once

#include "engine/core/result.h"
#include "engine/scene/texture.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace luxdeck {

/// More pixels than this in one texture are refused (8192 x 8192: 256 MB as RGBA).
inline constexpr std::uint64_t kMaxTexturePixels = 1ULL << 26;

/// A PNG or JPEG picture, told apart by its first bytes, as 8-bit RGBA. Gamma and colour profiles in the
/// file are ignored, as glTF asks: colour textures are sRGB, others plain numbers (`Texture::srgb` is left
/// for the caller to set).
///
/// name    what messages call the picture
/// errors  Parse (damaged, or a size that its bytes cannot hold), Unsupported (another format, CMYK, too large)
Result<Texture> decodeTexture(std::string_view bytes, const std::string& name);

}  // namespace luxdeck

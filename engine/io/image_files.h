#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"

#include <filesystem>

namespace luxdeck {

/// Float OpenEXR: every channel 32-bit float, ZIP; Image::text and Image::numbers become header attributes
/// (whiteLuminance among them), chromaticities those of Rec.709 unless the picture says otherwise.
/// Atomic: a full disk leaves the old file.
Result<void> writeExr(const std::filesystem::path& path, const Image& image);
Result<Image> readExr(const std::filesystem::path& path);

/// Radiance RGBE/XYZE (.hdr, .pic): EXPOSURE, PRIMARIES and orientation obeyed; pixels come back in cd/m^2
/// by 179 lm/W, converted to Rec.709 from the header's primaries (Radiance's own when it has none).
Result<Image> readRgbe(const std::filesystem::path& path);
Result<void> writeRgbe(const std::filesystem::path& path, const Image& image);

/// By extension: .exr, .hdr, .pic, .rgbe.
Result<Image> readHdrImage(const std::filesystem::path& path);

/// 8-bit sRGB PNG with text chunks.
Result<void> writePng(const std::filesystem::path& path, const DisplayImage& image);
Result<DisplayImage> readPng(const std::filesystem::path& path);

}  // namespace luxdeck

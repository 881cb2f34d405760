#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace luxdeck {

/// No picture with a longer side, or with more values in all its channels, is read or written: a few
/// hostile bytes must not ask for gigabytes.
inline constexpr int kLargestImageSide = 65536;
inline constexpr std::uint64_t kMostImageValues = 1ULL << 29;

/// Float OpenEXR: every channel 32-bit float, ZIP; Image::text and Image::numbers become header attributes
/// (whiteLuminance among them), chromaticities are those of the picture's weights. Atomic: a full disk
/// leaves the old file.
///
/// errors  InvalidArgument (nothing to write, folder missing), OutOfResources (disk, memory)
Result<void> writeExr(const std::filesystem::path& path, const Image& image);

/// Any flat OpenEXR, tiled or by scanlines, half, float or uint: the data window of the first part, as float.
/// A whiteLuminance other than 1 is multiplied into the R, G, B and Y channels, which are then in cd/m^2;
/// without one, the file does not say what its values are and Image::numbers has no whiteLuminance.
///
/// errors  FileNotFound, Parse (with what OpenEXR says), Unsupported (deep or subsampled), OutOfResources
Result<Image> readExr(const std::filesystem::path& path);
/// The same from memory; `name` is what messages call it.
Result<Image> parseExr(std::string_view bytes, const std::filesystem::path& name);

/// Radiance RGBE/XYZE (.hdr, .pic): EXPOSURE, COLORCORR, PRIMARIES and all eight orientations obeyed; pixels
/// come back in cd/m^2 by 179 lm/W (XYZE is in cd/m^2 already), converted to Rec.709 from the header's primaries
/// (Radiance's own when it has none) so that luminance is kept exactly. The last VIEW= is Image::text["VIEW"].
///
/// errors  FileNotFound, Parse ("file:line" in the header, the scanline after it), OutOfResources
Result<Image> readRgbe(const std::filesystem::path& path);
Result<Image> parseRgbe(std::string_view bytes, const std::filesystem::path& name);

/// Writes W/(sr m^2) by 179 lm/W with the picture's primaries in the header, run-length encoded. Relative
/// precision 1/256 of the largest channel. Negative values become 0: the format has none.
///
/// errors  InvalidArgument (a pixel is not finite: the format has no such value), OutOfResources
Result<void> writeRgbe(const std::filesystem::path& path, const Image& image);

/// By extension: .exr, .hdr, .pic, .rgbe, .xyze.
Result<Image> readHdrImage(const std::filesystem::path& path);

/// 8-bit sRGB PNG with text chunks.
///
/// errors  InvalidArgument (sizes do not agree, a text key not of 1..79 printable characters), OutOfResources
Result<void> writePng(const std::filesystem::path& path, const DisplayImage& image);

/// Any PNG as 8-bit RGB: palettes and greys expanded, 16 bits rounded to 8, alpha dropped.
///
/// errors  FileNotFound, Parse, OutOfResources
Result<DisplayImage> readPng(const std::filesystem::path& path);
Result<DisplayImage> parsePng(std::string_view bytes, const std::filesystem::path& name);

}  // namespace luxdeck

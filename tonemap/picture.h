#pragma once

#include "engine/core/image.h"
#include "engine/core/rgb.h"

#include <cstddef>
#include <vector>

namespace luxdeck::tonemap {

/// Linear Rec.709 pixels [cd/m^2], rows from the top; #P = width * height.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels;

    [[nodiscard]] const Rgb& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] Rgb& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// A picture that the operators can work on, and what had to be done for that.
struct CleanedPicture {
    Picture picture;
    std::size_t nonFinite = 0;  ///< pixels that were NaN or infinite: the mean of their finite neighbours now
    std::size_t negative = 0;   ///< pixels with a channel below 0: that channel is 0 now
};

/// R, G, B (or Y as grey) of an image, in Rec.709, finite and not negative. The image must have such channels.
CleanedPicture cleaned(const Image& image);

/// The mean over each of width x height equal boxes (both at most the picture's own), with fractional borders.
Picture boxResampled(const Picture& picture, int width, int height);

/// Bilinear value at a point in units of the picture's pixels from the upper left corner; constant beyond the
/// centres of border pixels.
Rgb bilinear(const Picture& picture, double x, double y);

}  // namespace luxdeck::tonemap

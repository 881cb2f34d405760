#include "tonemap/foveal_image.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

int sampleCount(double degrees, int pixels) {
    return std::min(std::max(2, static_cast<int>(std::lround(degrees))), pixels);
}

}  // namespace

std::vector<double> FovealImage::luminances() const {
    std::vector<double> out;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (inView(i)) out.push_back(luminance(picture.pixels[i]));
    return out;
}

FovealImage fovealImage(const Picture& picture, const PixelDirections& pixels) {
    const int width = sampleCount(pixels.widthDegrees(), picture.width);
    const int height = sampleCount(pixels.heightDegrees(), picture.height);
    FovealImage out{boxResampled(picture, width, height), {}, {}};
    const double stepX = static_cast<double>(picture.width) / width,
                 stepY = static_cast<double>(picture.height) / height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double px = (x + 0.5) * stepX, py = (y + 0.5) * stepY;
            out.directions.push_back(pixels.direction(px, py));
            out.solidAngles.push_back(pixels.pixelSolidAngle(px, py) * stepX * stepY);
        }
    return out;
}

}  // namespace luxdeck::tonemap

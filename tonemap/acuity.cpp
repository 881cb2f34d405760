#include "tonemap/acuity.h"

#include "engine/core/parallel.h"
#include "tonemap/adaptation.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

/// Means of 2 x 2 pixels; an odd last row or column stands for itself.
Picture halved(const Picture& p) {
    Picture out{(p.width + 1) / 2, (p.height + 1) / 2, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int x1 = std::min(2 * x + 1, p.width - 1), y1 = std::min(2 * y + 1, p.height - 1);
            out.pixels.push_back((p.at(2 * x, 2 * y) + p.at(x1, 2 * y) + p.at(2 * x, y1) + p.at(x1, y1)) * 0.25F);
        }
    return out;
}

/// Level 0 is the picture itself.
std::vector<Picture> pyramid(const Picture& picture, double largestSample) {
    std::vector<Picture> levels{picture};
    while ((1 << (levels.size() - 1)) < largestSample && (levels.back().width > 1 || levels.back().height > 1))
        levels.push_back(halved(levels.back()));
    return levels;
}

Rgb readPyramid(const std::vector<Picture>& levels, double x, double y, double sampleSize) {
    const double level = std::clamp(std::log2(std::max(sampleSize, 1.0)), 0.0, static_cast<double>(levels.size() - 1));
    const auto low = static_cast<std::size_t>(level);
    const auto at = [&](std::size_t l) {
        return bilinear(levels[l], std::ldexp(x, -static_cast<int>(l)), std::ldexp(y, -static_cast<int>(l)));
    };
    const auto fraction = static_cast<float>(level - static_cast<double>(low));
    if (fraction == 0) return at(low);
    return at(low) * (1 - fraction) + at(low + 1) * fraction;
}

}  // namespace

std::vector<double> visibleSampleSizes(const FovealImage& foveal, const PixelDirections& pixels, int width,
                                       int height) {
    std::vector<double> sizes;
    const auto& samples = foveal.picture;
    for (int y = 0; y < samples.height; ++y)
        for (int x = 0; x < samples.width; ++x) {
            const double pixelsPerDegree =
                pixels.pixelsPerDegree((x + 0.5) * width / samples.width, (y + 0.5) * height / samples.height);
            sizes.push_back(0.5 * pixelsPerDegree / visualAcuity(luminance(samples.at(x, y))));
        }
    return sizes;
}

Picture blurredToAcuity(const Picture& picture, const FovealImage& foveal, const std::vector<double>& sampleSizes) {
    const auto levels = pyramid(picture, *std::ranges::max_element(sampleSizes));
    Picture sizes{foveal.picture.width, foveal.picture.height, {}};
    for (const double s : sampleSizes) sizes.pixels.emplace_back(static_cast<float>(s));
    Picture out{picture.width, picture.height, std::vector<Rgb>(picture.pixels.size())};
    const double stepX = static_cast<double>(sizes.width) / picture.width,
                 stepY = static_cast<double>(sizes.height) / picture.height;
    parallelFor(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
        for (int x = 0; x < picture.width; ++x) {
            const double px = x + 0.5, py = static_cast<double>(row) + 0.5;
            const double size = bilinear(sizes, px * stepX, py * stepY).r;
            out.at(x, static_cast<int>(row)) = readPyramid(levels, px, py, size);
        }
    });
    return out;
}

}  // namespace luxdeck::tonemap

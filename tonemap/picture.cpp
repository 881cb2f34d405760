#include "tonemap/picture.h"

#include "engine/core/parallel.h"
#include "engine/core/primaries.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

/// The mean of the finite ones among a pixel's eight neighbours; black without any.
Rgb neighbourMean(const std::vector<Rgb>& pixels, int width, int height, int x, int y) {
    Rgb sum;
    int count = 0;
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, height - 1); ++ny)
        for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, width - 1); ++nx) {
            const Rgb& c =
                pixels[static_cast<std::size_t>(ny) * static_cast<std::size_t>(width) + static_cast<std::size_t>(nx)];
            if (!isFinite(c)) continue;
            sum += c;
            ++count;
        }
    return count > 0 ? sum / static_cast<float>(count) : Rgb();
}

/// Weights of the source cells under one target cell.
struct Span {
    int first = 0;
    std::vector<float> weights;  // sum to 1
};

std::vector<Span> spans(int source, int target) {
    std::vector<Span> out(static_cast<std::size_t>(target));
    const double step = static_cast<double>(source) / target;
    for (int i = 0; i < target; ++i) {
        const double begin = i * step, end = std::min((i + 1) * step, static_cast<double>(source));
        auto& span = out[static_cast<std::size_t>(i)];
        span.first = static_cast<int>(begin);
        for (int k = span.first; k < std::min(static_cast<int>(std::ceil(end - 1e-9)), source); ++k)
            span.weights.push_back(
                static_cast<float>((std::min(k + 1.0, end) - std::max<double>(k, begin)) / (end - begin)));
    }
    return out;
}

}  // namespace

CleanedPicture cleaned(const Image& image) {
    CleanedPicture out;
    const auto raw = colours(image);
    out.picture = {image.width(), image.height(), raw};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            Rgb& c = out.picture.at(x, y);
            if (isFinite(c)) continue;
            ++out.nonFinite;
            c = neighbourMean(raw, image.width(), image.height(), x, y);
        }
    const auto matrix = rgbToRgb(chromaticitiesOf(image.weights), kRec709Chromaticities);
    const bool converts = image.hasColour() && matrix != Imath::M33d();
    for (Rgb& c : out.picture.pixels) {
        if (c.min() < 0) {
            ++out.negative;
            c = {std::max(c.r, 0.0F), std::max(c.g, 0.0F), std::max(c.b, 0.0F)};
        }
        if (!converts) continue;
        c = transformed(c, matrix);  // a colour outside of Rec.709 goes to its border
        c = {std::max(c.r, 0.0F), std::max(c.g, 0.0F), std::max(c.b, 0.0F)};
    }
    return out;
}

Picture boxResampled(const Picture& picture, int width, int height) {
    const auto columns = spans(picture.width, width), rows = spans(picture.height, height);
    Picture narrow{width, picture.height,
                   std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(picture.height))};
    parallelFor(static_cast<std::size_t>(picture.height), [&](std::size_t y) {
        for (int x = 0; x < width; ++x) {
            const auto& span = columns[static_cast<std::size_t>(x)];
            Rgb sum;
            for (std::size_t k = 0; k < span.weights.size(); ++k)
                sum += picture.at(span.first + static_cast<int>(k), static_cast<int>(y)) * span.weights[k];
            narrow.at(x, static_cast<int>(y)) = sum;
        }
    });
    Picture out{width, height, std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    for (int y = 0; y < height; ++y) {
        const auto& span = rows[static_cast<std::size_t>(y)];
        for (std::size_t k = 0; k < span.weights.size(); ++k)
            for (int x = 0; x < width; ++x)
                out.at(x, y) += narrow.at(x, span.first + static_cast<int>(k)) * span.weights[k];
    }
    return out;
}

Rgb bilinear(const Picture& picture, double x, double y) {
    const double px = std::clamp(x - 0.5, 0.0, picture.width - 1.0),
                 py = std::clamp(y - 0.5, 0.0, picture.height - 1.0);
    const int x0 = static_cast<int>(px), y0 = static_cast<int>(py);
    const int x1 = std::min(x0 + 1, picture.width - 1), y1 = std::min(y0 + 1, picture.height - 1);
    const auto fx = static_cast<float>(px - x0), fy = static_cast<float>(py - y0);
    const Rgb top = picture.at(x0, y0) * (1 - fx) + picture.at(x1, y0) * fx;
    const Rgb bottom = picture.at(x0, y1) * (1 - fx) + picture.at(x1, y1) * fx;
    return top * (1 - fy) + bottom * fy;
}

}  // namespace luxdeck::tonemap

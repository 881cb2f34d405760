#pragma once

#include "tonemap/foveal_image.h"

#include <vector>

namespace luxdeck::tonemap {

/// How large a sample the adapted eye still tells apart, in the picture's pixels, for each foveal sample, #S:
/// half a cycle of the finest visible grating (Nyquist). At most 1 means that the eye sees every pixel.
/// Radiance's pcond blurs by sqrt(2) more.
///
/// foveal  what the eye is adapted to, with the veil
/// source  Larson et al. 1997, section 5.2
std::vector<double> visibleSampleSizes(const FovealImage& foveal, const PixelDirections& pixels, int width, int height);

/// The picture without what the eye would not resolve: each pixel is read from a pyramid of means at the level
/// that its interpolated sample size asks for.
Picture blurredToAcuity(const Picture& picture, const FovealImage& foveal, const std::vector<double>& sampleSizes);

}  // namespace luxdeck::tonemap

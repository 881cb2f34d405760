#pragma once

#include "tonemap/picture.h"
#include "tonemap/view_geometry.h"

#include <vector>

namespace luxdeck::tonemap {

/// What the eye adapts to as it looks around: a sample for about each degree of the view, the mean over its box.
struct FovealImage {
    Picture picture;                   ///< #S samples [cd/m^2]
    std::vector<Vec3d> directions;     ///< #S unit; zero outside of a fisheye's circle
    std::vector<double> solidAngles;   ///< #S [sr]; 0 outside

    [[nodiscard]] bool inView(std::size_t i) const { return solidAngles[i] > 0; }
    /// Luminances of the samples in view [cd/m^2].
    [[nodiscard]] std::vector<double> luminances() const;
};

/// At least 2 x 2 samples, and never more than the picture has pixels.
///
/// source  Larson et al. 1997, section 4.1
FovealImage fovealImage(const Picture& picture, const PixelDirections& pixels);

}  // namespace luxdeck::tonemap

#pragma once

#include "engine/core/image.h"
#include "engine/core/vec.h"

#include <string_view>

namespace luxdeck::tonemap {

enum class Projection {
    Perspective,
    AngularFisheye,       ///< distance from the centre proportional to the angle (Radiance -vta)
    HemisphericalFisheye  ///< proportional to its sine (Radiance -vth), 180 degrees at most
};

/// How a picture's pixels lie in the eye's field. Pixels are square.
struct ViewGeometry {
    Projection projection = Projection::Perspective;
    double verticalFovDeg = 0;  ///< 0: not known, the shorter side is taken as 40 degrees, as in Radiance's pcond

    [[nodiscard]] bool known() const { return verticalFovDeg > 0; }
};

/// The geometry that a picture's header tells: Image::text["VIEW"], Radiance's view options ("-vtv -vh 60 -vv 45").
/// Unknown when there is none, or for parallel and other views.
ViewGeometry viewGeometryOf(const Image& image);

/// The view options for a header, which viewGeometryOf() reads.
std::string viewOptions(const ViewGeometry& geometry, int width, int height);

/// Maps the pixels of one picture to directions.
class PixelDirections {
public:
    /// errors  none: an impossible angle of view (180 degrees and more in perspective) counts as unknown
    PixelDirections(const ViewGeometry& geometry, int width, int height);

    /// Unit direction of a point in pixel units from the upper left corner, the view along -z; the zero vector
    /// outside of a fisheye's circle.
    [[nodiscard]] Vec3d direction(double x, double y) const;
    /// Solid angle of the pixel about that point [sr]; 0 outside of a fisheye's circle.
    [[nodiscard]] double pixelSolidAngle(double x, double y) const;
    /// Pixels for a degree near that point; 0 outside.
    [[nodiscard]] double pixelsPerDegree(double x, double y) const;
    /// Degree-sized samples that the picture's sides hold, by the tangent plane in perspective (the paper's
    /// 2 tan(fov / 2) / 0.01745) or by angle.
    [[nodiscard]] double widthDegrees() const;
    [[nodiscard]] double heightDegrees() const;
    [[nodiscard]] const ViewGeometry& geometry() const { return geometry_; }

private:
    ViewGeometry geometry_;  // with the angle that was assumed
    double width_;
    double height_;
    double scale_;  // perspective: tangent units a pixel; angular: radians a pixel; hemispherical: sines a pixel
};

}  // namespace luxdeck::tonemap

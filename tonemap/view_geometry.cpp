#include "tonemap/view_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace luxdeck::tonemap {

namespace {

constexpr double kAssumedShorterSideDeg = 40;  // Radiance's pcond, for pictures without a view

double widestFovDeg(Projection projection) {
    switch (projection) {
        case Projection::Perspective: return 179;
        case Projection::HemisphericalFisheye: return 180;
        case Projection::AngularFisheye: break;
    }
    return 360;
}

double scaleOf(const ViewGeometry& geometry, double height) {
    const double half = 0.5 * geometry.verticalFovDeg * kDegree;
    switch (geometry.projection) {
        case Projection::Perspective: return 2 * std::tan(half) / height;
        case Projection::HemisphericalFisheye: return 2 * std::sin(half) / height;
        case Projection::AngularFisheye: break;
    }
    return 2 * half / height;
}

/// The vertical angle at which the shorter side is `degrees`.
double verticalFromShorter(double degrees, double width, double height) {
    if (height <= width) return degrees;
    return 2 / kDegree * std::atan(std::tan(0.5 * degrees * kDegree) * height / width);
}

}  // namespace

ViewGeometry viewGeometryOf(const Image& image) {
    const auto found = image.text.find("VIEW");
    if (found == image.text.end()) return {};
    std::istringstream words(found->second);
    ViewGeometry geometry;
    bool supported = true;
    double horizontalDeg = 0;
    for (std::string word; words >> word;) {
        if (word == "-vv") words >> geometry.verticalFovDeg;
        else if (word == "-vh") words >> horizontalDeg;
        else if (word.starts_with("-vt") && word.size() == 4) {
            supported = word[3] == 'v' || word[3] == 'a' || word[3] == 'h';
            geometry.projection = word[3] == 'a'   ? Projection::AngularFisheye
                                  : word[3] == 'h' ? Projection::HemisphericalFisheye
                                                   : Projection::Perspective;
        }
    }
    if (!supported || !(geometry.verticalFovDeg > 0 && geometry.verticalFovDeg <= widestFovDeg(geometry.projection)))
        return {};
    return geometry;
}

std::string viewOptions(const ViewGeometry& geometry, int width, int height) {
    const double aspect = static_cast<double>(width) / height;
    if (geometry.projection != Projection::Perspective)
        return fmt::format("-vt{} -vh {:.6g} -vv {:.6g}", geometry.projection == Projection::AngularFisheye ? 'a' : 'h',
                           geometry.verticalFovDeg * aspect, geometry.verticalFovDeg);
    const double horizontal = 2 / kDegree * std::atan(std::tan(0.5 * geometry.verticalFovDeg * kDegree) * aspect);
    return fmt::format("-vtv -vh {:.6g} -vv {:.6g}", horizontal, geometry.verticalFovDeg);
}

PixelDirections::PixelDirections(const ViewGeometry& geometry, int width, int height)
    : geometry_(geometry), width_(width), height_(height) {
    if (!(geometry_.verticalFovDeg > 0 && geometry_.verticalFovDeg <= widestFovDeg(geometry_.projection)))
        geometry_ = {Projection::Perspective, verticalFromShorter(kAssumedShorterSideDeg, width_, height_)};
    scale_ = scaleOf(geometry_, height_);
}

Vec3d PixelDirections::direction(double x, double y) const {
    const double u = (x - 0.5 * width_) * scale_, v = (0.5 * height_ - y) * scale_;
    if (geometry_.projection == Projection::Perspective) return Vec3d(u, v, -1).normalized();
    const double r = std::hypot(u, v);
    // A little over the edge is kept, so that border pixels cut by the circle still count.
    const double edge = 0.5 * height_ * scale_ + 0.5 * scale_;
    if (r > edge) return Vec3d(0);
    const double theta =
        geometry_.projection == Projection::AngularFisheye ? std::min(r, kPiD) : std::asin(std::min(r, 1.0));
    const double k = r > 0 ? std::sin(theta) / r : 1;
    return {u * k, v * k, -std::cos(theta)};
}

double PixelDirections::pixelSolidAngle(double x, double y) const {
    const Vec3d d = direction(x, y);
    if (d == Vec3d(0)) return 0;
    const double area = scale_ * scale_;
    if (geometry_.projection == Projection::Perspective) return area * std::pow(-d.z, 3);
    const double cosTheta = -d.z;
    if (geometry_.projection == Projection::HemisphericalFisheye) return area / std::max(cosTheta, 1e-3);
    const double theta = std::acos(std::clamp(cosTheta, -1.0, 1.0));
    return theta > 1e-6 ? area * std::sin(theta) / theta : area;
}

double PixelDirections::pixelsPerDegree(double x, double y) const {
    const double solidAngle = pixelSolidAngle(x, y);
    return solidAngle > 0 ? kDegree / std::sqrt(solidAngle) : 0;
}

double PixelDirections::heightDegrees() const {
    return geometry_.projection == Projection::HemisphericalFisheye ? geometry_.verticalFovDeg
                                                                    : scale_ * height_ / kDegree;
}

double PixelDirections::widthDegrees() const { return heightDegrees() * width_ / height_; }

}  // namespace luxdeck::tonemap

#include "engine/scene/sun.h"

#include <cmath>

namespace luxdeck {

namespace {

/// The integral of the cosine over a disc: exact at any size, and free of cancellation at the sun's.
double projectedSolidAngle(double halfAngleRad) {
    const double s = std::sin(halfAngleRad);
    return kPiD * s * s;
}

}  // namespace

Sun Sun::ofNormalLux(const Vec3& direction, double lux, const Rgb& colour, double halfAngleRad) {
    return {direction, halfAngleRad, colour * static_cast<float>(lux / projectedSolidAngle(halfAngleRad))};
}

double Sun::solidAngle() const {
    const double s = std::sin(halfAngleRad / 2);
    return 4 * kPiD * s * s;
}

bool Sun::covers(const Vec3& towards) const {
    // The sine tells directions a thousandth of a degree apart, which in floats the cosine does not.
    const Vec3d a(towards), b(direction);
    const double sine = std::sin(halfAngleRad);
    return a.dot(b) > 0 && a.cross(b).length2() <= sine * sine;
}

Rgb Sun::normalIrradiance() const { return radiance * static_cast<float>(projectedSolidAngle(halfAngleRad)); }

}  // namespace luxdeck

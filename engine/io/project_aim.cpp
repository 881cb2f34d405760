#include "engine/io/project_aim.h"

#include <cmath>

namespace luxdeck {

Frame luminaireFrame(const Vec3d& aim, double rotationDeg) {
    const Vec3d n = -aim.normalized();
    Vec3d c0(-1, 0, 0), c90(0, 1, 0);
    const double sideways2 = n.x * n.x + n.y * n.y;
    if (n.z > 0 || sideways2 > 0) {
        // 1 / (1 + n.z), written without the cancellation that aiming almost straight up would bring.
        const double k = n.z > 0 ? 1.0 / (1.0 + n.z) : (1.0 - n.z) / sideways2;
        c0 = Vec3d(1.0 - k * n.x * n.x, -k * n.x * n.y, -n.x);
        c90 = Vec3d(-k * n.x * n.y, 1.0 - k * n.y * n.y, -n.y);
    }
    const double turn = std::remainder(rotationDeg, 360.0) * kDegree;
    const double c = std::cos(turn), s = std::sin(turn);
    return {Vec3(c0 * c + c90 * s), Vec3(c90 * c - c0 * s), Vec3(n)};
}

Frame luminaireFrame(const AimAngles& angles) {
    const auto turn = [](Vec3d& from, Vec3d& towards, double degrees) {
        const double radians = std::remainder(degrees, 360.0) * kDegree;
        const double c = std::cos(radians), s = std::sin(radians);
        const Vec3d turned = from * c + towards * s;
        towards = towards * c - from * s;
        from = turned;
    };
    Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    turn(x, y, angles.orientDeg);
    turn(x, z, angles.tiltDeg);  // -z goes towards x
    turn(y, z, angles.rollDeg);  // -z goes towards y
    turn(x, y, angles.spinDeg);
    return {Vec3(x), Vec3(y), Vec3(z)};
}

AimAngles uprightAim(const Vec3d& aim) {
    AimAngles angles;
    const double level = std::hypot(aim.x, aim.y);
    if (level > 0) angles.orientDeg = std::atan2(aim.y, aim.x) / kDegree;
    angles.tiltDeg = std::atan2(level, -aim.z) / kDegree;
    return angles;
}

}  // namespace luxdeck

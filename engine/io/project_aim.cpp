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

}  // namespace luxdeck

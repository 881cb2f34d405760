#include "engine/sampling/warp.h"

namespace luxdeck {

Vec3 sineSphere(Vec2 u) {
    // The cumulative of sin^2 over 0..pi is (e - sin e cos e) / pi = u; Newton from the middle with the
    // bracket as a guard, since the slope vanishes at both poles.
    const double target = double{u.x} * kPiD;
    double low = 0, high = kPiD, e = kPiD / 2;
    for (int i = 0; i < 60; ++i) {
        const double error = e - std::sin(e) * std::cos(e) - target;
        (error > 0 ? high : low) = e;
        if (std::abs(error) < 1e-12) break;
        const double slope = 2 * std::sin(e) * std::sin(e);
        const double next = e - error / slope;
        e = slope > 0 && next > low && next < high ? next : (low + high) / 2;
    }
    const double angle = 2 * kPiD * u.y;
    return {static_cast<float>(std::sin(e) * std::cos(angle)), static_cast<float>(std::sin(e) * std::sin(angle)),
            static_cast<float>(std::cos(e))};
}

}  // namespace luxdeck

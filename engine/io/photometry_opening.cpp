#include "engine/io/photometry_opening.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck::photometry {

LuminousOpening disc(double diameterM) { return {OpeningShape::Disc, diameterM, diameterM, 0}; }

LuminousOpening sphere(double diameterM) { return {OpeningShape::Sphere, diameterM, diameterM, diameterM}; }

LuminousOpening uprightCylinder(double diameterM, double heightM) {
    return {OpeningShape::Cylinder, diameterM, diameterM, heightM};
}

LuminousOpening boxOrRectangle(double lengthM, double widthM, double heightM) {
    return {heightM > 0 ? OpeningShape::Box : OpeningShape::Rectangle, std::max(lengthM, kThinnestM),
            std::max(widthM, kThinnestM), heightM};
}

void warnIfHuge(Photometry& p) {
    constexpr double kHugeM = 20;
    const double largest = std::max({p.opening.lengthM, p.opening.widthM, p.opening.heightM});
    if (largest > kHugeM) {
        p.warnings.push_back(
            fmt::format("the luminous opening is {:.4g} m long: are its sizes in another unit than "
                        "the file says?",
                        largest));
    }
}

}  // namespace luxdeck::photometry

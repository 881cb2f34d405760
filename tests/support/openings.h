#pragma once

#include "engine/raycast/raycaster.h"
#include "engine/scene/opening.h"

#include <string>

namespace luxdeck::test {

inline constexpr OpeningShape kExtendedShapes[] = {OpeningShape::Rectangle, OpeningShape::Disc, OpeningShape::Box,
                                                   OpeningShape::Cylinder, OpeningShape::Sphere};

inline std::string shapeName(OpeningShape shape) {
    constexpr const char* names[] = {"Point", "Rectangle", "Disc", "Box", "Cylinder", "Sphere"};
    return names[static_cast<std::size_t>(shape)];
}

/// An opening of about 1 m, of different lengths where the shape allows it.
inline LuminousOpening openingOf(OpeningShape shape, double scale = 1) {
    const bool round = shape == OpeningShape::Disc || shape == OpeningShape::Cylinder || shape == OpeningShape::Sphere;
    const bool flat = shape == OpeningShape::Rectangle || shape == OpeningShape::Disc;
    const double length = 1.2 * scale, width = round ? length : 0.5 * scale;
    return {shape, length, width, flat ? 0 : shape == OpeningShape::Sphere ? length : 0.3 * scale};
}

/// The same, somewhere, tilted.
inline PlacedOpening tiltedOpening(OpeningShape shape) {
    Luminaire l;
    l.position = {1, -2, 4};
    l.frame = Frame::about(Vec3(0.3F, -0.5F, 0.8F).normalized());
    return PlacedOpening::of(l, openingOf(shape));
}

}  // namespace luxdeck::test

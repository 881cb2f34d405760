#pragma once

#include "engine/core/vec.h"
#include "engine/scene/candela_table.h"
#include "engine/scene/luminaire.h"

#include <optional>

namespace luxdeck {

struct Scene;

/// Flat openings hang this far below their photometric centre, so that one that is flush with a ceiling
/// is never hidden by it [m].
inline constexpr float kFlushM = 0.0005F;

/// The luminous opening of one placed luminaire: where light leaves it, with its far-field candela
/// distribution applied at every point of it. It emits and is otherwise invisible: housings that shall
/// hide light are geometry. In re-based world coordinates; plain data, cheap to copy.
struct PlacedOpening {
    OpeningShape shape = OpeningShape::Point;
    Vec3 centre;        // [m]
    Frame frame;        // local x length, y width, z height (nadir along -z)
    Vec3 halfM;         // half length, width, height [m]; radius of a disc, cylinder or sphere in x and y

    static PlacedOpening of(const Luminaire& luminaire, const LuminousOpening& opening);

    /// Area projected along a unit direction in the local frame, floored so that luminance stays finite
    /// at grazing angles [m^2].
    [[nodiscard]] float projectedAreaM2(const Vec3& localDirection) const;
    /// Area of the emitting surface [m^2]; 0 for a point.
    [[nodiscard]] float areaM2() const;

    /// A point of the emitting surface, uniform by area, with its outward normal.
    struct SurfacePoint {
        Vec3 position;
        Vec3 normal;       // of a flat opening: local -z
        bool twoSided;     // flat openings emit to both sides
    };
    [[nodiscard]] SurfacePoint samplePoint(Vec2 u) const;

    /// Distance to the nearest point where a ray meets the surface within (tMin, tMax), and the normal there.
    struct Meeting {
        float distance;
        Vec3 normal;
    };
    [[nodiscard]] std::optional<Meeting> intersect(const Vec3& origin, const Vec3& direction, float tMin,
                                                   float tMax) const;
    [[nodiscard]] Box3 bounds() const;
    [[nodiscard]] bool flat() const { return shape == OpeningShape::Rectangle || shape == OpeningShape::Disc; }
};

/// What a luminaire gives as it runs [lm]; 0: it is off, or its file says that it is dark. Only openings of those that give
/// light are there to be met by rays.
inline double runningLumens(const Luminaire& luminaire, const LuminaireType& type) { return type.photometry.table.lumens() * luminaire.outputScale(); }

}  // namespace luxdeck

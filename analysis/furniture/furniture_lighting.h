#pragma once

#include "analysis/furniture/interpolation_error.h"
#include "analysis/furniture/movable_object.h"
#include "analysis/furniture/self_shade.h"
#include "engine/core/statistics.h"
#include "engine/volume/field.h"
#include "engine/volume/group_lookup.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace luxdeck {

/// What the working surface of a piece of furniture is asked for [lx].
struct LightRequirement {
    std::optional<double> meanAtLeast;  // Ēm
    std::optional<double> limit;        // nowhere more
};

enum class FurnitureVerdict { None, Met, Under, Over, Undecided };  ///< None: nothing is required, or nothing is known
/// "met", "too little light", "too much light", "undecided", "".
const char* verdictText(FurnitureVerdict verdict);

/// Illuminance of the working surface, in intervals (95 %) that hold the volume's noise and its interpolation. They are of
/// the room without the object (a vertex that another part of the object lies on does not count): what the object's presence changes in the room's light, and so in its own, is not in them.
struct WorkingSurfaceLight {
    Interval mean, minimum, maximum;          // [lx]; over the vertices, weighed by area
    Vec3 minimumAt{0, 0, 0}, maximumAt{0, 0, 0};  // re-based [m]
    double unknownPart = 0;                   // of its area: inside walls or where no vertex of the volume sees it
    FurnitureVerdict verdict = FurnitureVerdict::None;
};

/// Lights a movable object from the irradiance volume of the room without it, as often as it moves.
///
/// A vertex takes the irradiance that the volume has for its normal, less what the object itself hides of the world from
/// it, plus what the object's own parts return of theirs once. create() finds out what hides what; update() then allocates
/// nothing once it has met its largest set of vertices, and runs on the calling thread alone.
///
/// The object, the volume and the raycaster must outlive it. One object a thread.
class FurnitureLighting {
public:
    /// room    the raycaster of the volume's scene; null: walls do not stop interpolation
    /// errors  OutOfResources
    static Result<std::unique_ptr<FurnitureLighting>> create(const MovableObject& object, const IrradianceVolume& volume, const Raycaster* room);

    /// Lights the object at a pose, at a level of detail (0: every vertex; clamped to what there is). The same pose and
    /// level give the same bits, whatever was asked before.
    void update(const Pose& pose, std::size_t level = 0);

    /// Of the last update(), #V. NaN: nothing is known there. Reflected light among the object's own parts included [lx].
    [[nodiscard]] std::span<const Rgb> lux() const { return lux_; }
    /// Half-widths of the 95 % intervals of their luminances [lx].
    [[nodiscard]] std::span<const float> halfWidths() const { return halfWidths_; }
    [[nodiscard]] const Placement& placement() const { return place_; }
    [[nodiscard]] WorkingSurfaceLight workingSurface(const LightRequirement& requirement = {});

    [[nodiscard]] const MovableObject& object() const { return *object_; }
    [[nodiscard]] const ObjectRays& objectRays() const { return rays_; }
    [[nodiscard]] const SelfShade& selfShade() const { return shade_; }
    [[nodiscard]] const IrradianceVolume& volume() const { return *volume_; }
    [[nodiscard]] std::uint64_t raysOfUpdate() const { return lookup_.rays(); }

private:
    FurnitureLighting(const MovableObject& object, const IrradianceVolume& volume, const Raycaster* room, VolumeField field, ObjectRays rays);

    void turn(const Placement& place);
    void place(const DetailLevel& level);
    void lightVertices(const DetailLevel& level);
    void reflectWithin(const DetailLevel& level);
    [[nodiscard]] std::span<const float> groupRadiance(std::uint32_t group, const GroupLookup::Corners& corners);
    [[nodiscard]] const float* vertexRadiance(std::uint32_t latticeVertex);
    [[nodiscard]] float openPart(const SelfShade::Row& row, std::span<const float> radiance) const;
    [[nodiscard]] float variance(std::uint32_t latticeVertex, const Vec3& normal) const { return alongAxes(variances_[latticeVertex], normal); }
    void addToMean(std::size_t shown, double area);
    [[nodiscard]] double varianceOfMean(double knownM2);

    const MovableObject* object_;
    const IrradianceVolume* volume_;
    VolumeField field_;
    ObjectRays rays_;
    SelfShade shade_;
    InterpolationError interpolation_;
    GroupLookup lookup_;
    Placement place_;
    std::size_t level_ = 0;

    std::vector<DirectionBins::Blend> blends_;      // #V, of the normals as they are turned
    std::vector<Vec3> positions_, normals_;         // of the vertices of the level [m, re-based]
    std::vector<Rgb> lux_, open_;                   // #V, with and without the object's own reflections
    std::vector<float> halfWidths_;                 // #V
    std::vector<double> areas_;                     // of the level's vertices

    // What the volume's vertices see by the object's own directions: kept until the object turns.
    std::vector<std::uint32_t> slots_;              // of lattice vertices, in radiance_; kNone
    std::vector<float> radiance_;                   // rows of SelfShade::kBins luminances [cd/m^2]
    std::vector<std::uint8_t> ownBin_;              // of the volume's bins, as the object is turned
    std::array<float, SelfShade::kBins> perBin_{};  // one over how many of them
    std::vector<std::uint32_t> groupSlots_;
    std::vector<float> groupRadiance_;
    std::vector<std::array<float, 6>> variances_;   // of the volume's irradiances along the axes [lx^2]
    std::vector<double> meanWeights_;                // of lattice vertices, in the mean of the working surface
    std::vector<std::uint32_t> touched_;
};

}  // namespace luxdeck

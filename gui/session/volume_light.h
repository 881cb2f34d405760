#pragma once

#include "analysis/furniture/interpolation_error.h"
#include "engine/volume/field.h"
#include "gui/session/volumes.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace luxdeck::gui {

/// A volume's light in one part and moment, ready for questions.
struct LightField {
    std::shared_ptr<const IrradianceVolume> volume;  // what field refers to
    std::shared_ptr<const LitProject> room;          // whose walls stop interpolation; null: none do
    VolumeField field;

    /// values[i] becomes the illuminance at positions[i] of a surface that faces `facing` (unit), in free space [lx]; NaN: not
    /// known. In parallel.
    void illuminance(std::span<const Vec3> positions, const Vec3& facing, std::span<float> values) const;
};

/// The spheres of all vertices in one part and moment, as they are drawn.
struct LightSpheres {
    std::shared_ptr<const IrradianceVolume> volume;
    std::vector<float> values;  // #V x #B luminances: [lx], radiance [cd/m²]
    double low = 0, high = 0;   // of usable vertices, without what outshines all else
};

/// Where a field is sampled: counts[0] fastest.
struct SampleGrid {
    Vec3 origin{0, 0, 0};                                      // re-based [m]
    std::array<Vec3, 3> steps{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};  // [m]
    std::array<int, 3> counts{1, 1, 1};

    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(counts[0]) * counts[1] * counts[2]; }
    [[nodiscard]] Vec3 at(int x, int y, int z) const { return origin + steps[0] * float(x) + steps[1] * float(y) + steps[2] * float(z); }
    friend bool operator==(const SampleGrid&, const SampleGrid&) = default;
};

/// Illuminance on surfaces that face one way, over a grid.
struct LightSamples {
    SampleGrid grid;
    Vec3 facing{0, 0, 1};
    std::vector<float> lux;  // #S; NaN: not known
};

/// What views ask of volumes and takes longer than a picture: made in the background, one thing at a time, and kept for a
/// while. A null answer means "not yet": Change::Volumes follows when there is more, and who still wants it asks again.
class VolumeLight {
public:
    explicit VolumeLight(Workplace& place) : place_(place) {}

    /// Irradiance (order 1), bins blended.
    [[nodiscard]] std::shared_ptr<const LightField> field(const VolumeState& volume, LightPart part) const;
    /// order  0: radiance, 1: irradiance, more: moments
    [[nodiscard]] std::shared_ptr<const LightSpheres> spheres(const VolumeState& volume, LightPart part, int order) const;
    /// facing  unit
    [[nodiscard]] std::shared_ptr<const LightSamples> samples(const VolumeState& volume, LightPart part, const SampleGrid& grid, const Vec3& facing) const;

    /// How far interpolation between its vertices may be off. Made at once: some ms.
    [[nodiscard]] std::shared_ptr<const InterpolationError> interpolation(const VolumeState& volume) const;

    void clear();

private:
    struct Key {
        std::shared_ptr<const IrradianceVolume> volume;
        LightPart part = LightPart::Total;
        int order = 1;
        SampleGrid grid;
        Vec3 facing{0, 0, 1};
        friend bool operator==(const Key&, const Key&) = default;
    };
    /// The last things made, by their keys; null: it failed.
    template <class T>
    struct Recent {
        // More than four views with glyphs, slices, surfaces and a probe want at once: else they would drive each other out for ever.
        static constexpr std::size_t kMost = 12;
        std::vector<std::pair<Key, std::shared_ptr<const T>>> made;  // last used first
    };
    template <class T>
    std::shared_ptr<const T> get(Recent<T>& recent, const Key& key, std::function<Result<T>()> make) const;

    Workplace& place_;
    // What is kept is not part of anyone's state: asking changes nothing but how soon the answer comes.
    mutable Recent<LightField> fields_;
    mutable Recent<LightSpheres> spheres_;
    mutable Recent<LightSamples> samples_;
    mutable std::pair<std::shared_ptr<const IrradianceVolume>, std::shared_ptr<const InterpolationError>> interpolation_;  // of the last asked
    mutable bool making_ = false;
};

}  // namespace luxdeck::gui

#pragma once

#include "engine/core/result.h"
#include "engine/volume/moments.h"
#include "engine/volume/volume.h"

#include <cstddef>
#include <span>
#include <vector>

namespace luxdeck {

/// How a sphere of moments is kept.
enum class Basis {
    Bins,       ///< a value for each direction of the volume's bins
    Harmonics   ///< real spherical harmonics up to a degree: compact, smooth, with an error of its own
};

/// What of a volume is asked for, and how.
struct FieldSettings {
    LightPart part = LightPart::Total;
    int order = 1;                          // 1: irradiance; more: moments; 0: radiance
    Quadrature quadrature = Quadrature::Exact;
    bool blendBins = false;                 // directions between bins are interpolated (thesis 6.1.3), else the nearest counts
    Basis basis = Basis::Bins;
    int degree = 4;                         // of the harmonics, 0 .. 8
};

/// The light of a volume at any point and direction, in one part and one moment: a copy of the volume's, made for quick
/// questions. Irradiance in lx; moments likewise (a uniform field gives pi L in all); radiance in cd/m^2.
///
/// The volume must outlive it. Safe to ask from any number of threads.
class VolumeField {
public:
    /// errors  InvalidArgument: an order or degree out of range; OutOfResources
    static Result<VolumeField> make(const IrradianceVolume& volume, const FieldSettings& settings);
    /// The same with weights that are there already: of the volume's bins, for the settings' order and quadrature. Null: radiance.
    static Result<VolumeField> make(const IrradianceVolume& volume, const FieldSettings& settings, const MomentWeights* weights);

    [[nodiscard]] const IrradianceVolume& volume() const { return *volume_; }
    [[nodiscard]] const FieldSettings& settings() const { return settings_; }

    /// values[i] becomes the trilinear interpolation at positions[i] [m, re-based] in directions[i] (unit); all #Q. Points
    /// outside the lattice take what its boundary has. Nothing is known of walls in between: see VisibleLookup.
    void at(std::span<const Vec3> positions, std::span<const Vec3> directions, std::span<Rgb> values) const;
    [[nodiscard]] Rgb at(const Vec3& position, const Vec3& direction) const;

    /// A direction as the field looks it up, shared by all vertices that are asked for it.
    struct Look {
        DirectionBins::Blend blend{};
        int count = 1;                  // of the blend's bins
        std::array<float, 81> harmonics{};
    };
    [[nodiscard]] Look look(const Vec3& direction) const;
    [[nodiscard]] Rgb atVertex(std::uint32_t vertex, const Look& look) const;
    /// The same between bins; of fields that are kept in bins alone.
    [[nodiscard]] Rgb atVertex(std::uint32_t vertex, const DirectionBins::Blend& blend) const {
        Rgb sum;
        for (int i = 0; i < 4; ++i) sum += values_[static_cast<std::size_t>(blend.bin[i]) * volume_->vertexCount() + vertex] * blend.weight[i];
        return sum;
    }

    /// Bytes of the copy.
    [[nodiscard]] std::size_t bytes() const { return values_.size() * sizeof(Rgb); }
    /// What the harmonics leave out, over all vertices and bins: root mean square and largest, both relative to the rms of
    /// what they stand for; 0 for bins.
    [[nodiscard]] double basisErrorRms() const { return basisErrorRms_; }
    [[nodiscard]] double basisErrorMax() const { return basisErrorMax_; }

private:
    VolumeField(const IrradianceVolume& volume, const FieldSettings& settings) : volume_(&volume), settings_(settings), bins_(volume.bins()) {}

    [[nodiscard]] std::vector<Rgb> sphere(std::size_t vertex, const MomentWeights* weights) const;
    void fillBins(const MomentWeights* weights);
    void fillHarmonics(const MomentWeights* weights);

    const IrradianceVolume* volume_;
    FieldSettings settings_;
    DirectionBins bins_;
    std::vector<Rgb> values_;     // rows of all vertices: a row for each bin, or for each harmonic. The eight corners of a
                                  // cell lie close together in a row, each in a page of its own otherwise
    double basisErrorRms_ = 0, basisErrorMax_ = 0;
};

/// Real spherical harmonics of a unit direction, (degree + 1)^2 of them, degree by degree. Source: Green 2003.
void sphericalHarmonics(const Vec3& direction, int degree, std::span<float> values);

}  // namespace luxdeck

#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/scene/content_parts.h"
#include "engine/volume/directions.h"
#include "engine/volume/lattice.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace luxdeck {

/// Light straight from luminaires, sky and emitting surfaces (panes in between allowed), light that was reflected, or both.
enum class LightPart { Total, Direct, Indirect };

/// Where the directional samples of a vertex lie in their bins.
enum class BinSampling {
    Centres,  ///< at the bin's centre, always (Greger 1996, 4.2.1): the baseline
    Spread    ///< anywhere in the bin
};

/// How the light of luminaires, sky, suns and emitting surfaces gets into a vertex.
enum class SourceSampling {
    InBins,   ///< as anything else that a ray meets: small sources are missed, points always (thesis): the baseline
    Sought    ///< chosen and connected by shadow rays, shared with the bins by multiple importance sampling (thesis 6.1.2)
};

/// What a volume was asked to be. Part of its file.
struct VolumeSettings {
    std::array<int, 3> firstLevel{7, 7, 7};  // vertices along each axis
    int secondLevel = 3;                     // vertices along each axis of a cell that holds geometry; below 2: none
    double refineBelow = 0;                  // more than 0: cells are divided into eight instead, while their vertices differ by
                                             // more than this part in the irradiance along an axis
    int refineDepth = 4;                     // at most that often
    Box3 bounds;                             // of the first level [m], re-based; empty: the scene's, drawn in by:
    double insetM = 0.02;                    // of the first level inside the scene's bounds [m], at most 2 % of its extent
    int side = 17;                           // directional bins: 2 side^2
    BinSampling sampling = BinSampling::Spread;
    SourceSampling sources = SourceSampling::Sought;
    std::uint32_t samplesPerBin = 4;
    std::uint32_t lightSamples = 64;         // at a vertex for each sample of its bins, when sources are sought
    std::vector<std::string> ignored;        // objects whose radiance is replaced where a ray meets them first (thesis 5.4)
    float ignoredCdM2 = 0;                   // by this
};

/// Light that arrives at a vertex from about one direction, sought rather than met by a bin.
struct SourceRay {
    Vec3 direction{0, 0, 0};  // mean over what it stands for: its length is a little below one
    Rgb lux;                  // on a surface that faces it
    bool direct = true;       // else by way of a mirror
};

/// How a vertex came to its values.
struct VertexQuality {
    std::uint32_t samples = 0;           // of each bin
    std::array<float, 6> lux{};          // irradiance of surfaces facing +x -x +y -y +z -z, total, luminance [lx]
    std::array<float, 6> spread{};       // sum of squared deviations of the samples' irradiances from their mean [lx^2]
    float backFaces = 0;                 // part of the rays that met a surface from behind
    float nearestM = 0;                  // to the nearest surface met
    std::uint32_t rejected = 0;          // samples of which a part is missing: not finite or negative
    bool inside = false;                 // a solid, or lying on a surface

    /// Inside a solid, on a surface, or nothing of it is known: not to be interpolated from.
    [[nodiscard]] bool usable() const { return samples > 0 && !inside; }
    /// Of the mean irradiance along one of the six directions [lx^2]; 0 while it is not known.
    [[nodiscard]] double variance(std::size_t axis) const { return samples > 1 ? double{spread[axis]} / (samples * (samples - 1.0)) : 0.0; }
    /// Standard error of an irradiance, rms over the six directions [lx]; infinite from one sample.
    [[nodiscard]] double standardError() const;
    [[nodiscard]] double meanLux() const;
};

/// Light at any point and direction of a scene: spheres of radiance at the vertices of a lattice. Everything else
/// (irradiance, moments, parts) follows from them.
///
/// Source: Greger 1996, "The Irradiance Volume".
struct IrradianceVolume {
    VolumeSettings settings;
    std::string scene;                 // name
    std::string sceneHash;
    std::vector<ContentPart> parts;      // of the scene: what changed since can be named
    std::string algorithm;
    std::uint64_t seed = 1;
    double seconds = 0;                // of building, the last session alone
    std::uint64_t rays = 0;            // likewise
    bool complete = true;              // false: interrupted; vertices may lack samples
    double interpolationError = -1;    // relative rms at vertices that a division added, against the cell before; below 0: none were
    Vec3d origin{0, 0, 0};             // user coordinates = re-based + origin [m]
    LuminanceWeights weights;

    Lattice lattice;
    std::vector<std::uint8_t> occupied;// #C, 1: the cell holds geometry
    std::vector<Rgb> direct;           // #V x #B, radiance that no surface reflected, as the bins met it [cd/m^2]
    std::vector<Rgb> indirect;         // #V x #B, radiance that was reflected [cd/m^2]
    std::vector<std::vector<SourceRay>> sources;  // #V, beside the bins; in the order of their bins
    std::vector<VertexQuality> quality;// #V

    [[nodiscard]] DirectionBins bins() const { return DirectionBins(settings.side); }
    [[nodiscard]] std::size_t vertexCount() const { return lattice.vertices().size(); }
    [[nodiscard]] std::size_t binCount() const { return static_cast<std::size_t>(bins().count()); }
    [[nodiscard]] std::span<const Rgb> directAt(std::size_t vertex) const { return {direct.data() + vertex * binCount(), binCount()}; }
    [[nodiscard]] std::span<const Rgb> indirectAt(std::size_t vertex) const { return {indirect.data() + vertex * binCount(), binCount()}; }
    [[nodiscard]] std::size_t bytes() const;
    /// Standard errors of usable vertices over their irradiances, rms; infinite while unknown [-].
    [[nodiscard]] double relativeError() const;
    /// Vertices that are not to be interpolated from.
    [[nodiscard]] std::size_t unusable() const;
};

/// Where to ask a volume for the light that a surface throws to a viewer: along the normal for irradiance, along the
/// mirrored direction for moments above (thesis, figure 4.17).
///
/// normal, toViewer  unit
inline Vec3 queryDirection(int order, const Vec3& normal, const Vec3& toViewer) {
    return order == 1 ? normal : normal * (2 * dot(normal, toViewer)) - toViewer;
}

}  // namespace luxdeck

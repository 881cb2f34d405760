#pragma once

#include "engine/sampling/alias_table.h"
#include "engine/sampling/sky_map.h"
#include "engine/transport/radiance_estimator.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luxdeck {

/// Light as it leaves its source.
struct EmittedPhoton {
    Ray ray;
    Rgb power;               // flux over the density of choosing it: the mean over many is all that is emitted [lm]
    bool fromPoint = false;  // of a luminaire without extent, which no path meets by chance
};

/// Chooses where and in which direction light is emitted: luminaires by their candela tables, emitting triangles by their
/// textures and patterns, sky and suns through the bounds of the scene. Sources are chosen by power; where there are both,
/// half of the photons are the sky's, most of whose light misses the openings.
///
/// Constant after it was made. The scene must outlive it.
class LightEmission {
public:
    explicit LightEmission(const TransportScene& scene);

    [[nodiscard]] bool dark() const { return sources_.empty(); }
    /// NaN power: a pattern has no value there.
    [[nodiscard]] EmittedPhoton emit(SamplePath& numbers) const;

private:
    enum class Kind : std::uint8_t { Luminaire, Triangle, Sky, Sun };
    struct Source {
        Kind kind;
        std::uint32_t index = 0;     // luminaire, sun, or mesh
        std::uint32_t triangle = 0;
        double powerLm = 0;
    };
    /// A cell of a candela table in its own angles [rad].
    struct Cell {
        float v0, v1, h0, h1;
        float solidAngle;
    };
    struct Directions {              // of a luminaire type
        std::vector<Cell> cells;
        AliasTable chances;
    };

    void addLuminaires();
    void addTriangles();
    void addSky();
    [[nodiscard]] static Directions directionsOf(const CandelaTable& table);
    [[nodiscard]] EmittedPhoton fromLuminaire(const Source& source, SamplePath& numbers) const;
    [[nodiscard]] EmittedPhoton fromTriangle(const Source& source, SamplePath& numbers) const;
    [[nodiscard]] EmittedPhoton fromSky(SamplePath& numbers) const;
    [[nodiscard]] EmittedPhoton fromSun(const Source& source, SamplePath& numbers) const;
    /// Into the bounds, from a direction towards the sky; powerPerM2 across the beam [lx].
    [[nodiscard]] EmittedPhoton intoBounds(const Vec3& towards, const Rgb& powerPerM2, SamplePath& numbers) const;
    [[nodiscard]] float crossSectionM2(const Vec3& direction) const;

    const Scene& scene_;
    const SceneNeeds& needs_;
    Box3 bounds_;
    std::vector<Source> sources_;
    AliasTable chances_;
    std::vector<Directions> directions_;  // by luminaire type
    AliasTable texels_;                   // of the sky
};

}  // namespace luxdeck

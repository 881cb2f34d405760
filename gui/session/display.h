#pragma once

#include "engine/core/vec.h"
#include "engine/volume/volume.h"
#include "gui/session/units.h"
#include "tonemap/colour_map.h"

#include <optional>
#include <string>

namespace luxdeck::gui {

/// The one scale of colours that all views share. Illuminance in lx (glyphs of radiance: cd/m²).
struct LegendScale {
    bool automatic = true;           ///< range from what is shown
    double low = 0, high = 1000;     ///< [lx]
    bool logarithmic = false;
    tonemap::ColourMap map = tonemap::ColourMap::Dusk;

    friend bool operator==(const LegendScale&, const LegendScale&) = default;
};

enum class Navigation { Orbit, Walk, Holodeck };

/// What holds for all views.
struct Display {
    LegendScale legend;
    Units units;
    Navigation navigation = Navigation::Orbit;
    bool linkedCameras = true;

    friend bool operator==(const Display&, const Display&) = default;
};

enum class SurfaceLook {
    Materials,  ///< colours of the materials, evenly lit
    Plain,      ///< light grey
    Wireframe,
    Hidden
};

/// A plane that cuts the room open, or that a slice lies in.
struct CutPlane {
    bool on = false;
    Vec3d normal{0, 0, 1};   ///< unit; what lies on this side is cut away
    double offsetM = 1;      ///< along the normal from the middle of the scene's bounds

    friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// What one view shows.
struct ViewSettings {
    SurfaceLook surfaces = SurfaceLook::Materials;
    bool hideCeiling = true;         ///< while looked at from above
    bool luminaires = true;
    bool candelaSolids = false;
    bool grids = true;               ///< calculation surfaces in false colour
    bool isolines = true;
    bool values = false;             ///< a number at each point
    bool intervals = false;          ///< ± beside the numbers
    bool verdicts = true;            ///< Ēm and its verdict at each surface
    LightPart part = LightPart::Total;
    CutPlane section;

    std::string volume;              ///< whose light is shown, by name; empty: the session's (Volumes::shown())
    bool glyphs = false;             ///< spheres at the volume's vertices
    int order = 1;                   ///< 0: radiance, 1: irradiance, more: moments
    double glyphRadiusM = 0.08;
    bool firstLevelGrid = false;
    bool secondLevelGrid = false;
    CutPlane slice;                  ///< illuminance on surfaces that face sliceFacing
    Vec3d sliceFacing{0, 0, 1};      ///< unit; which way the measuring surface looks
    bool isosurface = false;         ///< of the same illuminance
    double isosurfaceLux = 300;

    friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

}  // namespace luxdeck::gui

#pragma once

#include "engine/core/statistics.h"
#include "gui/session/session.h"

#include <optional>
#include <string>

namespace luxdeck::gui {

/// What is known of the light at a point of a surface. Intervals are 95 %.
struct ProbeReading {
    bool fromVolume = false;                ///< else what follows is not known, and why says so
    Interval total, direct, indirect;       ///< illuminance [lx]; of the volume, with its noise and its interpolation
    bool old = false;                       ///< the volume is of an earlier state of the project
    std::optional<Interval> luminance;      ///< of the surface if it were matte [cd/m²]: an estimate
    std::string why;                        ///< nothing is known from a volume: the reason, in a few words

    struct GridPoint {
        std::string grid;                   ///< name of the calculation surface
        Interval lux;                       ///< as solved at its point nearest by [lx]
        double distanceM = 0;
        bool old = false;
    };
    std::optional<GridPoint> nearest;       ///< of calculation surfaces within their spacing of the point, facing alike

    /// One line: "Illuminance 512 ± 20 lx (direct 400, indirect 112) · ...".
    [[nodiscard]] std::string text(const Units& units) const;
};

/// Light at a point, on a surface there that faces `normal`: from the volume that the view shows, and from the solved point nearest by.
/// Quick; the volume's answer may be missing until its light has been prepared (Change::Volumes follows).
///
/// point        re-based [m]
/// normal       unit, to the side that is lit
/// reflectance  diffuse, of the surface [-]; none: unknown
ProbeReading probe(const Session& session, const ViewSettings& view, const Vec3d& point, const Vec3d& normal, std::optional<double> reflectance = {});

}  // namespace luxdeck::gui

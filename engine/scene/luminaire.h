#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/scene/candela_table.h"

#include <cstdint>
#include <string>

namespace luxdeck {

/// A product: one photometric file and what the schedule prints about it.
struct LuminaireType {
    std::string id;            ///< short mark in the plan: "A", "B1"
    std::string description;
    std::string file;          ///< as the project names it
    Photometry photometry;
    Rgb colour{1.0F};          ///< chromaticity, luminance 1
    double watts = 0;          ///< input power of one [W]
};

/// One placed luminaire. Its intensity towards d is
/// photometry.table.intensity(local d) * fluxScale * dimming * maintenanceFactor.
struct Luminaire {
    std::string name;
    std::uint32_t type = 0;          ///< index into Scene::luminaireTypes
    Vec3 position;                   ///< photometric centre [m], re-based
    Frame frame;                     ///< columns: local +x (C0), +y (C90), +z (away from the nadir)
    double fluxScale = 1;            ///< re-lamping: wanted lumens / photometry's lumens
    double dimming = 1;              ///< 0 .. 1
    double maintenanceFactor = 1;    ///< 0 .. 1

    [[nodiscard]] double outputScale() const { return fluxScale * dimming * maintenanceFactor; }
};

}  // namespace luxdeck

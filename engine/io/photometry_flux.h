#pragma once

#include "engine/io/photometry_planes.h"

#include <string>

namespace luxdeck::photometry {

/// What a file's header says about flux.
struct FluxClaim {
    enum class Of {
        Lamps,      ///< LM-63: the bare lamps; the luminaire gives less, by its light output ratio
        Luminaire,  ///< EULUMDAT: lamps times light output ratio, or an absolute measurement
        Nothing     ///< absolute LM-63
    };
    Of of = Of::Nothing;
    double lumens = 0;             ///< the flux claimed [lm]
    double lampLumens = 0;         ///< total of the lamps [lm]
    double downwardPercent = -1;   ///< EULUMDAT's DFF; negative: not stated
    std::string statedAs;          ///< "2 lamps x 2900 lm"
};

/// Compares the table's flux, downward share and efficacy with the header's. Where the flux differs by more
/// than 1 %, adds one warning "flux: ..." that names the reason the file itself supports: absolute photometry,
/// light output ratio, a part of the sphere not stored, candela in another scale, a header computed with a
/// coarser sum than the integral — or, when none of these fits, that table and header contradict each other.
///
/// photometry  with its table and lumensDeclared; warnings are added
/// stored      the same distribution before expansion, in candela
void judgeFlux(Photometry& photometry, const FluxClaim& claim, const StoredPlanes& stored);

}  // namespace luxdeck::photometry

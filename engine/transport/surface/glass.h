#pragma once

#include "engine/core/rgb.h"

namespace luxdeck {

/// What a pane does with unpolarised light at an angle: two surfaces, absorption in between, all
/// interreflections summed incoherently, s and p averaged after each slab is formed.
struct PaneLight {
    Rgb reflected;    // [-]
    Rgb transmitted;  // [-]
};

/// transmittance  of the whole pane at normal incidence [-]; more than two bare surfaces let through: clear
/// ior            of the glass
/// cosine         between direction and normal, 0..1
PaneLight paneLight(const Rgb& transmittance, float ior, float cosine);

}  // namespace luxdeck

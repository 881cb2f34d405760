#pragma once

#include "engine/core/vec.h"

namespace luxdeck {

/// Where light is asked for. `normal` is zero for a sensor that looks all around.
struct Receiver {
    Vec3 position{0, 0, 0};
    Vec3 normal{0, 0, 0};
    bool glossy = false;       // scatters into narrow lobes, which find lights better than choosing them
};

}  // namespace luxdeck

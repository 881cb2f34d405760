#include "engine/core/rng.h"

#include <cmath>
#include <numbers>

namespace luxdeck {

double RandomStream::normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));  // Box-Muller
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace luxdeck

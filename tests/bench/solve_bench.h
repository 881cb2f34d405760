#pragma once

namespace luxdeck::bench {

/// Enters solve/<scene>/<algorithm>/<budget> for every registered algorithm.
void registerSolves();

}  // namespace luxdeck::bench

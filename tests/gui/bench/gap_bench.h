#pragma once

namespace luxdeck::gui {

/// Adds the benchmarks of how long the window's event loop is kept waiting while work runs, all on one core: longest gap
/// [ms], the 99.9 % one, and how many are over 50 ms; the same window idle for comparison.
void addGapBenches();

}  // namespace luxdeck::gui

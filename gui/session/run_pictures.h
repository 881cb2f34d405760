#pragma once

#include "gui/session/comparing.h"

namespace luxdeck::gui {

/// A run beside the reference, and where it errs.
///
/// range   ends of the differences' scale: -range .. range, relative
/// errors  of show() and tonemap::falseColour()
Result<std::vector<RunPicture>> runPictures(const ComparedValues& run, const ComparedValues& reference, double range);

/// A round end for that scale, 1 % at least and 100 % at most: the 98th percentile.
double differenceRange(const ComparedValues& run);

}  // namespace luxdeck::gui

#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// How the numbers were made, so that somebody else can make them again: algorithm, seed, versions, hashes,
/// what was left out, what was rejected, warnings.
void drawMethod(Document& document);

}  // namespace luxdeck::report

#pragma once

#include "engine/scene/candela_table.h"

namespace luxdeck::photometry {

/// The luminous opening of an LM-63 file.
///
/// year     edition: 1986, 1991, 1995, 2002 or 2019; each spells round shapes in its own way, as negative numbers
/// width, length, height   as in the file, signs and all, in its unit
/// metresPerUnit  0.3048 or 1
/// photometry     receives the opening; notes where the shape is only approximated go to its repairs, sizes that
///                cannot be true to its warnings
struct IesOpening {
    int year = 1986;
    double width = 0;
    double length = 0;
    double height = 0;
    double metresPerUnit = 1;
};

void readOpening(const IesOpening& opening, Photometry& photometry);

}  // namespace luxdeck::photometry

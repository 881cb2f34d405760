#pragma once

#include "engine/scene/candela_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace luxdeck::photometry {

/// A distribution as a file stores it, in absolute candela, before its mirror images are added.
struct StoredPlanes {
    PhotometryType type = PhotometryType::C;
    PhotometrySymmetry symmetry = PhotometrySymmetry::None;
    std::vector<double> vertical;    ///< #V, strictly increasing [degree]
    std::vector<double> horizontal;  ///< #H, any order; type C: any turn, -90 is 270 [degree]
    std::vector<double> candela;     ///< #H x #V, vertical fastest [cd]
};

/// The distribution with its mirror images, as CandelaTable wants it. Type C: planes from exactly 0 to exactly
/// 360; a plane at 0 that the file lacks is interpolated, which changes no value of the bilinear table. Where
/// an image falls on a stored plane, the stored one stays. Types A and B: halves are mirrored about 0.
///
/// mirrorsVertical  types A and B only: the vertical angles are half a set too
StoredPlanes expanded(const StoredPlanes& stored, bool mirrorsVertical = false);

/// Vertical angles that stand twice, which is how a step is written: rows that agree become one, others part by a
/// thousandth of a degree, with a warning. Of more than two the first and the last count.
void separateEqualAngles(StoredPlanes& stored, std::vector<std::string>& repairs, std::vector<std::string>& warnings);

/// Negative candela set to zero, with a warning that counts them.
void clampNegative(std::vector<double>& candela, std::vector<std::string>& warnings);

/// A warning if the planes at 0 and 360, the same half-plane of space, differ by more than rounding.
void warnIfSeamDiffers(const StoredPlanes& full, std::vector<std::string>& warnings);

}  // namespace luxdeck::photometry

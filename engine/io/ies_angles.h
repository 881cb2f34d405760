#pragma once

#include "engine/io/photometry_planes.h"
#include "engine/scene/candela_table.h"

#include <string>

namespace luxdeck::photometry {

/// Puts the angles of an LM-63 file in order and finds the symmetry they imply:
/// duplicates dropped, falling sets turned round, half a type A or B set recognised.
///
/// stored           angles as in the file and candela; left strictly increasing, symmetry set
/// mirrorsVertical  set if a type A or B file stores only the vertical angles 0..90
/// photometry       receives repairs and warnings
/// errors           Parse (without a place): angles that fit no symmetry, out of range, or in no order
Result<void> settleAngles(StoredPlanes& stored, bool& mirrorsVertical, Photometry& photometry);

}  // namespace luxdeck::photometry

#pragma once

#include "analysis/furniture/movable_object.h"

namespace luxdeck {

/// levels[0]: every vertex for itself. Each further level gathers vertices of the same main axis of normal in cubes twice
/// as large as before; the vertex nearest to their mean stands for them.
void makeDetailLevels(MovableObject& object, int count);

}  // namespace luxdeck

#pragma once

#include <cstddef>
#include <string>

namespace luxdeck::gui {

enum class Thing { None, Project, Object, LuminaireType, Luminaire, Grid, View, Volume, Material };

/// What the user has picked, by its place in the project's scene (objects, luminaires, types, materials) or lists (grids,
/// views) or the session's volumes.
struct Selection {
    Thing thing = Thing::None;
    std::size_t index = 0;

    friend bool operator==(const Selection&, const Selection&) = default;
};

}  // namespace luxdeck::gui

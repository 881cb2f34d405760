#pragma once

#include "analysis/grids/solve_result.h"
#include "engine/core/vec.h"

#include <QColor>
#include <QString>

namespace luxdeck::gui {

/// Text at a place of the scene. Views draw it flat and upright, as many as there is room for, and not where something
/// hides the place.
struct Annotation {
    enum class Kind {
        Value,     ///< a number on a coloured surface
        Isoline,   ///< the level of a line
        Mark,      ///< short name of a luminaire
        Surface    ///< name and statistics of a calculation surface, with its verdict
    };
    Kind kind = Kind::Value;
    Vec3d at{0, 0, 0};            ///< re-based [m]
    QString text;
    QString detail;               ///< Surface: the second line
    QString brief;                ///< Surface: what is written where both lines have no room
    QColor ground;                ///< what it stands on; ink is chosen to be read on it. Invalid: the view's paper
    Verdict verdict = Verdict::None;
    bool strong = false;          ///< of what is selected: drawn first
    bool old = false;             ///< of a result that is no longer current
};

}  // namespace luxdeck::gui

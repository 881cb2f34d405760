#pragma once

#include "gui/session/session.h"

#include <vtkBoundingBox.h>

class vtkRenderer;

namespace luxdeck::gui {

/// One kind of thing that a view shows: the room, the luminaires, glyphs ... Owns its actors in one renderer and rebuilds
/// them when what it shows has changed. Coordinates are the scene's re-based ones (what the engine computes in).
class Layer {
public:
    virtual ~Layer() = default;

    /// Brings the actors up to date with the session and what this view is to show. Cheap when nothing that concerns the
    /// layer has changed (it remembers what it built from). Returns whether the picture changes.
    virtual bool update(const Session& session, const ViewSettings& view) = 0;

    /// Illuminances (lx) that it colours by, for the legend's automatic range; empty when it shows none.
    struct Range {
        double low = 0, high = 0;
        [[nodiscard]] bool empty() const { return !(high > low); }
    };
    [[nodiscard]] virtual Range lightRange() const { return {}; }
};

}  // namespace luxdeck::gui

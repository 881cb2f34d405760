#pragma once

#include "gui/session/session.h"
#include "gui/view3d/annotation.h"
#include "gui/view3d/light_colours.h"

#include <vector>

class vtkRenderer;

namespace luxdeck::gui {

/// One kind of thing that a view shows: the room, the luminaires, glyphs ... Owns its actors in one renderer (which its
/// constructor takes) and rebuilds them when what it shows has changed. Coordinates are the scene's re-based ones (what the
/// engine computes in).
///
/// After each change: lightRange() of all layers of all views, from which follows the one scale (resolved()); then update().
class Layer {
public:
    virtual ~Layer() = default;

    /// Light that it colours by, for the legend's automatic range [lx; spheres of radiance: cd/m²].
    struct Range {
        double low = 0, high = 0;
        [[nodiscard]] bool empty() const { return !(high > low); }
    };
    /// Of what update() would show; empty when nothing in colours. Cheap when nothing has changed, as update() is.
    virtual Range lightRange(const Session&, const ViewSettings&) { return {}; }

    /// Brings the actors up to date with the session and what this view is to show. Cheap when nothing that concerns the
    /// layer has changed (it remembers what it built from). Returns whether the picture changes.
    virtual bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) = 0;

    /// While the camera moves only what shows the way is drawn, so that frames come quickly; all of it when it stands still.
    virtual void setMoving(bool /*moving*/) {}

    /// Text at places of what update() has made.
    virtual void annotate(std::vector<Annotation>&) const {}
};

}  // namespace luxdeck::gui

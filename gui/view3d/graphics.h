#pragma once

namespace luxdeck::gui {

/// Asks for the kind of OpenGL that the views draw with. To be called before the QApplication is made.
void prepareGraphics();

}  // namespace luxdeck::gui

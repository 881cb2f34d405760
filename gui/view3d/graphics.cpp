#include "gui/view3d/graphics.h"

#include <QSurfaceFormat>

#include <QVTKOpenGLNativeWidget.h>

namespace luxdeck::gui {

void prepareGraphics() { QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat()); }

}  // namespace luxdeck::gui

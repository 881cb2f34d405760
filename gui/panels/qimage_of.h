#pragma once

#include "engine/core/image.h"

#include <QImage>

namespace luxdeck::gui {

/// A copy that owns its pixels.
inline QImage qimageOf(const DisplayImage& image) {
    if (image.rgb.empty()) return {};
    return QImage(image.rgb.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).convertToFormat(QImage::Format_RGB32);
}

}  // namespace luxdeck::gui

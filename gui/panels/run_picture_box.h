#pragma once

#include "gui/session/comparing.h"

#include <QImage>
#include <QWidget>

namespace luxdeck::gui {

/// A picture of a run with its title, as wide as there is room, and the scale of its colours.
class RunPictureBox : public QWidget {
    Q_OBJECT

public:
    explicit RunPictureBox(const RunPicture& picture, QWidget* parent = nullptr);
};

}  // namespace luxdeck::gui

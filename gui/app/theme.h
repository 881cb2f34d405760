#pragma once

#include <QPalette>

class QApplication;

namespace luxdeck::gui {

enum class Theme { Light, Dark };

/// Colours, font and style of all widgets. May be changed while the program runs.
void applyTheme(QApplication& application, Theme theme);
/// The theme whose colours these are.
Theme themeOf(const QPalette& palette);

}  // namespace luxdeck::gui

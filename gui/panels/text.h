#pragma once

#include <QString>

#include <string>

namespace luxdeck::gui {

inline QString qt(const std::string& text) { return QString::fromStdString(text); }

}  // namespace luxdeck::gui

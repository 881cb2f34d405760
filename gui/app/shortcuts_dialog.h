#pragma once

#include <QDialog>

#include <vector>

namespace luxdeck::gui {

/// Every command with its keys, and what keys and mouse do in the views; may be searched.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    ShortcutsDialog(const std::vector<QAction*>& commands, QWidget* parent);
};

}  // namespace luxdeck::gui

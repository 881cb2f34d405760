#pragma once

#include "gui/app/memory.h"

#include <QWidget>

class QListWidget;

namespace luxdeck::gui {

/// What is seen before a project is open: open or begin one, the recent ones, the samples as pictures.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(Memory& memory, QWidget* parent = nullptr);

    /// Looks again at what is recent.
    void refresh();

signals:
    void chosen(const QString& file);
    void openWanted();
    void newWanted();

private:
    Memory& memory_;
    QListWidget* recent_;
};

}  // namespace luxdeck::gui

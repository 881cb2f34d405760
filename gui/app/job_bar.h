#pragma once

#include "gui/session/session.h"

#include <QWidget>

class QHBoxLayout;

namespace luxdeck::gui {

/// What runs in the background, in the status bar: name, progress, error, time left, and a button that stops it.
class JobBar : public QWidget {
    Q_OBJECT

public:
    explicit JobBar(Session& session, QWidget* parent = nullptr);

private:
    struct Row;
    void refresh();

    Session& session_;
    QHBoxLayout* layout_;
    std::vector<Row*> rows_;
};

}  // namespace luxdeck::gui

#pragma once

#include "gui/session/session.h"

#include <QListWidget>

namespace luxdeck::gui {

/// What happened, newest last: notes, warnings, errors.
class LogPanel : public QListWidget {
    Q_OBJECT

public:
    explicit LogPanel(Session& session, QWidget* parent = nullptr);

private:
    void catchUp();

    Session& session_;
};

}  // namespace luxdeck::gui

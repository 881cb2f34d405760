#pragma once

#include "gui/session/session.h"

#include <QTreeWidget>

namespace luxdeck::gui {

/// What the project consists of, by kind: geometry and furniture, luminaires by type, calculation surfaces with their
/// verdicts, views, volumes. Kinds that the project lacks are left out. Picking here selects everywhere.
class ProjectTree : public QTreeWidget {
    Q_OBJECT

public:
    explicit ProjectTree(Session& session, QWidget* parent = nullptr);

signals:
    /// Double click or Enter.
    void opened(Selection selection);

private:
    void rebuild();
    void showVerdicts();
    void showSelection();
    void pick();

    Session& session_;
    bool following_ = false;  // the tree is being told, and must not tell back
};

}  // namespace luxdeck::gui

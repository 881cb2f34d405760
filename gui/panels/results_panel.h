#pragma once

#include "gui/session/session.h"

#include <QWidget>

class QAbstractTableModel;
class QLabel;
class QTableView;

namespace luxdeck::gui {

class GridTable;
class PointTable;

/// Illuminance in numbers: a row for each calculation surface with Ēm, Emin, Uo, their intervals and verdicts; beside it the
/// points of the selected surface.
class ResultsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ResultsPanel(Session& session, QWidget* parent = nullptr);

    /// All points as text, one row each, for a spreadsheet.
    [[nodiscard]] QString csv() const;

private:
    void refresh();
    void showGrid(std::size_t grid);

    Session& session_;
    GridTable* grids_;
    PointTable* points_;
    QTableView *gridView_, *pointView_;
    QLabel *state_, *empty_;
    QWidget* tables_;
};

}  // namespace luxdeck::gui

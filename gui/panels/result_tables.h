#pragma once

#include "analysis/grids/solve_result.h"
#include "gui/session/units.h"

#include <QAbstractTableModel>

#include <memory>

namespace luxdeck::gui {

/// A row for each calculation surface.
class GridTable : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(std::shared_ptr<const SolveResult> result, const Units& units);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::shared_ptr<const SolveResult> result_;
    Units units_;
};

/// A row for each point of one surface.
class PointTable : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(std::shared_ptr<const SolveResult> result, std::size_t grid, const Units& units);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] const GridResult* grid() const;

    std::shared_ptr<const SolveResult> result_;
    std::size_t grid_ = 0;
    Units units_;
};

}  // namespace luxdeck::gui

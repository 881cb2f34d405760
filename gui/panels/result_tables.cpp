#include "gui/panels/result_tables.h"

#include "gui/panels/text.h"
#include "gui/panels/verdict_icon.h"

#include <utility>

namespace luxdeck::gui {

namespace {

enum GridColumn { kName, kMean, kMinimum, kUniformity, kMaximum, kPoints, kGridColumns };
enum PointColumn { kX, kY, kZ, kTotal, kDirect, kIndirect, kSamples, kPointColumns };

/// "512 ± 6" in the units shown.
QString intervalOf(const Interval& interval, const Units& units) {
    return qt(intervalText(units.illuminance(interval.value), units.illuminance(interval.ci95)));
}

const JudgedInterval* judged(const GridResult& grid, int column) {
    switch (column) {
        case kMean: return &grid.mean;
        case kMinimum: return &grid.minimum;
        case kUniformity: return &grid.uniformity;
        default: return nullptr;
    }
}

QString wording(const JudgedInterval& value, bool ratio, const Units& units) {
    if (!value.required) return QObject::tr("Nothing is required");
    const auto limit = ratio ? QString::number(*value.required) : qt(units.illuminanceText(*value.required));
    return QObject::tr("%1 required: %2").arg(limit, QString::fromUtf8(verdictText(value.verdict)));
}

}  // namespace

void GridTable::show(std::shared_ptr<const SolveResult> result, const Units& units) {
    if (result == result_ && units == units_) return;
    const bool sameRows = result_ && result && result_->grids.size() == result->grids.size();
    if (!sameRows) beginResetModel();
    result_ = std::move(result);
    units_ = units;
    if (!sameRows) endResetModel();
    else if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, kGridColumns - 1));
    emit headerDataChanged(Qt::Horizontal, 0, kGridColumns - 1);
}

int GridTable::rowCount(const QModelIndex& parent) const { return parent.isValid() || !result_ ? 0 : static_cast<int>(result_->grids.size()); }
int GridTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kGridColumns; }

QVariant GridTable::data(const QModelIndex& index, int role) const {
    const auto& grid = result_->grids[static_cast<std::size_t>(index.row())];
    const auto* value = judged(grid, index.column());
    if (role == Qt::DecorationRole && value != nullptr) return verdictIcon(value->verdict);
    if (role == Qt::ToolTipRole && value != nullptr) return wording(*value, index.column() == kUniformity, units_);
    if (role == Qt::TextAlignmentRole && index.column() != kName) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case kName: return qt(grid.name);
        case kMean: return intervalOf(grid.mean.interval, units_);
        case kMinimum: return intervalOf(grid.minimum.interval, units_);
        case kUniformity: return qt(intervalText(grid.uniformity.interval.value, grid.uniformity.interval.ci95));
        case kMaximum: return qt(numberText(units_.illuminance(grid.maximumLux)));
        case kPoints: return static_cast<int>(grid.points.size());
        default: return {};
    }
}

QVariant GridTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const auto unit = QString::fromUtf8(units_.illuminanceUnit());
    if (role == Qt::ToolTipRole) {
        switch (section) {
            case kMean: return tr("Mean illuminance with its 95 % interval");
            case kMinimum: return tr("Smallest illuminance with its 95 % interval");
            case kUniformity: return tr("Uniformity: Emin over Ēm");
            default: return {};
        }
    }
    if (role == Qt::TextAlignmentRole) return section == kName ? QVariant(Qt::AlignLeft | Qt::AlignVCenter) : QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    switch (section) {
        case kName: return tr("Calculation surface");
        case kMean: return tr("Ēm [%1]").arg(unit);
        case kMinimum: return tr("Emin [%1]").arg(unit);
        case kUniformity: return tr("Uo");
        case kMaximum: return tr("Emax [%1]").arg(unit);
        case kPoints: return tr("Points");
        default: return {};
    }
}

const GridResult* PointTable::grid() const { return result_ && grid_ < result_->grids.size() ? &result_->grids[grid_] : nullptr; }

void PointTable::show(std::shared_ptr<const SolveResult> result, std::size_t grid, const Units& units) {
    if (result == result_ && grid == grid_ && units == units_) return;
    const int before = rowCount();
    const bool sameGrid = grid == grid_;
    auto was = std::exchange(result_, std::move(result));
    grid_ = grid;
    units_ = units;
    const bool sameRows = sameGrid && before == rowCount();
    if (!sameRows) {
        beginResetModel();
        endResetModel();
    } else if (before > 0) {
        emit dataChanged(index(0, 0), index(before - 1, kPointColumns - 1));
    }
    emit headerDataChanged(Qt::Horizontal, 0, kPointColumns - 1);
}

int PointTable::rowCount(const QModelIndex& parent) const { return parent.isValid() || grid() == nullptr ? 0 : static_cast<int>(grid()->points.size()); }
int PointTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kPointColumns; }

QVariant PointTable::data(const QModelIndex& index, int role) const {
    const auto& point = grid()->points[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && point.insideSolid) return tr("Most of what this point sees are backs of surfaces: it may lie inside a solid");
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case kX: return QString::number(units_.lengthOf(point.position.x), 'f', 3);
        case kY: return QString::number(units_.lengthOf(point.position.y), 'f', 3);
        case kZ: return QString::number(units_.lengthOf(point.position.z), 'f', 3);
        case kTotal: return intervalOf(point.total, units_);
        case kDirect: return intervalOf(point.direct, units_);
        case kIndirect: return intervalOf(point.indirect, units_);
        case kSamples: return static_cast<qulonglong>(point.samples);
        default: return {};
    }
}

QVariant PointTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical) return section + 1;
    const auto light = QString::fromUtf8(units_.illuminanceUnit()), length = QString::fromUtf8(units_.lengthUnit());
    switch (section) {
        case kX: return tr("x [%1]").arg(length);
        case kY: return tr("y [%1]").arg(length);
        case kZ: return tr("z [%1]").arg(length);
        case kTotal: return tr("E [%1]").arg(light);
        case kDirect: return tr("direct");
        case kIndirect: return tr("indirect");
        case kSamples: return tr("paths");
        default: return {};
    }
}

}  // namespace luxdeck::gui

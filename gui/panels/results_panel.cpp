#include "gui/panels/results_panel.h"

#include "gui/panels/result_tables.h"
#include "gui/panels/text.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

#include <fmt/format.h>

#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr int kMeasuredRows = 30; // decide on how wide a column is: thousands of points take too long
constexpr int kTableWidth = 600;  // of each table, at first and in proportion

QTableView* table(QAbstractTableModel* model, const QString& name, QWidget* parent) {
    auto* view = new QTableView(parent);
    view->setObjectName(name);
    view->setModel(model);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    view->setSelectionMode(QAbstractItemView::SingleSelection);
    view->setAlternatingRowColors(true);
    view->setShowGrid(false);
    view->verticalHeader()->setVisible(false);
    view->verticalHeader()->setDefaultSectionSize(24);
    view->horizontalHeader()->setHighlightSections(false);
    view->horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
    view->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    view->horizontalHeader()->setStretchLastSection(false);
    return view;
}

/// What the numbers are worth, in a line.
QString stateText(const SolveResult& result, bool current, bool running) {
    double worst = result.trace.empty() ? 0 : result.trace.back().relativeError;
    auto text = QObject::tr("%1 · %2 s · largest 95 % half-width of a statistic %3 %")
                    .arg(qt(result.algorithm), qt(numberText(result.seconds)), qt(numberText(100 * worst)));
    if (running) text += QObject::tr(" · still being solved");
    else if (result.withheldPoints > 0)
        text += QObject::tr(" · numbers of %1 points are withheld").arg(result.withheldPoints);
    else if (!result.complete) text += QObject::tr(" · stopped before the end");
    if (!current) text += QObject::tr(" · OLD: the project has changed since");
    return text;
}

}  // namespace

ResultsPanel::ResultsPanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), grids_(new GridTable(this)), points_(new PointTable(this)), state_(new QLabel(this)), empty_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setText(tr("No results yet. Press Solve (F5) to compute the illuminance on all calculation surfaces."));
    auto* split = new QSplitter(this);
    tables_ = split;
    gridView_ = table(grids_, QStringLiteral("gridTable"), split);
    pointView_ = table(points_, QStringLiteral("pointTable"), split);
    split->addWidget(gridView_);
    split->addWidget(pointView_);
    split->setStretchFactor(0, 1);
    split->setStretchFactor(1, 1);
    split->setSizes({kTableWidth, kTableWidth});
    state_->setObjectName(QStringLiteral("resultState"));
    state_->setContentsMargins(8, 4, 8, 4);
    layout->addWidget(empty_, 1);
    layout->addWidget(split, 1);
    layout->addWidget(state_);

    connect(gridView_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
        if (row.isValid()) session_.select({Thing::Grid, static_cast<std::size_t>(row.row())});
    });
    session_.observe([this](Change change) {
        if (change == Change::Solve || change == Change::Project || change == Change::Display || change == Change::Jobs) refresh();
        if (change == Change::Selection && session_.selection().thing == Thing::Grid) showGrid(session_.selection().index);
    });
    refresh();
}

void ResultsPanel::refresh() {
    const auto result = session_.solving.result();
    tables_->setVisible(result != nullptr);
    state_->setVisible(result != nullptr);
    empty_->setVisible(result == nullptr);
    const auto& units = session_.display().units;
    grids_->show(result, units);
    if (result) state_->setText(stateText(*result, session_.solving.current(), session_.place.jobs.running(JobKind::Solve)));
    showGrid(session_.selection().thing == Thing::Grid ? session_.selection().index : static_cast<std::size_t>(std::max(0, gridView_->currentIndex().row())));
}

void ResultsPanel::showGrid(std::size_t grid) {
    points_->show(session_.solving.result(), grid, session_.display().units);
    if (static_cast<int>(grid) < grids_->rowCount() && gridView_->currentIndex().row() != static_cast<int>(grid)) gridView_->selectRow(static_cast<int>(grid));
}

QString ResultsPanel::csv() const {
    const auto result = session_.solving.result();
    if (!result) return {};
    const auto known = [](const Interval& lux) { return std::isfinite(lux.ci95) ? lux.value : std::nan(""); };
    std::string text = "surface,x_m,y_m,z_m,lux,ci95,direct,indirect\n";
    for (const auto& grid : result->grids)
        for (const auto& p : grid.points) {
            std::string name = grid.name;
            for (std::size_t at = 0; (at = name.find('"', at)) != std::string::npos; at += 2) name.insert(at, 1, '"');
            text += fmt::format("\"{}\",{:.4f},{:.4f},{:.4f},{:.6g},{:.4g},{:.6g},{:.6g}\n", name, p.position.x,
                                p.position.y, p.position.z, known(p.total), p.total.ci95, known(p.direct), known(p.indirect));
        }
    return qt(text);
}

}  // namespace luxdeck::gui

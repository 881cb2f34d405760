#include "gui/panels/compare_panel.h"

#include "analysis/report/compare_drawing.h"
#include "gui/panels/colour_bar.h"
#include "gui/panels/compare_controls.h"
#include "gui/panels/error_plot.h"
#include "gui/panels/qimage_of.h"
#include "gui/panels/run_picture_box.h"
#include "gui/panels/text.h"

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace luxdeck::gui {

namespace {

constexpr int kControlsWidth = 300, kRunWidth = 270;

QTableWidget* table(const char* name, const QStringList& columns) {
    auto* out = new QTableWidget(0, columns.size());
    out->setObjectName(QString::fromLatin1(name));
    out->setHorizontalHeaderLabels(columns);
    out->verticalHeader()->hide();
    out->setEditTriggers(QAbstractItemView::NoEditTriggers);
    out->setSelectionBehavior(QAbstractItemView::SelectRows);
    out->setShowGrid(false);
    out->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    out->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    return out;
}

void setRow(QTableWidget* table, int row, const QStringList& cells) {
    for (int i = 0; i < cells.size(); ++i) table->setItem(row, i, new QTableWidgetItem(cells[i]));
}

const ComparedRun* largestRun(const Comparison& c, const std::string& subject, const std::string& algorithm) {
    const ComparedRun* last = nullptr;
    for (const auto& run : c.runs)
        if (run.subject == subject && run.algorithm == algorithm) last = &run;
    return last;
}

QString timeText(const Comparison& c, const std::string& subject, const std::string& algorithm, double error) {
    for (const auto& time : c.timeTo) {
        if (time.subject != subject || time.algorithm != algorithm || time.error != error) continue;
        if (time.time.how == Reached::NotReached) return QObject::tr("not reached");
        return QObject::tr("%1%2 s").arg(time.time.how == Reached::AtOnce ? QStringLiteral("≤ ") : QString(), qt(numberText(time.time.seconds)));
    }
    return QStringLiteral("–");
}

QString percent(double value, double ci95) { return QObject::tr("%1 %").arg(qt(intervalText(100 * value, 100 * ci95))); }

}  // namespace

ComparePanel::ComparePanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), controls_(new CompareControls(session)), stage_(new QStackedWidget(this)), subject_(new QComboBox), about_(new QLabel), runTitle_(new QLabel),
      save_(new QPushButton(tr("Save…"))), plot_(new ErrorPlot), tables_(new QTabWidget),
      order_(table("compareOrder", {tr("Place"), tr("Algorithm"), tr("Error, rms"), tr("Bias"), tr("Run time"), tr("of it set-up"), tr("to 5 %"), tr("to 1 %")})),
      volumes_(table("compareVolumeTable", {tr("Algorithm"), tr("Light"), tr("Differs by, rms"), tr("of it noise"), tr("Largest"), tr("Built in")})), run_(new QWidget), pictures_(new QVBoxLayout) {
    subject_->setObjectName(QStringLiteral("compareSubject"));
    subject_->setAccessibleName(tr("Compared on"));
    save_->setObjectName(QStringLiteral("compareSave"));
    save_->setToolTip(tr("compare.json, tables as .csv, plots as .svg, .png and .pdf, and pictures of the errors, into a folder"));
    auto* empty = new QLabel(tr("Which algorithm is worth its time here? Choose some on the left and press Compare: curves of error against run time grow while they run."));
    empty->setObjectName(QStringLiteral("compareEmpty"));
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    empty->setMargin(40);
    empty->setForegroundRole(QPalette::PlaceholderText);
    stage_->addWidget(empty);
    stage_->addWidget(makeResults());
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(controls_);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(kControlsWidth);
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(scroll);
    layout->addWidget(stage_, 1);

    connect(subject_, QOverload<int>::of(&QComboBox::activated), this, &ComparePanel::refresh);
    connect(save_, &QPushButton::clicked, this, &ComparePanel::saveAs);
    connect(plot_, &ErrorPlot::picked, this, [this](const RunKey& run) { session_.comparing.look(run); });
    session_.observe([this](Change change) {
        if (change == Change::Comparison || change == Change::Project) refresh();
    });
    refresh();
}

QWidget* ComparePanel::makeResults() {
    about_->setForegroundRole(QPalette::PlaceholderText);
    about_->setObjectName(QStringLiteral("compareAbout"));
    runTitle_->setWordWrap(true);
    runTitle_->setObjectName(QStringLiteral("compareRun"));
    auto* bar = new QHBoxLayout;
    bar->addWidget(new QLabel(tr("On")));
    bar->addWidget(subject_);
    bar->addWidget(about_, 1);
    bar->addWidget(save_);
    pictures_->addStretch(1);
    auto* inside = new QVBoxLayout(run_);
    inside->setContentsMargins(8, 4, 8, 4);
    inside->addWidget(runTitle_);
    inside->addLayout(pictures_, 1);
    auto* runScroll = new QScrollArea;
    runScroll->setWidget(run_);
    runScroll->setWidgetResizable(true);
    runScroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    runScroll->setFixedWidth(kRunWidth);
    tables_->addTab(order_, tr("Order"));
    auto* split = new QSplitter(Qt::Vertical);
    split->addWidget(plot_);
    split->addWidget(tables_);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 1);
    auto* middle = new QVBoxLayout;
    middle->addLayout(bar);
    middle->addWidget(split, 1);
    auto* page = new QWidget;
    auto* layout = new QHBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(middle, 1);
    layout->addWidget(runScroll);
    return page;
}

std::string ComparePanel::subject() const { return subject_->currentData().toString().toStdString(); }

void ComparePanel::fillSubjects() {
    const auto& result = session_.comparing.result();
    const auto before = subject_->currentData();
    const QSignalBlocker quiet(subject_);
    subject_->clear();
    for (const auto& reference : result->reference)
        subject_->addItem(reference.picture ? tr("View %1").arg(qt(reference.subject)) : tr("Calculation surfaces"), qt(reference.subject));
    subject_->setCurrentIndex(std::max(0, subject_->findData(before)));
}

void ComparePanel::fillOrder() {
    const auto& c = *session_.comparing.result();
    order_->setRowCount(0);
    const report::PlotInks inks{{}, {}, {}, {}, palette().color(QPalette::Base).lightness() < 128};
    for (const auto& place : c.order) {
        if (place.subject != subject()) continue;
        const int row = order_->rowCount();
        order_->insertRow(row);
        const bool tie = std::count_if(c.order.begin(), c.order.end(), [&](const auto& p) { return p.subject == place.subject && p.place == place.place; }) > 1;
        const auto* run = largestRun(c, place.subject, place.algorithm);
        setRow(order_, row, {QString::number(place.place) + (tie ? tr(" (tie)") : QString()), qt(place.algorithm),
                             run->rms ? percent(*run->rms, run->rmsCi95) : tr("≤ %1 %").arg(qt(numberText(100 * run->rmsAtMost))),
                             run->bias ? percent(*run->bias, run->biasCi95) : tr("none seen"), tr("%1 s").arg(qt(numberText(run->seconds))), run->setupSeconds < 1e-3 ? tr("none") : tr("%1 s").arg(qt(numberText(run->setupSeconds))),
                             timeText(c, place.subject, place.algorithm, 0.05), timeText(c, place.subject, place.algorithm, 0.01)});
        order_->item(row, 1)->setForeground(report::colourOf(c, place.algorithm, {palette().color(QPalette::Text), {}, {}, {}, inks.onDark}));
    }
}

void ComparePanel::fillVolumes() {
    const auto& c = *session_.comparing.result();
    const int at = tables_->indexOf(volumes_);
    if (c.volumes.empty()) {
        if (at >= 0) tables_->removeTab(at);
        return;
    }
    if (at < 0) tables_->addTab(volumes_, tr("Volumes"));
    volumes_->setRowCount(static_cast<int>(c.volumes.size()));
    int row = 0;
    for (const auto& v : c.volumes)
        setRow(volumes_, row++, {qt(v.algorithm), qt(v.part), tr("%1 %").arg(qt(numberText(100 * v.rms))), tr("%1 %").arg(qt(numberText(100 * v.noise))), tr("%1 %").arg(qt(numberText(100 * v.max))),
                                 tr("%1 s").arg(qt(numberText(v.seconds)))});
}

void ComparePanel::refresh() {
    const auto& result = session_.comparing.result();
    stage_->setCurrentIndex(result ? 1 : 0);
    if (!result) return showRun();
    fillSubjects();
    plot_->show(result, subject());
    plot_->pick(session_.comparing.looked());
    fillOrder();
    fillVolumes();
    const auto reference = std::find_if(result->reference.begin(), result->reference.end(), [&](const auto& r) { return r.subject == subject(); });
    auto about = reference != result->reference.end() ? report::referenceText(*reference) : QString();
    if (!session_.comparing.current()) about += tr("; of an earlier state of the project");
    else if (!result->complete && !session_.place.jobs.running(JobKind::Compare)) about += tr("; stopped");
    about_->setText(about);
    showRun();
}

void ComparePanel::showRun() {
    const auto& pictures = session_.comparing.pictures();
    const auto& run = session_.comparing.looked();
    runTitle_->setText(run.subject.empty() ? tr("Click a point of a curve: what that run looks like, and where it errs.")
                                           : tr("<b>%1</b>, run %2").arg(qt(run.algorithm)).arg(run.rung + 1));
    runTitle_->setForegroundRole(run.subject.empty() ? QPalette::PlaceholderText : QPalette::WindowText);
    const auto* first = pictures.empty() ? nullptr : pictures.data();
    if (first == seen_ && first != nullptr) return;
    seen_ = first;
    while (pictures_->count() > 1) {
        auto* item = pictures_->takeAt(0);
        delete item->widget();
        delete item;
    }
    for (const auto& picture : pictures) pictures_->insertWidget(pictures_->count() - 1, new RunPictureBox(picture));
}

void ComparePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();  // names in the table are in the curves' colours
}

void ComparePanel::saveAs() {
    const auto folder = QFileDialog::getExistingDirectory(this, tr("Folder for the comparison"));
    if (folder.isEmpty()) return;
    if (const auto begun = session_.comparing.save(folder.toStdString()); !begun) emit failed(qt(begun.error().text()));
}

}  // namespace luxdeck::gui

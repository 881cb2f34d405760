#include "gui/panels/report_panel.h"

#include "gui/panels/job_text.h"
#include "gui/panels/page_view.h"
#include "gui/panels/qimage_of.h"
#include "gui/panels/text.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace luxdeck::gui {

namespace {

constexpr int kChoicesWidth = 280, kThumbnailsWidth = 150;

QCheckBox* section(const QString& text, const char* name, bool on, QVBoxLayout* layout) {
    auto* box = new QCheckBox(text);
    box->setObjectName(QString::fromLatin1(name));
    box->setChecked(on);
    layout->addWidget(box);
    return box;
}

QToolButton* tool(const QString& text, const char* name, const QString& tip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(tip);
    return button;
}

}  // namespace

ReportPanel::ReportPanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), viewList_(new QVBoxLayout), viewTime_(new QDoubleSpinBox), make_(new QPushButton(tr("Make the report"))), stop_(new QPushButton(tr("Stop"))),
      export_(new QPushButton(tr("Export PDF…"))), bar_(new QProgressBar), state_(new QLabel), about_(new QLabel), stage_(new QStackedWidget), thumbnails_(new QListWidget), page_(new PageView),
      sharpen_(new QTimer(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(makeChoices());
    layout->addWidget(makePreview(), 1);
    sharpen_->setSingleShot(true);
    sharpen_->setInterval(60);  // not for every step of a zoom
    connect(sharpen_, &QTimer::timeout, this, &ReportPanel::askForPage);
    connect(page_, &PageView::resolutionChanged, sharpen_, QOverload<>::of(&QTimer::start));
    connect(make_, &QPushButton::clicked, this, &ReportPanel::make);
    connect(stop_, &QPushButton::clicked, this, [this] { session_.reporting.cancel(); });
    connect(export_, &QPushButton::clicked, this, &ReportPanel::exportTo);
    connect(thumbnails_, &QListWidget::currentRowChanged, this, &ReportPanel::askForPage);
    for (auto* box : {falseColour_, grids_, schedule_, accuracy_, method_, comparison_}) connect(box, &QCheckBox::toggled, this, &ReportPanel::changed);
    session_.observe([this](Change change) {
        if (change == Change::Project) fillViews();
        if (change == Change::Report || change == Change::Project) refreshPages();
        if (change == Change::Report || change == Change::Project || change == Change::Jobs || change == Change::Comparison || change == Change::Solve) refresh();
    });
    fillViews();
    refreshPages();
    refresh();
}

QWidget* ReportPanel::makeChoices() {
    auto* inside = new QWidget;
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(4, 0, 12, 8);
    auto* group = new QGroupBox(tr("What goes in"));
    auto* sections = new QVBoxLayout(group);
    sections->setContentsMargins(0, 6, 0, 0);
    auto* always = section(tr("Cover and summary"), "reportCover", true, sections);
    always->setEnabled(false);
    always->setToolTip(tr("Name, client, designer and date are the project's; requirements and what was computed"));
    grids_ = section(tr("Calculation surfaces"), "reportGrids", true, sections);
    schedule_ = section(tr("Luminaire schedule"), "reportSchedule", true, sections);
    accuracy_ = section(tr("Error against run time"), "reportAccuracy", true, sections);
    comparison_ = section(tr("Comparison of algorithms"), "reportComparison", false, sections);
    method_ = section(tr("Method"), "reportMethod", true, sections);
    layout->addWidget(group);
    auto* views = new QGroupBox(tr("Views"));
    auto* column = new QVBoxLayout(views);
    column->setContentsMargins(0, 6, 0, 0);
    column->addLayout(viewList_);
    falseColour_ = section(tr("First view in false colour too"), "reportFalseColour", true, column);
    viewTime_->setObjectName(QStringLiteral("reportViewTime"));
    viewTime_->setRange(0.1, 3600), viewTime_->setDecimals(1), viewTime_->setValue(6), viewTime_->setSuffix(tr(" s"));
    viewTime_->setToolTip(tr("Time to render each view; the first, for the cover, takes twice as long"));
    auto* time = new QFormLayout;
    time->addRow(tr("Time for each"), viewTime_);
    column->addLayout(time);
    layout->addWidget(views);
    make_->setObjectName(QStringLiteral("reportMake"));
    make_->setDefault(true);
    stop_->setObjectName(QStringLiteral("reportStop"));
    export_->setObjectName(QStringLiteral("reportExport"));
    export_->setToolTip(tr("The PDF, and beside it every number in it as JSON"));
    bar_->setTextVisible(false);
    state_->setWordWrap(true);
    state_->setObjectName(QStringLiteral("reportState"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(make_, 1);
    buttons->addWidget(stop_);
    layout->addSpacing(8);
    layout->addLayout(buttons);
    layout->addWidget(bar_);
    layout->addWidget(state_);
    layout->addWidget(export_);
    layout->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(kChoicesWidth);
    return scroll;
}

QWidget* ReportPanel::makePreview() {
    thumbnails_->setObjectName(QStringLiteral("reportThumbnails"));
    thumbnails_->setAccessibleName(tr("Pages"));
    thumbnails_->setViewMode(QListView::IconMode);
    thumbnails_->setFlow(QListView::TopToBottom);
    thumbnails_->setWrapping(false);
    thumbnails_->setMovement(QListView::Static);
    thumbnails_->setIconSize({105, 148});
    thumbnails_->setSpacing(6);
    thumbnails_->setFixedWidth(kThumbnailsWidth);
    thumbnails_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    about_->setForegroundRole(QPalette::PlaceholderText);
    about_->setObjectName(QStringLiteral("reportAbout"));
    auto* fit = tool(tr("Fit"), "reportFit", tr("The whole page"));
    auto* out = tool(QStringLiteral("−"), "reportZoomOut", tr("Smaller (Ctrl+wheel)"));
    auto* in = tool(QStringLiteral("+"), "reportZoomIn", tr("Larger (Ctrl+wheel)"));
    connect(fit, &QToolButton::clicked, page_, &PageView::fit);
    connect(out, &QToolButton::clicked, page_, &PageView::zoomOut);
    connect(in, &QToolButton::clicked, page_, &PageView::zoomIn);
    auto* bar = new QHBoxLayout;
    bar->addWidget(about_, 1);
    for (auto* button : {fit, out, in}) bar->addWidget(button);
    auto* right = new QVBoxLayout;
    right->addLayout(bar);
    right->addWidget(page_, 1);
    auto* pages = new QWidget;
    auto* row = new QHBoxLayout(pages);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(thumbnails_);
    row->addLayout(right, 1);
    auto* empty = new QLabel(tr("No report yet. Choose what goes in and press Make the report: its pages are shown here before you export them."));
    empty->setObjectName(QStringLiteral("reportEmpty"));
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    empty->setMargin(40);
    empty->setForegroundRole(QPalette::PlaceholderText);
    stage_->addWidget(empty);
    stage_->addWidget(pages);
    return stage_;
}

void ReportPanel::fillViews() {
    std::vector<std::string> names, known;
    if (session_.project())
        for (const auto& view : session_.project()->project.views) names.push_back(view.name);
    for (const auto& view : views_) known.push_back(view.name);
    if (names == known) return;
    for (auto& view : views_) delete view.box;
    views_.clear();
    for (const auto& name : names) {
        views_.push_back({name, section(qt(name), "", true, viewList_)});
        views_.back().box->setObjectName(QStringLiteral("reportView_") + qt(name));
        connect(views_.back().box, &QCheckBox::toggled, this, &ReportPanel::changed);
    }
}

ReportChoice ReportPanel::choice() const {
    ReportChoice out;
    for (const auto& view : views_)
        if (view.box->isChecked()) out.views.push_back(view.name);
    out.falseColour = falseColour_->isChecked();
    out.grids = grids_->isChecked(), out.schedule = schedule_->isChecked(), out.accuracy = accuracy_->isChecked(), out.method = method_->isChecked();
    out.comparison = comparison_->isChecked() && comparison_->isEnabled();
    out.viewSeconds = viewTime_->value();
    out.solve.targetError = 0.02;
    return out;
}

/// What costs nothing new is seen at once.
void ReportPanel::changed() {
    if (session_.reporting.pages() && session_.reporting.isQuick(choice())) make();
    refresh();
}

void ReportPanel::make() { session_.reporting.make(choice()); }

void ReportPanel::refresh() {
    const bool running = session_.place.jobs.running(JobKind::Report);
    const bool made = session_.reporting.pages() != nullptr;
    make_->setEnabled(session_.project() != nullptr);
    make_->setText(made ? tr("Make it anew") : tr("Make the report"));
    stop_->setEnabled(running);
    export_->setEnabled(made && !running);
    comparison_->setEnabled(session_.comparing.current());
    comparison_->setToolTip(session_.comparing.current() ? tr("Curves and tables of the comparison") : tr("Nothing was compared on this project yet"));
    bar_->setVisible(running);
    if (!running) {
        state_->setText(!session_.project()                      ? tr("Open a project to report on it.")
                        : !session_.solving.current() && !made   ? tr("The calculation surfaces are solved first.")
                        : made && !session_.reporting.current()  ? tr("The project has changed since: make it anew.")
                                                                 : QString());
    }
    for (const auto& job : session_.place.jobs.states()) {
        if (job.kind != JobKind::Report) continue;
        showProgress(*bar_, job);
        state_->setText(jobText(job));
    }
}

void ReportPanel::refreshPages() {
    const auto& reporting = session_.reporting;
    stage_->setCurrentIndex(reporting.pages() ? 1 : 0);
    if (reporting.pages().get() != shown_) {
        shown_ = reporting.pages().get();
        const QSignalBlocker quiet(thumbnails_);
        const int row = std::max(0, thumbnails_->currentRow());
        thumbnails_->clear();
        int number = 0;
        for (const auto& image : reporting.thumbnails()) {
            auto* item = new QListWidgetItem(QIcon(QPixmap::fromImage(qimageOf(image))), QString::number(++number));
            item->setTextAlignment(Qt::AlignHCenter);
            thumbnails_->addItem(item);
        }
        thumbnails_->setCurrentRow(std::min(row, thumbnails_->count() - 1));
        if (shown_ != nullptr) askForPage();
    }
    if (shown_ == nullptr) return;
    const auto& page = reporting.page();
    if (!page.rgb.empty() && static_cast<int>(reporting.lookedAt()) == thumbnails_->currentRow()) page_->setPage(qimageOf(page));
    about_->setText(tr("Page %1 of %2").arg(thumbnails_->currentRow() + 1).arg(thumbnails_->count()));
}

void ReportPanel::askForPage() {
    const int row = thumbnails_->currentRow();
    if (row < 0 || shown_ == nullptr) return;
    const auto index = static_cast<std::size_t>(row);
    // Coarse until the sharp one is drawn.
    if (index != session_.reporting.lookedAt() || session_.reporting.page().rgb.empty()) page_->setPage(qimageOf(session_.reporting.thumbnails()[index]));
    session_.reporting.look(index, page_->dotsPerMm());
    about_->setText(tr("Page %1 of %2").arg(row + 1).arg(thumbnails_->count()));
}

void ReportPanel::exportTo() {
    const auto file = QFileDialog::getSaveFileName(this, tr("Export report"), session_.project() ? qt(session_.project()->project.file.stem().string()) + QStringLiteral(".pdf") : QString(),
                                                   tr("Report (*.pdf)"));
    if (file.isEmpty()) return;
    if (const auto begun = session_.reporting.save(file.toStdString()); !begun) emit failed(qt(begun.error().text()));
}

}  // namespace luxdeck::gui

#include "gui/panels/compare_controls.h"

#include "engine/algorithms/registry.h"
#include "gui/panels/job_text.h"
#include "gui/panels/text.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

/// Those that a designer chooses between first.
bool isFirstChoice(const std::string& name) { return name == "path" || name == "shared"; }

QString limitsOf(const Algorithm& algorithm) {
    auto text = qt(algorithm.summary) + QStringLiteral(". ");
    text += algorithm.bias > 0 ? QObject::tr("Its bias is up to %1 %: that much stays however long it runs.").arg(100 * algorithm.bias, 0, 'g', 2) : algorithm.interreflection ? QObject::tr("Unbiased.") : QObject::tr("Leaves out interreflection.");
    for (const auto& [name, why] : algorithm.limits) text += QStringLiteral("\n") + qt(name) + QStringLiteral(": ") + qt(why);
    return text;
}

QLabel* quietLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QString duration(double seconds) {
    if (seconds < 90) return QObject::tr("%1 s").arg(std::ceil(seconds), 0, 'f', 0);
    return seconds < 5400 ? QObject::tr("%1 min").arg(seconds / 60, 0, 'f', 1) : QObject::tr("%1 h").arg(seconds / 3600, 0, 'f', 1);
}

}  // namespace

CompareControls::CompareControls(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), subjects_(new QVBoxLayout), grids_(new QCheckBox(tr("Calculation surfaces"), this)), budget_(new QDoubleSpinBox(this)), known_(new QDoubleSpinBox(this)), picturesKnown_(new QDoubleSpinBox(this)), rungs_(new QSpinBox(this)),
      repetitions_(new QSpinBox(this)), estimate_(quietLabel({}, this)), state_(new QLabel(this)), compare_(new QPushButton(tr("Compare"), this)), stop_(new QPushButton(tr("Stop"), this)),
      volumes_(new QPushButton(tr("Build a volume by each"), this)), bar_(new QProgressBar(this)) {
    grids_->setObjectName(QStringLiteral("compareGrids"));
    grids_->setChecked(true);
    budget_->setObjectName(QStringLiteral("compareBudget"));
    budget_->setRange(0.05, 3600), budget_->setDecimals(2), budget_->setValue(2), budget_->setSuffix(tr(" s"));
    budget_->setToolTip(tr("Time of each algorithm's largest run; each smaller run takes half of the next"));
    rungs_->setObjectName(QStringLiteral("compareRungs"));
    rungs_->setRange(2, 12), rungs_->setValue(5);
    rungs_->setToolTip(tr("Points on each curve"));
    repetitions_->setObjectName(QStringLiteral("compareRepetitions"));
    repetitions_->setRange(3, 64), repetitions_->setValue(4);
    repetitions_->setToolTip(tr("Of each run, with other random numbers: the bars of the errors are from these"));
    for (auto* box : {known_, picturesKnown_}) {
        box->setRange(0.1, 90), box->setDecimals(1), box->setPrefix(tr("± ")), box->setSuffix(tr(" %"));
        box->setToolTip(tr("The reference is measured first, until it is known to this (95 %); errors much smaller cannot be told"));
    }
    known_->setObjectName(QStringLiteral("compareKnown"));
    known_->setValue(2);
    picturesKnown_->setObjectName(QStringLiteral("comparePicturesKnown"));
    picturesKnown_->setValue(20);
    compare_->setObjectName(QStringLiteral("compareButton"));
    compare_->setDefault(true);
    stop_->setObjectName(QStringLiteral("compareStop"));
    stop_->setToolTip(tr("Keeps the runs that are finished"));
    volumes_->setObjectName(QStringLiteral("compareVolumes"));
    volumes_->setToolTip(tr("Builds the project's irradiance volume by each of these algorithms and by path as the reference: to see objects lit by them side by side in linked views"));
    estimate_->setObjectName(QStringLiteral("compareEstimate"));
    state_->setObjectName(QStringLiteral("compareState"));
    state_->setWordWrap(true);
    bar_->setTextVisible(false);
    bar_->setRange(0, 0);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 0, 10, 8);
    auto* kinds = new QGroupBox(tr("Algorithms"), this);
    auto* kindsLayout = new QVBoxLayout(kinds);
    kindsLayout->setContentsMargins(0, 6, 0, 0);
    addAlgorithms(kindsLayout);
    layout->addWidget(kinds);
    auto* on = new QGroupBox(tr("On"), this);
    on->setLayout(subjects_);
    subjects_->setContentsMargins(0, 6, 0, 0);
    subjects_->addWidget(grids_);
    layout->addWidget(on);
    auto* form = new QFormLayout;
    form->addRow(tr("Largest run"), budget_);
    form->addRow(tr("Runs each"), rungs_);
    form->addRow(tr("Repetitions"), repetitions_);
    form->addRow(tr("Reference"), known_);
    form->addRow(tr("of pictures"), picturesKnown_);
    layout->addSpacing(6);
    layout->addLayout(form);
    layout->addWidget(estimate_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(compare_, 1);
    buttons->addWidget(stop_);
    layout->addLayout(buttons);
    layout->addWidget(bar_);
    layout->addWidget(state_);
    layout->addWidget(volumes_);
    layout->addStretch(1);

    connect(compare_, &QPushButton::clicked, this, &CompareControls::start);
    connect(stop_, &QPushButton::clicked, this, [this] { session_.comparing.cancel(); });
    connect(volumes_, &QPushButton::clicked, this, [this] { session_.comparing.buildVolumes(); });
    connect(grids_, &QCheckBox::toggled, this, &CompareControls::estimate);
    connect(budget_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &CompareControls::estimate);
    for (auto* box : {rungs_, repetitions_}) connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, &CompareControls::estimate);
    session_.observe([this](Change change) {
        if (change == Change::Project) fillViews();
        if (change == Change::Jobs || change == Change::Project || change == Change::Comparison) refresh();
    });
    fillViews();
    refresh();
}

void CompareControls::addAlgorithms(QVBoxLayout* layout) {
    layout->setSpacing(3);
    for (const auto& algorithm : algorithms()) {
        auto* box = new QCheckBox(qt(algorithm.name) + (algorithm.bias > 0 ? tr("   bias up to %1 %").arg(100 * algorithm.bias, 0, 'g', 2) : algorithm.interreflection ? QString() : tr("   no interreflection")), this);
        box->setObjectName(QStringLiteral("compare_") + qt(algorithm.name));
        box->setChecked(isFirstChoice(algorithm.name));
        box->setToolTip(limitsOf(algorithm));
        auto* summary = quietLabel(qt(algorithm.summary), this);
        summary->setIndent(24);
        summary->setToolTip(box->toolTip());
        layout->addWidget(box);
        layout->addWidget(summary);
        algorithms_.push_back({algorithm.name, box});
        connect(box, &QCheckBox::toggled, this, &CompareControls::estimate);
    }
}

void CompareControls::fillViews() {
    std::vector<std::string> names;
    if (session_.project())
        for (const auto& view : session_.project()->project.views) names.push_back(view.name);
    std::vector<std::string> known;
    for (const auto& view : views_) known.push_back(view.name);
    grids_->setEnabled(session_.project() && !session_.project()->project.grids.empty());
    if (names != known) {
        for (auto& view : views_) delete view.box;
        views_.clear();
        for (const auto& name : names) {
            auto* box = new QCheckBox(tr("View %1").arg(qt(name)), this);
            box->setObjectName(QStringLiteral("compareView_") + qt(name));
            subjects_->addWidget(box);
            views_.push_back({name, box});
            connect(box, &QCheckBox::toggled, this, &CompareControls::estimate);
        }
    }
    estimate();
}

CompareSettings CompareControls::settings() const {
    CompareSettings out;
    for (const auto& algorithm : algorithms_)
        if (algorithm.box->isChecked()) out.algorithms.push_back(algorithm.name);
    for (const auto& view : views_)
        if (view.box->isChecked()) out.views.push_back(view.name);
    out.grids = grids_->isChecked() && grids_->isEnabled();
    out.budgetSeconds = budget_->value();
    out.referenceError = known_->value() / 100, out.pictureReferenceError = picturesKnown_->value() / 100;
    out.rungs = rungs_->value(), out.repetitions = repetitions_->value();
    return out;
}

void CompareControls::estimate() {
    const auto wanted = settings();
    const bool possible = session_.project() && !wanted.algorithms.empty() && (wanted.grids || !wanted.views.empty());
    compare_->setEnabled(possible);
    if (!session_.project()) estimate_->setText(tr("Open a project to compare algorithms on it."));
    else if (wanted.algorithms.empty()) estimate_->setText(tr("Choose an algorithm."));
    else if (!possible) estimate_->setText(tr("Choose what to compare them on."));
    else estimate_->setText(tr("About %1 of runs, after the reference and each algorithm's preparation.").arg(duration(session_.comparing.expectedSeconds(wanted))));
}

void CompareControls::start() { session_.comparing.start(settings()); }

void CompareControls::refresh() {
    const bool running = session_.place.jobs.running(JobKind::Compare);
    estimate();
    compare_->setText(running ? tr("Start again") : tr("Compare"));
    stop_->setEnabled(running);
    bar_->setVisible(running);
    state_->setVisible(running);
    const bool hasVolume = session_.project() && !session_.project()->project.volumes.empty();
    volumes_->setVisible(hasVolume);
    volumes_->setEnabled(session_.comparing.current() && !running && !session_.place.jobs.running(JobKind::Volume));
    for (const auto& job : session_.place.jobs.states())
        if (job.kind == JobKind::Compare) state_->setText(jobText(job));
}

}  // namespace luxdeck::gui

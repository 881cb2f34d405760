#include "gui/panels/solve_panel.h"

#include "engine/algorithms/registry.h"
#include "gui/panels/job_text.h"
#include "gui/panels/text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace luxdeck::gui {

namespace {
constexpr const char* kFirstChoice = "shared";

bool keepsLayers(const std::string& algorithm) { return algorithm == "path" || algorithm == "direct"; }
}  // namespace

SolvePanel::SolvePanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), algorithm_(new QComboBox(this)), summary_(new QLabel(this)), state_(new QLabel(this)), target_(new QDoubleSpinBox(this)),
      time_(new QDoubleSpinBox(this)), layers_(new QCheckBox(tr("Keep the light of each luminaire apart"), this)), solve_(new QPushButton(tr("Solve"), this)),
      stop_(new QPushButton(tr("Stop"), this)), bar_(new QProgressBar(this)) {
    algorithm_->setObjectName(QStringLiteral("solveAlgorithm"));
    for (const auto& algorithm : algorithms()) algorithm_->addItem(qt(algorithm.name));
    algorithm_->setCurrentText(QString::fromLatin1(kFirstChoice));
    summary_->setWordWrap(true);
    summary_->setForegroundRole(QPalette::PlaceholderText);
    target_->setObjectName(QStringLiteral("solveTarget"));
    target_->setRange(0.1, 50);
    target_->setDecimals(1);
    target_->setValue(2);
    target_->setSuffix(tr(" %"));
    target_->setToolTip(tr("Every point, Ēm, Emin and Uo is computed until its 95 % interval is at most this wide to either side"));
    time_->setObjectName(QStringLiteral("solveTime"));
    time_->setRange(1, 86400);
    time_->setDecimals(0);
    time_->setValue(60);
    time_->setSuffix(tr(" s"));
    time_->setToolTip(tr("When the time is up, what is known by then is kept, with its true intervals"));
    layers_->setObjectName(QStringLiteral("solveLayers"));
    layers_->setToolTip(tr("Dimming and switching are then followed at once, without another solve. Only by the algorithms path and direct"));
    solve_->setObjectName(QStringLiteral("solveButton"));
    solve_->setDefault(true);
    stop_->setObjectName(QStringLiteral("solveStop"));
    bar_->setTextVisible(false);
    bar_->setRange(0, 1000);
    state_->setWordWrap(true);
    state_->setObjectName(QStringLiteral("solveState"));

    auto* form = new QFormLayout;
    form->addRow(tr("Algorithm"), algorithm_);
    form->addRow(summary_);
    form->addRow(tr("Error at most"), target_);
    form->addRow(tr("Time at most"), time_);
    form->addRow(layers_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(solve_, 1);
    buttons->addWidget(stop_);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addLayout(buttons);
    layout->addWidget(bar_);
    layout->addWidget(state_);
    layout->addStretch(1);

    connect(solve_, &QPushButton::clicked, this, &SolvePanel::start);
    connect(stop_, &QPushButton::clicked, this, [this] { session_.solving.cancel(); });
    connect(layers_, &QCheckBox::toggled, this, [this](bool on) {
        if (on && !keepsLayers(algorithm_->currentText().toStdString())) algorithm_->setCurrentText(QStringLiteral("path"));
    });
    connect(algorithm_, &QComboBox::currentTextChanged, this, &SolvePanel::explain);
    session_.observe([this](Change change) {
        if (change == Change::Jobs || change == Change::Project || change == Change::Solve) refresh();
    });
    explain();
    refresh();
}

void SolvePanel::explain() {
    const auto name = algorithm_->currentText().toStdString();
    const auto* algorithm = algorithmNamed(name);
    if (algorithm == nullptr) return;
    auto text = qt(algorithm->summary) + QStringLiteral(". ");
    text += algorithm->bias > 0 ? tr("Biased by up to %1 %, beyond the interval.").arg(100 * algorithm->bias, 0, 'g', 2) : tr("Unbiased: noise is its only error.");
    summary_->setText(text);
    if (!keepsLayers(name)) layers_->setChecked(false);
}

SolveSettings SolvePanel::settings() const {
    SolveSettings settings;
    settings.algorithm = algorithm_->currentText().toStdString();
    settings.targetError = target_->value() / 100;
    settings.timeSeconds = time_->value();
    settings.byLuminaire = layers_->isChecked();
    return settings;
}

void SolvePanel::start() {
    if (session_.project() && !session_.project()->project.grids.empty()) session_.solving.start(settings());
}

void SolvePanel::refresh() {
    const bool running = session_.place.jobs.running(JobKind::Solve);
    const bool possible = session_.project() != nullptr && !session_.project()->project.grids.empty();
    solve_->setEnabled(possible);
    solve_->setText(running ? tr("Start again") : tr("Solve"));
    stop_->setEnabled(running);
    bar_->setVisible(running);
    if (session_.project() && !possible) state_->setText(tr("This project has no calculation surface: add one with Insert > Calculation surface."));
    else if (!running) state_->clear();
    for (const auto& job : session_.place.jobs.states()) {
        if (job.kind != JobKind::Solve) continue;
        showProgress(*bar_, job);
        state_->setText(jobText(job));
    }
}

}  // namespace luxdeck::gui

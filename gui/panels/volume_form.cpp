#include "gui/panels/volume_form.h"

#include "engine/algorithms/registry.h"
#include "gui/panels/job_text.h"
#include "gui/panels/text.h"
#include "gui/session/volume_estimate.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace luxdeck::gui {

namespace {

constexpr const char* kFirstChoice = "path";
constexpr int kEstimateAfterMs = 200;  // of quiet

template <class Box, class Value>
Box* made(Box* box, const char* name, Value low, Value high, const QString& suffix, const QString& tip) {
    box->setObjectName(QString::fromLatin1(name));
    box->setRange(low, high);
    box->setSuffix(suffix);
    box->setToolTip(tip);
    box->setKeyboardTracking(false);
    return box;
}

}  // namespace

VolumeForm::VolumeForm(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), name_(new QLineEdit(this)), second_(new QSpinBox(this)), side_(new QSpinBox(this)), samples_(new QSpinBox(this)),
      refine_(new QDoubleSpinBox(this)), target_(new QDoubleSpinBox(this)), time_(new QDoubleSpinBox(this)), algorithm_(new QComboBox(this)), estimate_(new QLabel(this)),
      state_(new QLabel(this)), build_(new QPushButton(tr("Build volume"), this)), stop_(new QPushButton(tr("Stop"), this)), bar_(new QProgressBar(this)) {
    name_->setObjectName(QStringLiteral("volumeName"));
    name_->setToolTip(tr("A volume of the same name is replaced: give another one to compare"));
    const char* const names[] = {"volumeFirstX", "volumeFirstY", "volumeFirstZ"};
    for (std::size_t axis = 0; axis < 3; ++axis)
        first_[axis] = made(new QSpinBox(this), names[axis], 2, 1025, {}, tr("Vertices of the first level along %1").arg(QLatin1Char("xyz"[axis])));
    for (auto* box : first_) {
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);  // three stand in a row
        box->setMinimumWidth(40);
    }
    made(second_, "volumeSecond", 2, 32, {}, tr("A cell that holds furniture or walls gets so many vertices along each of its sides"));
    second_->setSpecialValueText(tr("none"));
    made(side_, "volumeBins", 2, 64, {}, tr("Each vertex looks in 2 n² directions: 17 gives 578"));
    made(samples_, "volumeSamples", 1, 65536, {}, tr("Of each direction, to begin with"));
    made(refine_, "volumeRefine", 0.0, 500.0, tr(" %"), tr("Instead of a second level: cells are divided while the light at their vertices differs by more than this"));
    refine_->setSpecialValueText(tr("off"));
    refine_->setDecimals(0);
    made(target_, "volumeTarget", 0.0, 50.0, tr(" %"), tr("Samples are doubled until the 95 % interval of the irradiance is at most this wide to either side"));
    target_->setSpecialValueText(tr("as sampled"));
    target_->setDecimals(1);
    made(time_, "volumeTime", 1.0, 86400.0, tr(" s"), tr("When the time is up, no more samples are taken"));
    time_->setDecimals(0);
    time_->setValue(60);
    algorithm_->setObjectName(QStringLiteral("volumeAlgorithm"));
    for (const auto& algorithm : algorithms()) algorithm_->addItem(qt(algorithm.name), qt(algorithm.summary));
    algorithm_->setCurrentText(QString::fromLatin1(kFirstChoice));
    estimate_->setObjectName(QStringLiteral("volumeEstimate"));
    state_->setObjectName(QStringLiteral("volumeState"));
    build_->setObjectName(QStringLiteral("volumeBuild"));
    stop_->setObjectName(QStringLiteral("volumeStop"));
    bar_->setObjectName(QStringLiteral("volumeBar"));
    bar_->setTextVisible(false);
    for (auto* label : {estimate_, state_}) label->setWordWrap(true);
    estimate_->setForegroundRole(QPalette::PlaceholderText);
    layOut();

    soon_.setSingleShot(true);
    soon_.setInterval(kEstimateAfterMs);
    connect(&soon_, &QTimer::timeout, this, &VolumeForm::estimate);
    for (auto* box : {first_[0], first_[1], first_[2], second_, side_}) connect(box, qOverload<int>(&QSpinBox::valueChanged), this, [this] { soon_.start(); });
    connect(refine_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
        second_->setEnabled(value == 0);
        soon_.start();
    });
    connect(algorithm_, &QComboBox::currentTextChanged, this, [this] { algorithm_->setToolTip(algorithm_->currentData().toString()); });
    connect(build_, &QPushButton::clicked, this, &VolumeForm::start);
    connect(stop_, &QPushButton::clicked, this, [this] { session_.place.jobs.cancel(JobKind::Volume); });
    session_.observe([form = QPointer<VolumeForm>(this)](Change change) {
        if (form && (change == Change::Jobs || change == Change::Project || change == Change::Volumes)) form->refresh();
    });
    takeDefaults();
    refresh();
}

void VolumeForm::layOut() {
    auto* form = new QFormLayout;
    form->addRow(tr("Name"), name_);
    auto* first = new QHBoxLayout;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis > 0) first->addWidget(new QLabel(QStringLiteral("×"), this));
        first->addWidget(first_[axis], 1);
    }
    form->addRow(tr("First level"), first);
    form->addRow(tr("Second level"), second_);
    form->addRow(tr("Refine above"), refine_);
    form->addRow(tr("Bins, n"), side_);
    form->addRow(tr("Samples a bin"), samples_);
    form->addRow(tr("Error at most"), target_);
    form->addRow(tr("Time at most"), time_);
    form->addRow(tr("Algorithm"), algorithm_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(build_, 1);
    buttons->addWidget(stop_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(form);
    layout->addWidget(estimate_);
    layout->addLayout(buttons);
    layout->addWidget(bar_);
    layout->addWidget(state_);
}

/// Another project: what it asks for. An edit of the same one leaves what the user has set.
void VolumeForm::takeDefaults() {
    const auto project = session_.project();
    const bool same = project && defaultsOf_ && project->project.file == defaultsOf_->project.file;
    defaultsOf_ = project;
    if (!project || same) return;
    const auto& volumes = project->project.volumes;
    if (const auto settings = volumeSettingsOf(project->project, {})) base_ = *settings;
    name_->setText(volumes.empty() ? QStringLiteral("room") : qt(volumes.front().name));
    for (std::size_t axis = 0; axis < 3; ++axis) first_[axis]->setValue(base_.firstLevel[axis]);
    second_->setValue(base_.secondLevel);
    side_->setValue(base_.side);
    samples_->setValue(static_cast<int>(base_.samplesPerBin));
    refine_->setValue(base_.refineBelow * 100);
    estimate();
}

VolumeRequest VolumeForm::request() const {
    VolumeRequest request;
    request.name = name_->text().trimmed().isEmpty() ? "room" : name_->text().trimmed().toStdString();
    request.settings = base_;
    for (std::size_t axis = 0; axis < 3; ++axis) request.settings.firstLevel[axis] = first_[axis]->value();
    request.settings.secondLevel = second_->value();
    request.settings.side = side_->value();
    request.settings.samplesPerBin = static_cast<std::uint32_t>(samples_->value());
    request.settings.refineBelow = refine_->value() / 100;
    request.options.algorithm = algorithm_->currentText().toStdString();
    request.options.targetError = target_->value() / 100;
    request.options.timeSeconds = time_->value();
    return request;
}

void VolumeForm::start() { session_.volumes.build(request()); }

/// In the background: large scenes are asked cell by cell what they hold.
void VolumeForm::estimate() {
    const auto project = session_.project();
    if (!project) return estimate_->clear();
    const auto number = ++asked_;
    session_.place.jobs.start(JobKind::Look, "Estimating the volume", [=, form = QPointer<VolumeForm>(this), settings = request().settings](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
        const auto found = estimateVolume(project->project.scene, settings);
        return [=] {
            if (!form || number != form->asked_) return;
            if (!found) return form->estimate_->setText(qt(found.error().message));
            const QLocale locale;
            form->estimate_->setText(tr("%1%2 vertices, %3 directions each: about %4 in memory")
                                         .arg(found->least ? tr("At least ") : QString(), locale.toString(static_cast<qulonglong>(found->vertices)),
                                              locale.toString(static_cast<qulonglong>(found->bins)), locale.formattedDataSize(static_cast<qint64>(found->bytes), 0)));
        };
    });
}

void VolumeForm::refresh() {
    takeDefaults();
    const bool running = session_.place.jobs.running(JobKind::Volume);
    build_->setEnabled(session_.project() != nullptr && !running);
    stop_->setVisible(running);
    bar_->setVisible(running);
    state_->setVisible(running);
    for (const auto& job : session_.place.jobs.states()) {
        if (job.kind != JobKind::Volume) continue;
        showProgress(*bar_, job);
        state_->setText(jobText(job));
        stop_->setEnabled(!job.cancelled);
    }
}

}  // namespace luxdeck::gui

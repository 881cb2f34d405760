#include "gui/panels/render_controls.h"

#include "engine/algorithms/registry.h"
#include "gui/panels/job_text.h"
#include "gui/panels/text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace luxdeck::gui {

namespace {
constexpr int kFromCamera = -1;  // instead of a view's index
}

RenderControls::RenderControls(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), view_(new QComboBox(this)), algorithm_(new QComboBox(this)), summary_(new QLabel(this)), state_(new QLabel(this)),
      width_(new QSpinBox(this)), height_(new QSpinBox(this)), target_(new QDoubleSpinBox(this)), time_(new QDoubleSpinBox(this)),
      render_(new QPushButton(tr("Render"), this)), stop_(new QPushButton(tr("Stop"), this)), bar_(new QProgressBar(this)) {
    view_->setObjectName(QStringLiteral("renderView"));
    algorithm_->setObjectName(QStringLiteral("renderAlgorithm"));
    for (const auto& algorithm : algorithms()) {
        algorithm_->addItem(qt(algorithm.name));
        algorithm_->setItemData(algorithm_->count() - 1, qt(algorithm.summary), Qt::ToolTipRole);
    }
    summary_->setWordWrap(true);
    summary_->setForegroundRole(QPalette::PlaceholderText);
    for (auto* box : {width_, height_}) box->setRange(16, 8192), box->setSuffix(tr(" px")), box->setKeyboardTracking(false);
    width_->setObjectName(QStringLiteral("renderWidth"));
    height_->setObjectName(QStringLiteral("renderHeight"));
    width_->setAccessibleName(tr("Width"));
    height_->setAccessibleName(tr("Height"));
    target_->setObjectName(QStringLiteral("renderTarget"));
    target_->setRange(0.1, 100), target_->setDecimals(1), target_->setValue(5), target_->setSuffix(tr(" %"));
    target_->setToolTip(tr("Root mean square over the pixels of the 95 % interval, relative to the mean luminance"));
    time_->setObjectName(QStringLiteral("renderTime"));
    time_->setRange(1, 86400), time_->setDecimals(0), time_->setValue(60), time_->setSuffix(tr(" s"));
    time_->setToolTip(tr("When the time is up, the picture is kept as it is by then"));
    render_->setObjectName(QStringLiteral("renderButton"));
    render_->setDefault(true);
    stop_->setObjectName(QStringLiteral("renderStop"));
    stop_->setToolTip(tr("Keeps the picture as it is by now"));
    bar_->setTextVisible(false);
    state_->setObjectName(QStringLiteral("renderState"));
    state_->setWordWrap(true);

    auto* size = new QHBoxLayout;
    size->addWidget(width_, 1);
    size->addWidget(new QLabel(QStringLiteral("×"), this));
    size->addWidget(height_, 1);
    auto* form = new QFormLayout;
    form->addRow(tr("View"), view_);
    form->addRow(tr("Size"), size);
    form->addRow(tr("Algorithm"), algorithm_);
    form->addRow(summary_);
    form->addRow(tr("Error at most"), target_);
    form->addRow(tr("Time at most"), time_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(render_, 1);
    buttons->addWidget(stop_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(form);
    layout->addLayout(buttons);
    layout->addWidget(bar_);
    layout->addWidget(state_);

    connect(render_, &QPushButton::clicked, this, &RenderControls::start);
    connect(stop_, &QPushButton::clicked, this, [this] { session_.pictures.cancel(); });
    connect(view_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &RenderControls::takeSize);
    const auto explain = [this] {
        if (const auto* algorithm = algorithmNamed(algorithm_->currentText().toStdString())) summary_->setText(qt(algorithm->summary));
    };
    connect(algorithm_, &QComboBox::currentTextChanged, this, explain);
    explain();
    session_.observe([this](Change change) {
        if (change == Change::Project) fillViews();
        if (change == Change::Jobs || change == Change::Project) refresh();
    });
    fillViews();
    refresh();
}

void RenderControls::setCamera(Camera camera) {
    camera_ = std::move(camera);
    fillViews();
}

void RenderControls::fillViews() {
    const auto before = view_->currentText();
    const QSignalBlocker quiet(view_);
    view_->clear();
    if (session_.project()) {
        const auto& views = session_.project()->project.views;
        for (std::size_t i = 0; i < views.size(); ++i) view_->addItem(qt(views[i].name), static_cast<int>(i));
        if (camera_) view_->addItem(tr("What the 3D view shows"), kFromCamera);
    }
    view_->setCurrentIndex(std::max(0, view_->findText(before)));
    if (view_->currentText() != before) takeSize();
}

std::optional<View> RenderControls::view() const {
    if (!session_.project() || view_->count() == 0) return std::nullopt;
    const int index = view_->currentData().toInt();
    const auto& views = session_.project()->project.views;
    if (index == kFromCamera) return camera_ ? camera_() : std::nullopt;
    return static_cast<std::size_t>(index) < views.size() ? std::optional(views[static_cast<std::size_t>(index)]) : std::nullopt;
}

void RenderControls::takeSize() {
    if (const auto seen = view()) width_->setValue(seen->width), height_->setValue(seen->height);
}

void RenderControls::start() {
    auto seen = view();
    if (!seen) return;
    seen->width = width_->value(), seen->height = height_->value();
    PictureRequest request{*seen, {}};
    request.settings.algorithm = algorithm_->currentText().toStdString();
    request.settings.targetError = target_->value() / 100;
    request.settings.timeSeconds = time_->value();
    if (const auto begun = session_.pictures.render(request); !begun) emit failed(qt(begun.error().text()));
}

void RenderControls::refresh() {
    const bool running = session_.place.jobs.running(JobKind::Render);
    render_->setEnabled(view_->count() > 0);
    render_->setText(running ? tr("Start again") : tr("Render"));
    stop_->setEnabled(running);
    bar_->setVisible(running);
    state_->setVisible(running);
    for (const auto& job : session_.place.jobs.states()) {
        if (job.kind != JobKind::Render) continue;
        showProgress(*bar_, job);
        state_->setText(jobText(job));
    }
}

}  // namespace luxdeck::gui

#include "gui/panels/look_controls.h"

#include "gui/panels/colour_bar.h"
#include "gui/panels/text.h"
#include "gui/panels/tone_histogram.h"
#include "tonemap/adaptation.h"
#include "tonemap/display_transform.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr double kMostEv = 8;
constexpr int kStepsPerEv = 4;

QLabel* quietLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QDoubleSpinBox* number(QWidget* parent, const char* name, double low, double high, double value, const QString& suffix) {
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(QString::fromLatin1(name));
    box->setRange(low, high);
    box->setDecimals(2);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setValue(value);
    box->setSuffix(suffix);
    box->setKeyboardTracking(false);
    return box;
}

QToolButton* segment(QButtonGroup* group, int id, const QString& text, const char* name, QHBoxLayout* row) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setObjectName(QString::fromLatin1(name));
    button->setCheckable(true);
    group->addButton(button, id);
    row->addWidget(button, 1);
    return button;
}

/// As the tone mapper says it, with the unit as people write it.
QString words(const std::string& text) { return qt(text).replace(QStringLiteral("cd/m^2"), QStringLiteral("cd/m²")); }

}  // namespace

LookControls::LookControls(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), kind_(new QButtonGroup(this)), pages_(new QStackedWidget(this)), adaptation_(quietLabel(this)), histogram_(new ToneHistogram(this)) {
    auto* kinds = new QHBoxLayout;
    kinds->setSpacing(0);
    segment(kind_, 0, tr("As seen"), "lookTone", kinds)->setChecked(true);
    segment(kind_, 1, tr("False colour"), "lookFalseColour", kinds);
    pages_->addWidget(makeTonePage());
    pages_->addWidget(makeColourPage());
    adaptation_->setObjectName(QStringLiteral("lookAdaptation"));
    adaptation_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(kinds);
    layout->addWidget(histogram_);
    layout->addWidget(pages_);
    layout->addWidget(adaptation_);
    connect(kind_, &QButtonGroup::idClicked, this, &LookControls::changed);
    fillDisplays();
    changed();
}

QWidget* LookControls::makeTonePage() {
    auto* page = new QWidget;
    toneForm_ = new QFormLayout(page);
    toneForm_->setContentsMargins(0, 4, 0, 0);
    operator_ = new QComboBox(page);
    operator_->setObjectName(QStringLiteral("lookOperator"));
    operator_->addItem(tr("By an eye in the room"), static_cast<int>(tonemap::Operator::Human));
    operator_->addItem(tr("By a camera, all recorded"), static_cast<int>(tonemap::Operator::Camera));
    operator_->addItem(tr("With one exposure"), static_cast<int>(tonemap::Operator::Linear));
    operator_->setToolTip(tr("Human, camera and linear tone mapping: how the room's luminances become the display's"));
    toneForm_->addRow(tr("Seen"), operator_);
    exposure_ = new QWidget(page);
    auto* row = new QHBoxLayout(exposure_);
    row->setContentsMargins(0, 0, 0, 0);
    exposureSlider_ = new QSlider(Qt::Horizontal, exposure_);
    exposureSlider_->setObjectName(QStringLiteral("lookExposureSlider"));
    exposureSlider_->setRange(static_cast<int>(-kMostEv * kStepsPerEv), static_cast<int>(kMostEv * kStepsPerEv));
    exposureValue_ = number(exposure_, "lookExposure", -kMostEv, kMostEv, 0, tr(" EV"));
    exposureValue_->setStepType(QAbstractSpinBox::DefaultStepType);
    exposureValue_->setSingleStep(0.25);
    exposureValue_->setToolTip(tr("Stops over the automatic exposure, at which the mean shows as 18 % grey"));
    row->addWidget(exposureSlider_, 1);
    row->addWidget(exposureValue_);
    toneForm_->addRow(tr("Exposure"), exposure_);
    const struct { const char* name; QString text, tip; } parts[3] = {
        {"veil", tr("Veil"), tr("Light that scatters in the eye about bright lamps")},
        {"acuity", tr("Acuity"), tr("Detail that an eye does not see where it is dark")},
        {"colour", tr("Colour"), tr("Colours that fade at night")}};
    for (int i = 0; i < 3; ++i) {
        auto* choice = new QComboBox(page);
        choice->setObjectName(QStringLiteral("look_") + QString::fromLatin1(parts[i].name));
        choice->addItems({tr("Automatic"), tr("On"), tr("Off")});
        choice->setToolTip(parts[i].tip + tr(". Automatic: on for the eye, off for camera and one exposure"));
        auto* why = quietLabel(page);
        auto* both = new QVBoxLayout;
        both->setSpacing(1);
        both->addWidget(choice);
        both->addWidget(why);
        effects_[i] = {choice, why};
        toneForm_->addRow(parts[i].text, both);
        connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &LookControls::changed);
    }
    whiteBalance_ = new QCheckBox(tr("Adapt to the lamps' white"), page);
    whiteBalance_->setObjectName(QStringLiteral("lookWhiteBalance"));
    whiteBalance_->setChecked(true);
    toneForm_->addRow(whiteBalance_);
    white_ = number(page, "lookWhite", 1, 1e5, 100, tr(" cd/m²"));
    black_ = number(page, "lookBlack", 0.01, 1e3, 1, tr(" cd/m²"));
    white_->setToolTip(tr("Luminance of the display's white"));
    black_->setToolTip(tr("Luminance of the display's black: what screen and room add"));
    toneForm_->addRow(tr("Screen white"), white_);
    toneForm_->addRow(tr("Screen black"), black_);
    ocioDisplay_ = new QComboBox(page);
    ocioDisplay_->setObjectName(QStringLiteral("lookOcioDisplay"));
    ocioView_ = new QComboBox(page);
    ocioView_->setObjectName(QStringLiteral("lookOcioView"));
    ocioDisplay_->setToolTip(tr("OpenColorIO display; another config is taken from the environment variable OCIO"));
    ocioView_->setToolTip(tr("OpenColorIO view"));
    toneForm_->addRow(tr("Display"), ocioDisplay_);
    toneForm_->addRow(tr("Display view"), ocioView_);

    connect(operator_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &LookControls::changed);
    connect(exposureSlider_, &QSlider::valueChanged, this, [this](int steps) { exposureValue_->setValue(steps / static_cast<double>(kStepsPerEv)); });
    connect(exposureValue_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double ev) {
        const QSignalBlocker quiet(exposureSlider_);
        exposureSlider_->setValue(static_cast<int>(std::lround(ev * kStepsPerEv)));
        changed();
    });
    for (auto* box : {white_, black_}) connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &LookControls::changed);
    connect(whiteBalance_, &QCheckBox::toggled, this, &LookControls::changed);
    connect(ocioDisplay_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { fillOcioViews(), changed(); });
    connect(ocioView_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &LookControls::changed);
    return page;
}

QWidget* LookControls::makeColourPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 4, 0, 0);
    bar_ = new ColourBar(page);
    form->addRow(bar_);
    map_ = new QComboBox(page);
    map_->setObjectName(QStringLiteral("lookMap"));
    map_->addItem(tr("Dusk (safe for colour blindness)"), static_cast<int>(tonemap::ColourMap::Dusk));
    map_->addItem(tr("Heat"), static_cast<int>(tonemap::ColourMap::Heat));
    form->addRow(tr("Colours"), map_);
    logarithmic_ = new QCheckBox(tr("Equal steps are equal ratios"), page);
    logarithmic_->setObjectName(QStringLiteral("lookLogarithmic"));
    logarithmic_->setToolTip(tr("A logarithmic scale"));
    logarithmic_->setChecked(true);
    form->addRow(logarithmic_);
    automatic_ = new QCheckBox(tr("Range of this picture"), page);
    automatic_->setObjectName(QStringLiteral("lookAutomatic"));
    automatic_->setChecked(true);
    form->addRow(automatic_);
    low_ = number(page, "lookLow", 0, 1e7, 1, tr(" cd/m²"));
    high_ = number(page, "lookHigh", 0.01, 1e8, 1000, tr(" cd/m²"));
    form->addRow(tr("From"), low_);
    form->addRow(tr("To"), high_);
    isolines_ = new QCheckBox(tr("Lines of equal luminance"), page);
    isolines_->setObjectName(QStringLiteral("lookIsolines"));
    form->addRow(isolines_);
    connect(map_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &LookControls::changed);
    for (auto* box : {logarithmic_, automatic_, isolines_}) connect(box, &QCheckBox::toggled, this, &LookControls::changed);
    for (auto* box : {low_, high_}) connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &LookControls::changed);
    return page;
}

void LookControls::fillDisplays() {
    const auto displays = tonemap::displaysOf();
    if (!displays) return session_.place.complain(displays.error());
    const QSignalBlocker quiet(ocioDisplay_);
    for (const auto& display : *displays) {
        QStringList views;
        for (const auto& view : display.views) views << qt(view);
        ocioDisplay_->addItem(qt(display.display), views);
    }
    fillOcioViews();
}

void LookControls::fillOcioViews() {
    const QSignalBlocker quiet(ocioView_);
    ocioView_->clear();
    ocioView_->addItems(ocioDisplay_->currentData().toStringList());
    const int ours = ocioView_->findText(QString::fromUtf8(tonemap::kToneMappedView.data(), static_cast<int>(tonemap::kToneMappedView.size())));
    if (ours >= 0) ocioView_->setCurrentIndex(ours);
}

Look LookControls::look() const {
    const auto choice = [](const QComboBox* box) { return box->currentIndex() == 0 ? std::optional<bool>() : box->currentIndex() == 1; };
    Look look;
    look.falseColour = kind_->checkedId() == 1;
    look.tone.op = static_cast<tonemap::Operator>(operator_->currentData().toInt());
    look.tone.exposureEv = look.tone.op == tonemap::Operator::Linear ? exposureValue_->value() : 0;
    look.tone.display = {white_->value(), black_->value()};
    look.tone.effects = {choice(effects_[0].choice), choice(effects_[1].choice), choice(effects_[2].choice)};
    look.how = {whiteBalance_->isChecked(), ocioDisplay_->currentText().toStdString(), ocioView_->currentText().toStdString()};
    look.map = static_cast<tonemap::ColourMap>(map_->currentData().toInt());
    look.logarithmic = logarithmic_->isChecked();
    if (!automatic_->isChecked()) look.range = {low_->value(), high_->value()};
    look.isolines = look.falseColour && isolines_->isChecked();
    return look;
}

void LookControls::changed() {
    black_->setMaximum(0.99 * white_->value());
    low_->setMinimum(logarithmic_->isChecked() ? 0.01 : 0);
    low_->setMaximum(0.99 * high_->value());
    for (auto* box : {low_, high_}) box->setEnabled(!automatic_->isChecked());
    const auto wanted = look();
    pages_->setCurrentIndex(wanted.falseColour ? 1 : 0);
    const bool linear = wanted.tone.op == tonemap::Operator::Linear;
    exposure_->setVisible(linear);
    if (auto* label = toneForm_->labelForField(exposure_)) label->setVisible(linear);
    session_.pictures.setLook(wanted);
    refresh();
}

void LookControls::tellDecisions(const tonemap::ToneMapRecord& record) {
    const auto& units = session_.display().units;
    adaptation_->setText(tr("Adapted to %1 on average; what is seen goes from %2 to %3. Mapping: %4 (%5).")
                             .arg(qt(units.luminanceText(record.worldLogMeanCdM2)), qt(units.luminanceText(std::max(record.worldMinCdM2, tonemap::kDarkestVisible))), qt(units.luminanceText(record.worldMaxCdM2)),
                                  words(record.mapping), words(record.why)));
    const char* names[3] = {"veil", "acuity", "colour"};
    for (int i = 0; i < 3; ++i)
        for (const auto& effect : record.effects)
            if (effect.effect == names[i]) effects_[i].why->setText((effect.applied ? tr("Applied: ") : tr("Not applied: ")) + words(effect.why));
}

void LookControls::refresh() {
    const auto& seen = session_.pictures.developed(0);
    histogram_->show(seen, session_.display().units);
    if (!seen) {
        adaptation_->clear();
        for (auto& effect : effects_) effect.why->clear();
        return;
    }
    if (seen->record) tellDecisions(*seen->record);
    adaptation_->setVisible(seen->record.has_value());
    const auto& units = session_.display().units;
    const auto wanted = look();
    bar_->show(wanted.map, {units.luminance(seen->range.low), units.luminance(seen->range.high)}, wanted.logarithmic, qt(units.luminanceUnit()));
    if (automatic_->isChecked()) {
        const QSignalBlocker quietLow(low_), quietHigh(high_);
        high_->setValue(seen->range.high);
        low_->setMaximum(0.99 * seen->range.high);
        low_->setValue(seen->range.low);
    }
}

void LookControls::mark(double cdM2) { histogram_->mark(cdM2); }

}  // namespace luxdeck::gui

#include "gui/panels/property_form.h"

#include "gui/panels/text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

#include <array>
#include <memory>
#include <utility>

namespace luxdeck::gui {

namespace {

/// A number that is told when it is done, not while it is typed, and once.
QDoubleSpinBox* spinBox(double value, const PropertyForm::Range& range, const std::function<void(double)>& changed, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setRange(range.low, range.high);
    box->setDecimals(range.decimals);
    box->setSingleStep(range.step);
    box->setKeyboardTracking(false);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setMinimumWidth(56);
    if (!range.unit.isEmpty()) box->setSuffix(QStringLiteral(" ") + range.unit);
    box->setSpecialValueText(range.least);
    box->setValue(value);
    auto told = std::make_shared<double>(box->value());
    QObject::connect(box, &QDoubleSpinBox::editingFinished, box, [box, told, changed] {
        if (box->value() == *told) return;
        *told = box->value();
        changed(box->value());
    });
    return box;
}

}  // namespace

PropertyForm::PropertyForm(const QString& title, const QString& kind, const Units& units, QWidget* parent)
    : QWidget(parent), units_(units), rows_(new QFormLayout(this)) {
    rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    auto* name = new QLabel(title, this);
    name->setObjectName(QStringLiteral("propertyTitle"));
    name->setWordWrap(true);
    auto font = name->font();
    font.setPointSizeF(font.pointSizeF() * 1.2);
    font.setWeight(QFont::DemiBold);
    name->setFont(font);
    rows_->addRow(name);
    note(kind);
}

void PropertyForm::heading(const QString& text) {
    auto* label = new QLabel(text, this);
    auto font = label->font();
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    label->setContentsMargins(0, 10, 0, 0);
    rows_->addRow(label);
}

QLabel* PropertyForm::fact(const QString& label, const QString& value) {
    auto* text = new QLabel(value, this);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    rows_->addRow(label, text);
    return text;
}

QLabel* PropertyForm::note(const QString& text) {
    auto* label = new QLabel(text, this);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    rows_->addRow(label);
    return label;
}

void PropertyForm::text(const Field& field, const std::string& value, std::function<void(const std::string&)> changed) {
    auto* edit = new QLineEdit(qt(value), this);
    edit->setObjectName(QString::fromLatin1(field.name));
    edit->setCursorPosition(0);
    auto told = std::make_shared<QString>(edit->text());
    connect(edit, &QLineEdit::editingFinished, edit, [edit, told, changed = std::move(changed)] {
        if (edit->text() == *told) return;
        *told = edit->text();
        changed(edit->text().toStdString());
    });
    rows_->addRow(field.label, edit);
}

void PropertyForm::number(const Field& field, double value, const Range& range, std::function<void(double)> changed) {
    auto* box = spinBox(value, range, changed, this);
    box->setObjectName(QString::fromLatin1(field.name));
    rows_->addRow(field.label, box);
}

void PropertyForm::axes(const Field& field, const Vec3d& shown, const Range& range, const std::function<void(const Vec3d&)>& changed) {
    auto* line = new QWidget(this);
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto now = std::make_shared<Vec3d>(shown);
    auto bare = range;  // the unit stands beside the label: three of them would leave no room for the numbers
    bare.unit.clear();
    for (int axis = 0; axis < 3; ++axis) {
        auto* box = spinBox(shown[axis], bare, [now, axis, changed](double value) {
            (*now)[axis] = value;
            changed(*now);
        }, line);
        const QChar letter = QLatin1Char("XYZ"[axis]);
        box->setObjectName(QString::fromLatin1(field.name) + letter);
        box->setAccessibleName(field.label + QLatin1Char(' ') + letter.toLower());
        box->setToolTip(box->accessibleName());
        layout->addWidget(box, 1);
    }
    // Above its numbers by its own row: rows that a form wraps by itself are forgotten in the height that it asks for.
    rows_->addRow(new QLabel(range.unit.isEmpty() ? field.label : field.label + QStringLiteral(" [") + range.unit + QLatin1Char(']'), this));
    rows_->addRow(line);
}

void PropertyForm::place(const Field& field, const Vec3d& metres, std::function<void(const Vec3d&)> changed) {
    Range range;
    range.unit = QString::fromUtf8(units_.lengthUnit());
    const Vec3d shown(units_.lengthOf(metres.x), units_.lengthOf(metres.y), units_.lengthOf(metres.z));
    axes(field, shown, range, [units = units_, changed = std::move(changed)](const Vec3d& v) { changed({units.metres(v.x), units.metres(v.y), units.metres(v.z)}); });
}

void PropertyForm::direction(const Field& field, const Vec3d& value, std::function<void(const Vec3d&)> changed) { axes(field, value, {}, changed); }

void PropertyForm::dimming(double value, const std::function<void(double)>& changed) {
    auto* line = new QWidget(this);
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* on = new QCheckBox(tr("On"), line);
    on->setObjectName(QStringLiteral("luminaireOn"));
    on->setChecked(value > 0);
    auto* slider = new QSlider(Qt::Horizontal, line);
    slider->setObjectName(QStringLiteral("luminaireDimming"));
    slider->setAccessibleName(tr("Dimming"));
    slider->setRange(0, 100);
    slider->setValue(qRound(100 * value));
    auto* percent = new QLabel(tr("%1 %").arg(slider->value()), line);
    percent->setMinimumWidth(percent->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
    layout->addWidget(on);
    layout->addWidget(slider, 1);
    layout->addWidget(percent);
    rows_->addRow(tr("Dimming"), line);
    connect(on, &QCheckBox::toggled, line, [changed](bool lit) { changed(lit ? 1.0 : 0.0); });
    connect(slider, &QSlider::valueChanged, line, [=](int v) {
        percent->setText(tr("%1 %").arg(v));
        if (!slider->isSliderDown()) changed(v / 100.0);  // by keys or a click beside the handle
    });
    connect(slider, &QSlider::sliderReleased, line, [=] { changed(slider->value() / 100.0); });
}

void PropertyForm::flag(const Field& field, bool value, std::function<void(bool)> changed) {
    auto* box = new QCheckBox(field.label, this);
    box->setObjectName(QString::fromLatin1(field.name));
    box->setChecked(value);
    connect(box, &QCheckBox::toggled, box, std::move(changed));
    rows_->addRow(box);
}

void PropertyForm::choice(const Field& field, const QStringList& choices, const QString& value, std::function<void(const QString&)> changed) {
    auto* box = new QComboBox(this);
    box->setObjectName(QString::fromLatin1(field.name));
    box->addItems(choices);
    if (!choices.contains(value)) box->addItem(value);
    box->setCurrentText(value);
    connect(box, QOverload<int>::of(&QComboBox::activated), box, [box, changed = std::move(changed)](int) { changed(box->currentText()); });
    rows_->addRow(field.label, box);
}

QPushButton* PropertyForm::button(const Field& field, const QString& tip, std::function<void()> pressed) {
    auto* button = new QPushButton(field.label, this);
    button->setObjectName(QString::fromLatin1(field.name));
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, button, std::move(pressed));
    rows_->addRow(button);
    return button;
}

}  // namespace luxdeck::gui

#include "gui/view3d/legend_bar.h"

#include "tonemap/falsecolor.h"
#include "tonemap/isolines.h"

#include <QActionGroup>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr int kWidth = 84;
constexpr int kBarWidth = 16;
constexpr int kLeft = 12;
constexpr int kHead = 52;          // title and unit
constexpr int kFoot = 22;
constexpr double kNumberEvery = 44;  // pixels

}  // namespace

LegendBar::LegendBar(Session& session, QWidget* parent) : QWidget(parent), session_(session), end_(new QDoubleSpinBox(this)) {
    setObjectName(QStringLiteral("legend"));
    setAccessibleName(tr("Legend of all views"));
    setToolTip(tr("The colours of all views. Click the highest or lowest number to set it, anywhere else for more."));
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    end_->setObjectName(QStringLiteral("legendEnd"));
    end_->setRange(0, 1e7);
    end_->setDecimals(1);
    end_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    end_->hide();
    connect(end_, &QDoubleSpinBox::editingFinished, this, &LegendBar::finishEdit);
}

QSize LegendBar::sizeHint() const { return {kWidth, 200}; }

void LegendBar::show(const ResolvedScale& scale, bool radiance) {
    scale_ = scale;
    radiance_ = radiance;
    update();
}

QString LegendBar::unit() const {
    const auto& units = session_.display().units;
    return QString::fromUtf8(radiance_ ? units.luminanceUnit() : units.illuminanceUnit());
}

double LegendBar::shown(double value) const {
    const auto& units = session_.display().units;
    return radiance_ ? units.luminance(value) : units.illuminance(value);
}

double LegendBar::meant(double shown) const { return shown / this->shown(1); }

QRect LegendBar::bar() const { return {kLeft, kHead, kBarWidth, std::max(height() - kHead - kFoot, 20)}; }

std::vector<LegendBar::Tick> LegendBar::ticks() const {
    const LightColours colours(scale_);
    const double low = shown(scale_.low), high = shown(scale_.high);
    const int wanted = std::clamp(static_cast<int>(bar().height() / kNumberEvery), 2, 14);
    std::vector<Tick> ticks;
    for (const double value : tonemap::roundLevels(low, high, wanted, scale_.logarithmic)) ticks.push_back({colours.position(meant(value)), QString::fromStdString(tonemap::labelOf(value))});
    return ticks;
}

QStringList LegendBar::numbers() const {
    QStringList numbers;
    for (const auto& tick : ticks()) numbers << tick.number;
    return numbers;
}

void LegendBar::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().window());
    const QRect box = bar();
    QFont font = painter.font();
    font.setPixelSize(11);
    painter.setFont(font);
    QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(ink);
    painter.drawText(QRect(kLeft, 10, width() - kLeft, 16), Qt::AlignLeft | Qt::AlignVCenter, radiance_ ? tr("Radiance") : tr("Illuminance"));
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.drawText(QRect(kLeft, 26, width() - kLeft, 16), Qt::AlignLeft | Qt::AlignVCenter, unit() + (scale_.logarithmic ? tr("  log") : QString()));
    QLinearGradient gradient(0, box.bottom(), 0, box.top());
    for (int i = 0; i <= 32; ++i) {
        const auto c = tonemap::colourAt(scale_.map, i / 32.0);
        gradient.setColorAt(i / 32.0, QColor(c[0], c[1], c[2]));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(gradient);
    painter.drawRoundedRect(box, 3, 3);
    font.setWeight(QFont::Normal);
    painter.setFont(font);
    for (const auto& tick : ticks()) {
        const double y = box.bottom() + 0.5 - tick.position * (box.height() - 1);
        painter.setPen(QPen(ink, 1));
        painter.drawLine(QPointF(box.right() + 3, y), QPointF(box.right() + 7, y));
        painter.drawText(QRectF(box.right() + 10, y - 8, width() - box.right() - 10, 16), Qt::AlignLeft | Qt::AlignVCenter, tick.number);
    }
}

void LegendBar::mousePressEvent(QMouseEvent* event) {
    const QRect box = bar();
    const int near = std::max(18, box.height() / 12);
    if (event->button() == Qt::LeftButton && std::abs(event->y() - box.top()) < near) return edit(true);
    if (event->button() == Qt::LeftButton && std::abs(event->y() - box.bottom()) < near) return edit(false);
    openMenu(event->globalPos());
}

void LegendBar::edit(bool high) {
    editsHigh_ = high;
    const QRect box = bar();
    end_->setGeometry(box.right() + 4, (high ? box.top() : box.bottom()) - 12, width() - box.right() - 6, 24);
    end_->setValue(shown(high ? scale_.high : scale_.low));
    end_->show();
    end_->setFocus();
    end_->selectAll();
}

void LegendBar::finishEdit() {
    if (!end_->isVisible()) return;
    end_->hide();
    auto display = session_.display();
    auto& legend = display.legend;
    const double value = meant(end_->value());
    if (std::abs(value - (editsHigh_ ? scale_.high : scale_.low)) < 1e-6) return;
    legend.low = editsHigh_ ? scale_.low : value;
    legend.high = editsHigh_ ? value : scale_.high;
    legend.automatic = false;
    if (legend.high > legend.low) session_.setDisplay(display);
}

void LegendBar::openMenu(QPoint at) {
    QMenu menu(this);
    auto display = session_.display();
    auto& legend = display.legend;
    const auto tick = [](QAction* action, bool on) {
        action->setCheckable(true);
        action->setChecked(on);
        return action;
    };
    const auto* automatic = tick(menu.addAction(tr("Range from what is shown")), legend.automatic);
    const auto* logarithmic = tick(menu.addAction(tr("Logarithmic")), legend.logarithmic);
    menu.addSeparator();
    QActionGroup maps(&menu);
    const auto* dusk = maps.addAction(tick(menu.addAction(tr("Dusk: blue to yellow")), legend.map == tonemap::ColourMap::Dusk));
    const auto* heat = maps.addAction(tick(menu.addAction(tr("Heat: black to white")), legend.map == tonemap::ColourMap::Heat));
    const auto* chosen = menu.exec(at);
    if (chosen == nullptr) return;
    if (chosen == automatic) {
        legend.automatic = automatic->isChecked();
        legend.low = scale_.low;
        legend.high = scale_.high;
    }
    if (chosen == logarithmic) legend.logarithmic = logarithmic->isChecked();
    if (chosen == dusk) legend.map = tonemap::ColourMap::Dusk;
    if (chosen == heat) legend.map = tonemap::ColourMap::Heat;
    session_.setDisplay(display);
}

}  // namespace luxdeck::gui

#include "gui/panels/error_plot.h"

#include "analysis/report/compare_drawing.h"
#include "gui/panels/text.h"
#include "gui/session/units.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr double kNearPx = 12;

RunKey keyOf(const ComparedRun& run) { return {run.subject, run.algorithm, run.rung}; }

report::PlotInks inksOf(const QPalette& palette) {
    return {palette.color(QPalette::WindowText), palette.color(QPalette::PlaceholderText), palette.color(QPalette::Mid), palette.color(QPalette::AlternateBase),
            palette.color(QPalette::Base).lightness() < 128};
}

QString percent(double relative, double ci95) { return QObject::tr("%1 %").arg(qt(intervalText(100 * relative, 100 * ci95))); }

QString figuresOf(const ComparedRun& run) {
    auto text = QObject::tr("<b>%1</b>, %2 paths each").arg(qt(run.algorithm)).arg(run.samples);
    text += QStringLiteral("<br>") + (run.rms ? QObject::tr("Error %1").arg(percent(*run.rms, run.rmsCi95)) : QObject::tr("Error at most %1 %").arg(qt(numberText(100 * run.rmsAtMost))));
    text += QStringLiteral("<br>") + (run.bias ? QObject::tr("Bias %1").arg(percent(*run.bias, run.biasCi95)) : QObject::tr("No bias seen"));
    text += QObject::tr("<br>%1 s, of which %2 s to prepare").arg(qt(numberText(run.seconds)), qt(numberText(run.setupSeconds)));
    return text + QObject::tr("<br>Click to see this run");
}

}  // namespace

ErrorPlot::ErrorPlot(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setObjectName(QStringLiteral("errorPlot"));
    setAccessibleName(tr("Error against run time"));
}

void ErrorPlot::show(std::shared_ptr<const Comparison> comparison, const std::string& subject) {
    comparison_ = std::move(comparison);
    subject_ = subject;
    update();
}

void ErrorPlot::pick(const RunKey& run) {
    picked_ = run;
    update();
}

/// The report's sizes of type are for paper held in the hand: a fifth larger on a screen.
double ErrorPlot::dotsPerMm() const { return 1.2 * logicalDpiX() / 25.4; }

QRectF ErrorPlot::areaMm() const {
    const double dots = dotsPerMm();
    return QRectF(3, 2, width() / dots - 6, height() / dots - 4);
}

const ComparedReference* ErrorPlot::reference() const {
    if (!comparison_) return nullptr;
    const auto at = std::find_if(comparison_->reference.begin(), comparison_->reference.end(), [&](const auto& r) { return r.subject == subject_; });
    return at == comparison_->reference.end() ? nullptr : &*at;
}

std::optional<QPointF> ErrorPlot::placeOf(const RunKey& run) const {
    if (const auto* subject = reference())
        for (const auto& plotted : report::plottedRuns(areaMm(), *comparison_, *subject))
            if (keyOf(*plotted.run) == run) return plotted.at * dotsPerMm();
    return std::nullopt;
}

const ComparedRun* ErrorPlot::under(QPointF at) const {
    const auto* subject = reference();
    if (subject == nullptr) return nullptr;
    const ComparedRun* nearest = nullptr;
    double least = kNearPx;
    for (const auto& plotted : report::plottedRuns(areaMm(), *comparison_, *subject)) {
        const auto way = plotted.at * dotsPerMm() - at;
        const double distance = std::hypot(way.x(), way.y());
        if (distance < least) least = distance, nearest = plotted.run;
    }
    return nearest;
}

void ErrorPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const auto* subject = reference();
    if (subject == nullptr || std::none_of(comparison_->runs.begin(), comparison_->runs.end(), [&](const auto& run) { return run.subject == subject_; })) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(20, 0, -20, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         subject == nullptr ? tr("The reference is being measured first; curves begin after it.") : tr("The first runs are on their way."));
        return;
    }
    report::Canvas canvas(painter, dotsPerMm(), font().family());
    report::drawErrorCurves(canvas, areaMm(), *comparison_, *subject, inksOf(palette()));
    if (const auto at = placeOf(picked_)) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(*at, 10, 10);
    }
}

void ErrorPlot::mouseMoveEvent(QMouseEvent* event) { setCursor(under(event->localPos()) != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor); }

void ErrorPlot::mousePressEvent(QMouseEvent* event) {
    if (const auto* run = event->button() == Qt::LeftButton ? under(event->localPos()) : nullptr) emit picked(keyOf(*run));
}

bool ErrorPlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto* run = under(help->pos())) QToolTip::showText(help->globalPos(), figuresOf(*run), this);
    else QToolTip::hideText();
    return true;
}

}  // namespace luxdeck::gui

#include "gui/panels/job_text.h"

#include "gui/panels/text.h"
#include "gui/session/units.h"

#include <QObject>
#include <QProgressBar>

#include <algorithm>

namespace luxdeck::gui {

namespace {
QString duration(double seconds) {
    if (seconds < 90) return QObject::tr("%1 s").arg(static_cast<int>(seconds + 0.5));
    if (seconds < 5400) return QObject::tr("%1 min").arg(static_cast<int>(seconds / 60 + 0.5));
    return QObject::tr("%1 h").arg(seconds / 3600, 0, 'f', 1);
}

constexpr int kSteps = 1000;  // of a bar

/// Of the work, 0..1; below 0: not known.
double fractionOf(const JobState& job) {
    if (job.progress.fraction >= 0) return std::min(1.0, job.progress.fraction);
    if (job.progress.secondsLeft < 0) return -1;
    return job.seconds / std::max(job.seconds + job.progress.secondsLeft, 1e-9);
}
}  // namespace

QString jobText(const JobState& job) {
    auto text = qt(job.title);
    if (job.cancelled) return text + QObject::tr(" · stopping");
    if (!job.progress.stage.empty() && qt(job.progress.stage).compare(text, Qt::CaseInsensitive) != 0) text += QStringLiteral(" · ") + qt(job.progress.stage);
    if (job.progress.errorPercent >= 0) text += QObject::tr(" · error ± %1 %").arg(qt(numberText(job.progress.errorPercent)));
    text += QStringLiteral(" · ") + duration(job.seconds);
    if (job.progress.secondsLeft >= 0) text += QObject::tr(", about %1 left").arg(duration(job.progress.secondsLeft));
    return text;
}

void showProgress(QProgressBar& bar, const JobState& job) {
    const double fraction = fractionOf(job);
    bar.setRange(0, fraction < 0 ? 0 : kSteps);
    bar.setValue(static_cast<int>(kSteps * std::max(0.0, fraction)));
}

}  // namespace luxdeck::gui

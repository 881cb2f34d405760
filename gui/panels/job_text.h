#pragma once

#include "gui/session/jobs.h"

#include <QString>

class QProgressBar;

namespace luxdeck::gui {

/// "Solving · 3.2 % · 4 s, about 12 s left": what is known of a job, in a line.
QString jobText(const JobState& job);

/// As much of the bar as of the work is done (as the time left says, where the work itself does not tell); it swings while
/// that is not known.
void showProgress(QProgressBar& bar, const JobState& job);

}  // namespace luxdeck::gui

#pragma once

#include "gui/session/jobs.h"

#include <QString>

namespace luxdeck::gui {

/// "Solving · 3.2 % · 4 s, about 12 s left": what is known of a job, in a line.
QString jobText(const JobState& job);

/// Of the work, 0..1; from the time that is left where the work itself does not tell; below 0: not known.
double fractionOf(const JobState& job);

}  // namespace luxdeck::gui

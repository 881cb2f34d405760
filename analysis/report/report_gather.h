#pragma once

#include "analysis/report/report_contents.h"

#include <optional>
#include <string>

namespace luxdeck {

/// Everything of the report that follows from the project and what was solved: schedule, materials, plan,
/// floor area, machine. The caller adds views and the method's text.
///
/// created  of the report, "2026-11-22T18:40:00Z"; given, so that the same input gives the same report
ReportContents gatherReport(const Project& project, SolveResult solve, std::string created);

/// The floor's area: the level faces of objects with "floor" in their name, seen from above [m^2]; none
/// when there is no such object.
std::optional<double> floorArea(const Scene& scene);

}  // namespace luxdeck

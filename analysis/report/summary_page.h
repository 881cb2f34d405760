#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// How many of the asked-for statistics are met, not met and undecided.
struct VerdictCount {
    int met = 0, notMet = 0, undecided = 0;

    static VerdictCount of(const SolveResult& solve);
    [[nodiscard]] int asked() const { return met + notMet + undecided; }
};

/// The requirements with their verdicts, and every surface's statistics.
void drawSummary(Document& document);

/// The key a surface's page is remembered by.
std::string gridKey(std::size_t index);

}  // namespace luxdeck::report

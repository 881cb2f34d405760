#include "analysis/grids/solve_result.h"

#include <optional>

namespace luxdeck {

const char* verdictText(Verdict verdict) {
    switch (verdict) {
        case Verdict::None: return "";
        case Verdict::Met: return "met";
        case Verdict::NotMet: return "not met";
        case Verdict::Undecided: return "undecided";
    }
    return "";
}

Verdict judge(const Interval& value, std::optional<double> required) {
    if (!required) return Verdict::None;
    if (value.low() >= *required) return Verdict::Met;
    if (value.high() < *required) return Verdict::NotMet;
    return Verdict::Undecided;
}

}  // namespace luxdeck

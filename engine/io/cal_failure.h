#pragma once

#include "engine/io/cal_evaluate.h"

#include <string_view>

namespace luxdeck::cal {

/// The rest of a sentence that begins with what was evaluated.
inline std::string_view meaning(Failure failure) {
    switch (failure) {
        case Failure::None: return "has a value";
        case Failure::NoValue: return "has no value: a division by zero, or a function outside of where it is defined";
        case Failure::MissingArgument: return "asks for a real argument that is not given";
        case Failure::NotAFunction: return "calls a parameter for which no function is given";
        case Failure::TooFewArguments: return "calls a function with too few arguments";
        case Failure::TooDeep: return "calls functions within functions without end (more than 4000 steps deep)";
        case Failure::TooLong: return "takes more than 1000000 steps: it does not end";
    }
    return "has no value";
}

}  // namespace luxdeck::cal

#pragma once

#include "engine/core/progress.h"

namespace luxdeck::cli {

/// While alive, Ctrl-C and SIGTERM cancel the work, which then keeps what it has; a second one ends the
/// process at once. A closed pipe is an error of the write, not the end of the process.
class InterruptGuard {
public:
    explicit InterruptGuard(Progress& progress);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

}  // namespace luxdeck::cli

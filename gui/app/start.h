#pragma once

namespace luxdeck::gui {

/// Runs the desktop program. Exit status as of the command line.
int run(int argc, char** argv);

}  // namespace luxdeck::gui

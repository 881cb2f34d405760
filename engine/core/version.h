#pragma once

namespace luxdeck {

/// As `luxdeck --version` and every record print it; CMake checks that it is the project's version.
inline constexpr const char* kVersion = "0.1.0";

}  // namespace luxdeck

#pragma once

#include <string>

namespace luxdeck::cli {

/// Puts something unusable behind a standard stream that the caller has closed. Otherwise the next file
/// opened would get its number, and a message meant for stdout would land in a picture.
void occupyClosedStreams();

/// Text on stderr. That nobody reads it any more (a closed pipe) is no reason to stop.
void say(const std::string& text);

}  // namespace luxdeck::cli

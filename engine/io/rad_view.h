#pragma once

#include "engine/core/result.h"
#include "engine/io/project.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace luxdeck {

/// A Radiance view file (.vf), or any text with view options (`rvu -vtv -vp ...`, `VIEW= -vtv ...`). Later options
/// replace earlier ones, as Radiance reads them. Lengths are the scene's, metres. The picture is as high as
/// View's own default and as wide as the view's angles ask for.
///
/// text    of the file; `where` names it in messages
/// errors  Parse (no view, a number missing), Unsupported (-vth, -vtl, -vtc, -vts, shift and lift, clipping planes,
///         an angular fisheye of other than 180 degrees), InvalidArgument (no direction, angles out of range)
Result<View> parseView(std::string_view text, const std::string& where);
Result<View> readView(const std::filesystem::path& file);

/// The line of a view file for a view: `rvu -vtv -vp ...`.
std::string viewLine(const View& view);

}  // namespace luxdeck

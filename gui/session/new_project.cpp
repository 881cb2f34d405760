#include "gui/session/new_project.h"

#include "engine/core/file.h"
#include "engine/io/project.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck::gui {

namespace fs = std::filesystem;

namespace {

constexpr double kWorkplaneM = 0.75, kEyeM = 1.6, kBorderM = 0.5;

/// As TOML writes a text between quotes.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        else out += c;
    }
    return out + '"';
}

std::string vectorText(double x, double y, double z) { return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", x, y, z); }

}  // namespace

Result<std::string> firstProjectText(const fs::path& geometry, const fs::path& folder, const std::string& name) {
    const auto model = loadProject(geometry);
    if (!model) return model.error();
    const auto box = model->scene.bounds();
    if (box.isEmpty()) return Error{ErrorCode::InvalidArgument, "has no geometry, expected triangles", geometry.string()};
    const Vec3d low = model->scene.toUser(box.min), high = model->scene.toUser(box.max);
    const Vec3d size = high - low;
    const auto below = fs::proximate(geometry, folder);
    const bool beside = !below.empty() && *below.begin() != "..";
    const double border = std::min(kBorderM, 0.2 * std::min(size.x, size.y));
    const double plane = low.z + std::min(kWorkplaneM, 0.5 * size.z), eye = low.z + std::min(kEyeM, 0.6 * size.z);
    const bool obj = lowerExtension(geometry) == ".obj";

    std::string text = "schema = \"luxdeck-project/1\"\n\n";
    text += fmt::format("[project]\nname = {}\n\n", quoted(name));
    text += fmt::format("[[geometry]]\nfile = {}\n{}\n", quoted((beside ? below : fs::absolute(geometry)).generic_string()),
                        obj ? "unit = \"m\"  # an OBJ file does not say: change it here if it is another\nup = \"y\"\n" : "");
    text += fmt::format("[[grid]]\nname = \"Workplane\"\norigin = {}\nu = {}\nv = {}\nborder = {:.3f}\n\n", vectorText(low.x, low.y, plane),
                        vectorText(size.x, 0, 0), vectorText(0, size.y, 0), border);
    text += fmt::format("[[view]]\nname = \"corner\"\nposition = {}\ntarget = {}\nvertical_fov_deg = 60\nsize = [1200, 800]\n\n",
                        vectorText(low.x + 0.08 * size.x, low.y + 0.08 * size.y, eye), vectorText(low.x + 0.6 * size.x, low.y + 0.6 * size.y, low.z + 0.4 * size.z));
    text += "[[volume]]\nname = \"room\"\n";
    const Vec3d inset = size * 0.02;
    text += fmt::format("min = {}\nmax = {}\n", vectorText(low.x + inset.x, low.y + inset.y, low.z + inset.z), vectorText(high.x - inset.x, high.y - inset.y, high.z - inset.z));
    return text;
}

}  // namespace luxdeck::gui

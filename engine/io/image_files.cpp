#include "engine/io/image_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace luxdeck {

Result<Image> readHdrImage(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".exr") return readExr(path);
    for (const char* radiance : {".hdr", ".pic", ".rgbe", ".xyze"})
        if (extension == radiance) return readRgbe(path);
    return Error{ErrorCode::Unsupported,
                 fmt::format("a picture of kind '{}', expected .exr, .hdr, .pic, .rgbe or .xyze", extension),
                 path.string()};
}

}  // namespace luxdeck

#include "engine/io/image_files.h"

#include "engine/core/file.h"

#include <fmt/format.h>

namespace luxdeck {

Result<Image> readHdrImage(const std::filesystem::path& path) {
    const auto extension = lowerExtension(path);
    if (extension == ".exr") return readExr(path);
    for (const char* radiance : {".hdr", ".pic", ".rgbe", ".xyze"})
        if (extension == radiance) return readRgbe(path);
    return Error{ErrorCode::Unsupported,
                 fmt::format("a picture of kind '{}', expected .exr, .hdr, .pic, .rgbe or .xyze", extension),
                 path.string()};
}

}  // namespace luxdeck

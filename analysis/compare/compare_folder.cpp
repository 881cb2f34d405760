#include "analysis/compare/compare_folder.h"

#include "analysis/compare/compare_output.h"
#include "engine/core/file.h"
#include "engine/io/image_files.h"

#include <fmt/format.h>

namespace luxdeck {

std::string fileNameOf(std::string text) {
    for (auto& c : text)
        if (c == '/' || c == '\\' || static_cast<unsigned char>(c) <= ' ') c = '-';
    return text;
}

Result<void> writeComparison(const Comparison& comparison, const std::filesystem::path& folder) {
    if (auto ok = writeFileAtomically(folder / "compare.json", compareJson(comparison)); !ok) return ok;
    if (auto ok = writeFileAtomically(folder / "runs.csv", runsCsv(comparison)); !ok) return ok;
    if (auto ok = writeFileAtomically(folder / "errors.csv", errorsCsv(comparison)); !ok) return ok;
    for (const auto& map : comparison.maps) {
        if (!map.grid.empty()) continue;  // these are in the plans
        const auto picture = errorPicture(map, errorRange(comparison, map.subject), map.algorithm);
        if (!picture) return picture.error();
        if (auto ok = writePng(folder / fmt::format("errors-{}-{}.png", fileNameOf(map.subject), map.algorithm), *picture); !ok) return ok;
    }
    return {};
}

}  // namespace luxdeck

#include "engine/io/photometry.h"

#include "engine/core/file.h"
#include "engine/io/photometry_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck {
namespace {

using namespace photometry;

/// The largest measured files are a few megabytes; more is not photometry.
constexpr std::uint64_t kMostBytes = 64ULL << 20;

/// LM-63 has a line that starts with TILT; EULUMDAT's second and third lines are small whole numbers.
bool looksLikeIes(const std::vector<std::string_view>& lines) {
    return std::any_of(lines.begin(), lines.end(), [](std::string_view line) {
        const std::string start = upperCase(trim(line).substr(0, 5));
        return start == "TILT=" || start == "TILT ";
    });
}

bool looksLikeEulumdat(const std::vector<std::string_view>& lines) {
    if (lines.size() < 30) return false;
    const auto symmetry = parseNumber(trim(lines[2]));
    const auto planes = parseNumber(trim(lines[3]));
    return symmetry && planes && *symmetry >= 0 && *symmetry <= 4 && *planes >= 1;
}

}  // namespace

Result<Photometry> loadPhotometry(const std::filesystem::path& path) {
    const auto bytes = readFile(path, kMostBytes);
    if (!bytes) return bytes.error();
    const std::string extension = upperCase(path.extension().string());
    if (extension == ".IES") return readIes(*bytes, path);
    if (extension == ".LDT" || extension == ".EUL") return readEulumdat(*bytes, path);

    std::vector<std::string> repairs;
    const auto text = decodeText(*bytes, path, repairs);
    if (!text) return text.error();
    const auto lines = splitLines(*text);
    if (looksLikeIes(lines)) return readIes(*bytes, path);
    if (looksLikeEulumdat(lines)) return readEulumdat(*bytes, path);
    return Error{ErrorCode::Unsupported, "neither an IES LM-63 nor an EULUMDAT file", path.string()};
}

}  // namespace luxdeck

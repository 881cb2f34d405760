#include "engine/io/photometry.h"

#include "engine/core/file.h"
#include "engine/io/photometry_text.h"

#include <fmt/format.h>

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
    std::vector<std::string> repairs;
    const auto text = decodeText(*bytes, path, repairs);
    if (!text) return text.error();
    const auto lines = splitLines(*text);
    const bool ies = looksLikeIes(lines), eulumdat = looksLikeEulumdat(lines);
    const std::string extension = upperCase(path.extension().string());
    const bool namedIes = extension == ".IES", namedEulumdat = extension == ".LDT" || extension == ".EUL";
    if (!ies && !eulumdat && trim(*text).starts_with('<'))  // neither format begins so
        return errorAt(path, 1, fmt::format("begins with {}: a web page or XML (TM-33), expected an IES LM-63 or an "
                                            "EULUMDAT file", inQuotes(trim(*text).substr(0, 20))));
    const bool swapped = (namedIes && eulumdat && !ies) || (namedEulumdat && ies && !eulumdat);
    if (!swapped && namedIes) return readIes(*bytes, path);
    if (!swapped && namedEulumdat) return readEulumdat(*bytes, path);
    if (!ies && !eulumdat)
        return Error{ErrorCode::Unsupported, "neither an IES LM-63 nor an EULUMDAT file", path.string()};
    auto photometry = ies ? readIes(*bytes, path) : readEulumdat(*bytes, path);
    if (photometry && swapped)
        photometry->warnings.push_back(fmt::format("its name ends with {}, but it holds {}: read as that",
                                                   path.extension().string(), ies ? "IES LM-63" : "EULUMDAT"));
    return photometry;
}

}  // namespace luxdeck

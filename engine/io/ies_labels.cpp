#include "engine/io/ies_labels.h"

#include "engine/io/photometry_text.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace luxdeck::photometry {
namespace {

/// The edition from the first line; nothing if it is no edition's.
std::optional<int> editionOf(std::string_view firstLine) {
    const std::string tag = upperCase(trim(firstLine));
    if (!tag.starts_with("IES")) return std::nullopt;
    constexpr std::pair<const char*, int> kEditions[] = {
        {"2019", 2019}, {"2002", 2002}, {"95", 1995}, {"91", 1991}, {"86", 1986}};
    for (const auto& [digits, year] : kEditions) {
        if (tag.find(digits) != std::string::npos) return year;
    }
    return std::nullopt;
}

/// "TILT = NONE" in any case and spacing: what follows the equals sign.
std::optional<std::string> tiltOf(std::string_view line) {
    line = trim(line);
    if (upperCase(line.substr(0, 4)) != "TILT") return std::nullopt;
    line = trim(line.substr(4));
    if (line.empty() || line.front() != '=') return std::nullopt;
    return std::string(trim(line.substr(1)));
}

void readLabel(std::string_view line, Labels& labels, std::string& lastKey) {
    line = trim(line);
    const auto close = line.find(']');
    if (line.empty()) return;
    if (line.front() != '[' || close == std::string_view::npos) {
        if (labels.freeText.empty()) labels.freeText = line;
        return;
    }
    const std::string key = upperCase(trim(line.substr(1, close - 1)));
    const std::string value(trim(line.substr(close + 1)));
    if (key == "MORE") {
        if (!lastKey.empty() && !value.empty()) labels.values[lastKey] += " " + value;
        return;
    }
    lastKey = key;
    labels.values.emplace(key, value);
}

}  // namespace

Result<Labels> readLabels(const std::vector<std::string_view>& lines, const std::filesystem::path& name,
                          Photometry& p) {
    Labels labels;
    std::size_t i = 0;
    while (i < lines.size() && trim(lines[i]).empty()) ++i;
    const auto edition = i < lines.size() ? editionOf(lines[i]) : std::nullopt;
    labels.year = edition.value_or(1986);
    labels.format = fmt::format("LM-63-{}", labels.year);
    if (edition) {
        ++i;
    } else if (upperCase(trim(lines[i])).starts_with("IES")) {
        p.warnings.push_back(fmt::format("line {}: {} is no known edition of LM-63; read by the rules of 1986", i + 1,
                                         inQuotes(trim(lines[i]))));
        ++i;
    }
    std::string lastKey;
    for (; i < lines.size(); ++i) {
        if (auto tilt = tiltOf(lines[i])) {
            labels.tiltLine = i;
            labels.tilt = std::move(*tilt);
            return labels;
        }
        readLabel(lines[i], labels, lastKey);
    }
    return errorAt(name, lines.size(), "the file ends here, expected a line TILT=NONE, TILT=INCLUDE or TILT=file");
}

std::string firstOf(const Labels& labels, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        const auto found = labels.values.find(key);
        if (found != labels.values.end() && !found->second.empty()) return found->second;
    }
    return {};
}

}  // namespace luxdeck::photometry

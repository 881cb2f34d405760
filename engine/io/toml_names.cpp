#include "engine/io/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace luxdeck {

namespace {

constexpr std::size_t kMaxListed = 12;   // more names than this do not help in a message

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Edits (insert, remove, replace, case aside) that make b of a. Source: Levenshtein 1966, two-row form.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row[b.size()];
}

std::string listed(const std::vector<std::string>& names, std::string_view lastSeparator) {
    std::string text;
    const auto count = std::min(names.size(), kMaxListed);
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) text += i + 1 == count ? lastSeparator : ", ";
        text += inQuotes(names[i]);
    }
    if (names.size() > count) text += fmt::format(" and {} more", names.size() - count);
    return text;
}

}  // namespace

std::vector<std::string> nearestNames(std::string_view seen, const std::vector<std::string>& candidates,
                                      std::size_t count) {
    // A third of the letters wrong, and two at least, is still a slip; beyond that it is another word.
    const std::size_t allowed = std::max<std::size_t>(2, seen.size() / 3);
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const auto& candidate : candidates) {
        const auto longer = std::max(seen.size(), candidate.size());
        if (longer - std::min(seen.size(), candidate.size()) > allowed) continue;  // also bounds the work
        if (longer > 1000) continue;
        const auto distance = editDistance(seen, candidate);
        if (distance <= allowed && distance < longer) near.emplace_back(distance, candidate);
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(count, near.size()); ++i) names.push_back(near[i].second);
    return names;
}

std::string suggestion(std::string_view seen, const std::vector<std::string>& candidates) {
    const auto near = nearestNames(seen, candidates);
    if (!near.empty()) return fmt::format("did you mean {}?", listed(near, " or "));
    if (candidates.empty()) return "there are none";
    return fmt::format("known are {}", listed(candidates, ", "));
}

std::string inQuotes(std::string_view text, std::size_t mostBytes) {
    if (text.size() <= mostBytes) return fmt::format("\"{}\"", text);
    auto end = mostBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a UTF-8 letter
    return fmt::format("\"{}...\"", text.substr(0, end));
}

}  // namespace luxdeck

#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace luxdeck {

/// What a reader repaired or left out, each thing said once with how often it happened, in the order of
/// its first time: a million alike faces give one line, not a million.
class WarningList {
public:
    /// `key` tells alike warnings apart from others; `text` is what the first of them says.
    void add(const std::string& key, const std::string& text) {
        const auto [at, isNew] = index_.try_emplace(key, lines_.size());
        if (isNew) lines_.emplace_back(text, 0);
        ++lines_[at->second].second;
    }
    void add(const std::string& text) { add(text, text); }

    [[nodiscard]] std::vector<std::string> texts() const {
        std::vector<std::string> result;
        for (const auto& [text, count] : lines_)
            result.push_back(count == 1 ? text : text + " (and " + std::to_string(count - 1) + " more)");
        return result;
    }

private:
    std::unordered_map<std::string, std::size_t> index_;
    std::vector<std::pair<std::string, std::size_t>> lines_;
};

}  // namespace luxdeck

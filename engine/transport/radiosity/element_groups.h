#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace luxdeck {

/// Which elements exchange light, by whatever way round: each group goes by the smallest index in it.
class ElementGroups {
public:
    explicit ElementGroups(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0U); }

    [[nodiscard]] std::uint32_t of(std::uint32_t i) {
        while (above_[i] != i) i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = of(a), b = of(b);
        above_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> above_;  // of the same group, never larger
};

}  // namespace luxdeck

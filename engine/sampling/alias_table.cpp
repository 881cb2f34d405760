#include "engine/sampling/alias_table.h"

#include <algorithm>
#include <numeric>

namespace luxdeck {

AliasTable::AliasTable(std::span<const double> weights) : entries_(weights.size()) {
    const auto n = weights.size();
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<double> scaled(n);
    std::vector<std::uint32_t> small, large;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double p = sum > 0 ? weights[i] / sum : 1.0 / static_cast<double>(n);
        entries_[i] = {1.0F, i, static_cast<float>(p)};
        scaled[i] = p * static_cast<double>(n);
        (scaled[i] < 1 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const auto less = small.back(), more = large.back();
        small.pop_back();
        entries_[less].keep = static_cast<float>(scaled[less]);
        entries_[less].alias = more;
        scaled[more] -= 1 - scaled[less];
        if (scaled[more] < 1) {
            large.pop_back();
            small.push_back(more);
        }
    }  // what is left is 1 up to rounding and keeps itself
}

AliasTable::Draw AliasTable::draw(float u) const {
    const float x = u * static_cast<float>(entries_.size());
    const auto slot = std::min(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(entries_.size() - 1));
    const float fraction = std::min(x - static_cast<float>(slot), 0x1.fffffep-1F);
    const auto& e = entries_[slot];
    if (fraction < e.keep) return {slot, e.probability, std::min(fraction / e.keep, 0x1.fffffep-1F)};
    return {e.alias, entries_[e.alias].probability, std::min((fraction - e.keep) / (1 - e.keep), 0x1.fffffep-1F)};
}

}  // namespace luxdeck

#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// Draws an index with given probabilities in constant time. Source: Vose 1991.
class AliasTable {
public:
    AliasTable() = default;
    /// weights  #N, finite, >= 0; all zero: uniform
    explicit AliasTable(std::span<const double> weights);

    struct Draw {
        std::uint32_t index;
        float probability;
        float rest;  ///< what is left of u, uniform in [0, 1)
    };
    [[nodiscard]] Draw draw(float u) const;
    [[nodiscard]] float probability(std::uint32_t index) const { return entries_[index].probability; }
    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        float keep;           // chance of keeping this index when its slot is drawn
        std::uint32_t alias;  // the index to take else
        float probability;
    };
    std::vector<Entry> entries_;
};

}  // namespace luxdeck

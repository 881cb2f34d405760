#pragma once

#include "engine/core/rng.h"
#include "engine/core/vec.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace luxdeck {

/// Where records reach to: cells of size 2^level metres, hashed, each record in the cells of the level at which its ball
/// overlaps at most eight. Looking up takes one probe a level that is in use; nothing is allocated.
class RecordGrid {
public:
    RecordGrid() { slots_.resize(64); }

    /// reach  > 0 [m]
    void insert(std::uint32_t record, const Vec3& position, float reach);

    /// Calls f(record) for every record whose ball may hold the position, newest first.
    template <class F>
    void forEachNear(const Vec3& position, F&& f) const {
        for (const int level : levels_)
            for (auto node = slots_[slotOf(key(cellOf(position, level), level))].first; node != kEnd; node = nodes_[node].next) f(nodes_[node].record);
    }
    [[nodiscard]] std::size_t bytes() const { return slots_.capacity() * sizeof(Slot) + nodes_.capacity() * sizeof(Node); }

private:
    static constexpr std::uint32_t kEnd = 0xffffffffU;
    struct Slot {
        std::uint64_t key = 0;        // 0: empty
        std::uint32_t first = kEnd;   // newest node
    };
    struct Node {
        std::uint32_t record, next;
    };
    struct Cell {
        std::int64_t x, y, z;
    };
    static Cell cellOf(const Vec3& p, int level) {
        const float scale = std::ldexp(1.0F, -level);
        const auto at = [&](float c) { return static_cast<std::int64_t>(std::floor(c * scale)); };
        return {at(p.x), at(p.y), at(p.z)};
    }
    /// Two cells with one key would only cost time: records are weighed by their own place.
    static std::uint64_t key(const Cell& c, int level) {
        std::uint64_t h = mix64(static_cast<std::uint64_t>(c.x) + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(level + 4096));
        h = mix64(h ^ (static_cast<std::uint64_t>(c.y) * 0xd1342543de82ef95ULL));
        return mix64(h ^ (static_cast<std::uint64_t>(c.z) * 0xaf251af3b0f025b5ULL)) | 1U;
    }
    /// Of the slot that has the key, or the empty one where it would be.
    [[nodiscard]] std::size_t slotOf(std::uint64_t key) const {
        std::size_t i = (key >> 1) & (slots_.size() - 1);
        while (slots_[i].key != 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
        return i;
    }
    void grow();

    std::vector<Slot> slots_;  // a power of two, at most half full
    std::vector<Node> nodes_;
    std::vector<int> levels_;  // in use
    std::size_t used_ = 0;
};

}  // namespace luxdeck

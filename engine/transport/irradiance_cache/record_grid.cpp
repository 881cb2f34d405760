#include "engine/transport/irradiance_cache/record_grid.h"

#include <algorithm>
#include <utility>

namespace luxdeck {

void RecordGrid::insert(std::uint32_t record, const Vec3& position, float reach) {
    const int level = static_cast<int>(std::ceil(std::log2(2 * reach)));
    if (std::find(levels_.begin(), levels_.end(), level) == levels_.end()) levels_.push_back(level);
    const Vec3 all(reach, reach, reach);
    const auto low = cellOf(position - all, level), high = cellOf(position + all, level);
    for (auto x = low.x; x <= high.x; ++x)
        for (auto y = low.y; y <= high.y; ++y)
            for (auto z = low.z; z <= high.z; ++z) {
                if (2 * (used_ + 1) > slots_.size()) grow();
                const auto k = key({x, y, z}, level);
                auto& slot = slots_[slotOf(k)];
                if (slot.key == 0) slot.key = k, ++used_;
                nodes_.push_back({record, slot.first});
                slot.first = static_cast<std::uint32_t>(nodes_.size() - 1);
            }
}

void RecordGrid::grow() {
    const auto before = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    for (const auto& slot : before)
        if (slot.key != 0) slots_[slotOf(slot.key)] = slot;
}

}  // namespace luxdeck

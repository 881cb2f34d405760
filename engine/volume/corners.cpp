#include "engine/volume/corners.h"

#include <algorithm>

namespace luxdeck {

std::size_t usableAround(const IrradianceVolume& volume, std::uint32_t cell, std::array<std::uint32_t, 216>& found) {
    const auto& lattice = volume.lattice;
    const auto box = lattice.box(cell);
    const Vec3 middle = (box.min + box.max) * 0.5F, side = box.max - box.min;
    auto end = found.begin();
    for (int i = 0; i < 27; ++i) {
        const Vec3 step(static_cast<float>(i % 3 - 1), static_cast<float>(i / 3 % 3 - 1), static_cast<float>(i / 9 - 1));
        for (const auto v : lattice.cells()[lattice.locate(middle + side * step).cell].vertices)
            if (volume.quality[v].usable()) *end++ = v;
    }
    std::sort(found.begin(), end);
    return static_cast<std::size_t>(std::unique(found.begin(), end) - found.begin());
}

}  // namespace luxdeck

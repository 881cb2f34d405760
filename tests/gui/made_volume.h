#pragma once

#include "gui/session/volumes.h"

#include <functional>
#include <memory>
#include <string>

namespace luxdeck::gui::test {

/// A volume of 2 x 2 x 2 vertices over a cube of 2 m about the origin, in nobody's room, whose radiance in each direction
/// (grey, direct light) is told.
inline VolumeState madeVolume(const std::string& name, const std::function<float(const Vec3&)>& radiance, int side = 9) {
    auto volume = std::make_shared<IrradianceVolume>();
    volume->settings.side = side;
    volume->lattice = *Lattice::create(Box3(Vec3(-1), Vec3(1)), {1, 1, 1}, 2, 0);
    const std::size_t vertices = volume->vertexCount(), bins = volume->binCount();
    volume->occupied.assign(volume->lattice.cells().size(), 0);
    for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t bin = 0; bin < bins; ++bin) volume->direct.emplace_back(radiance(volume->bins().centre(static_cast<int>(bin))));
    volume->indirect.resize(vertices * bins);
    volume->sources.resize(vertices);
    VertexQuality quality;
    quality.samples = 4;
    volume->quality.assign(vertices, quality);
    return {name, {}, volume, nullptr, {}, true};
}

}  // namespace luxdeck::gui::test

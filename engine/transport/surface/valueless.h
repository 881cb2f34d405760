#pragma once

#include "engine/scene/scene.h"

namespace luxdeck {

/// What a surface without a value reflects at most: as much as the whitest paint, alike in all directions. Light that was
/// followed beyond it bounds what is missing (docs/decisions/0011-failed-samples.md).
inline const Material& valuelessMaterial() {
    static const Material whitest = [] {
        Material m;
        m.reflectance = Rgb(0.9F);
        return m;
    }();
    return whitest;
}

}  // namespace luxdeck

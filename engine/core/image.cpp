#include "engine/core/image.h"

namespace luxdeck {

std::vector<Rgb> colours(const Image& image) {
    std::vector<Rgb> out(image.pixelCount());
    if (image.hasColour()) {
        const auto &r = image.channel("R"), &g = image.channel("G"), &b = image.channel("B");
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = {r[i], g[i], b[i]};
    } else if (image.has("Y")) {
        const auto& y = image.channel("Y");
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = Rgb(y[i]);
    }
    return out;
}

}  // namespace luxdeck

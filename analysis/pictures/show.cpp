#include "analysis/pictures/show.h"

#include "tonemap/display_transform.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <sstream>

namespace luxdeck {

namespace {

/// The white of the light sources, from the picture's header; none when it is neutral or not told.
std::optional<Rgb> adoptedWhite(const Image& image) {
    const auto at = image.text.find("luxdeck:adoptedWhite");
    if (at == image.text.end()) return std::nullopt;
    std::istringstream in(at->second);
    Rgb white;
    if (!(in >> white.r >> white.g >> white.b) || !isFinite(white) || !(white.min() > 0)) return std::nullopt;
    return white.isGrey() ? std::nullopt : std::optional(white);
}

/// Divides by the white, its luminance being 1 (docs/decisions/0005-adopted-white.md).
Image adapted(Image image, const Rgb& white) {
    for (auto& x : image.channel("R")) x /= white.r;
    for (auto& x : image.channel("G")) x /= white.g;
    for (auto& x : image.channel("B")) x /= white.b;
    return image;
}

}  // namespace

Result<Shown> show(const Image& scene, const tonemap::ToneMapSettings& settings, const ShowSettings& how) {
    const auto white = how.whiteBalance && scene.hasColour() ? adoptedWhite(scene) : std::nullopt;
    auto mapped = tonemap::toneMap(white ? adapted(scene, *white) : scene, settings);
    if (!mapped) return mapped.error();
    tonemap::DisplayTransformSettings display;
    display.display = how.ocioDisplay, display.view = how.ocioView;
    const char* own = std::getenv("OCIO");
    if (how.ocioView.empty() && (own == nullptr || *own == 0)) display.view = tonemap::kToneMappedView;
    auto transform = tonemap::DisplayTransform::create(display);
    if (!transform) return transform.error();
    auto image = transform->apply(mapped->image);
    if (!image) return image.error();
    Shown shown{*std::move(image), mapped->record,
                fmt::format("{}, {}, {}", transform->configName(), transform->display(), transform->view())};
    shown.image.text.merge(tonemap::headerText(mapped->record));
    shown.image.text["luxdeck:displayTransform"] = shown.transform;
    shown.image.text["luxdeck:whiteBalance"] = white ? "adapted to the light sources' white" : "none";
    return shown;
}

std::string operatorText(const tonemap::ToneMapRecord& r) {
    std::string text = fmt::format("{} tone mapping ({}): {:.3g} to {:.3g} cd/m² shown on {:g} to {:g} cd/m².", name(r.op), r.mapping,
                                   r.worldMinCdM2, r.worldMaxCdM2, r.display.minCdM2, r.display.maxCdM2);
    for (const auto& e : r.effects) text += fmt::format(" {} {}: {}.", e.effect, e.applied ? "applied" : "not applied", e.why);
    return text;
}

}  // namespace luxdeck

#include "cli/tone.h"

#include "tonemap/display_transform.h"

#include <fmt/format.h>

#include <cstdlib>

namespace luxdeck::cli {

Result<Shown> show(const Image& scene, const tonemap::ToneMapSettings& settings, const std::string& ocioView) {
    auto mapped = tonemap::toneMap(scene, settings);
    if (!mapped) return mapped.error();
    tonemap::DisplayTransformSettings display;
    display.view = ocioView;
    const char* own = std::getenv("OCIO");
    if (ocioView.empty() && (own == nullptr || *own == 0)) display.view = tonemap::kToneMappedView;
    auto transform = tonemap::DisplayTransform::create(display);
    if (!transform) return transform.error();
    auto image = transform->apply(mapped->image);
    if (!image) return image.error();
    Shown shown{*std::move(image), mapped->record,
                fmt::format("{}, {}, {}", transform->configName(), transform->display(), transform->view())};
    shown.image.text.merge(tonemap::headerText(mapped->record));
    shown.image.text["luxdeck:displayTransform"] = shown.transform;
    return shown;
}

std::string operatorText(const tonemap::ToneMapRecord& r) {
    std::string text = fmt::format("{} tone mapping ({}): {:.3g} to {:.3g} cd/m² shown on {:g} to {:g} cd/m².", name(r.op), r.mapping,
                                   r.worldMinCdM2, r.worldMaxCdM2, r.display.minCdM2, r.display.maxCdM2);
    for (const auto& e : r.effects) text += fmt::format(" {} {}: {}.", e.effect, e.applied ? "applied" : "not applied", e.why);
    return text;
}

}  // namespace luxdeck::cli

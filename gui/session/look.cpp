#include "gui/session/look.h"

#include <utility>

namespace luxdeck::gui {

namespace {

Result<void> addFalseColour(const Image& picture, const tonemap::Field& field, const Look& look, Developed& out) {
    const auto quantity = picture.text.find("luxdeck:quantity");
    const bool illuminance = quantity != picture.text.end() && quantity->second == "illuminance";
    tonemap::FalseColourSettings settings;
    settings.map = look.map;
    settings.logarithmic = look.logarithmic;
    settings.range = out.range;
    settings.quantity = illuminance ? "Illuminance" : "Luminance";
    settings.unit = illuminance ? "lx" : "cd/m²";
    settings.legend = look.legend;
    if (look.isolines) settings.isolines.emplace();
    auto coloured = tonemap::falseColour(field, settings);
    if (!coloured) return coloured.error();
    out.image = *std::move(coloured);
    return {};
}

Result<void> addToneMapped(const Image& picture, const tonemap::Field& field, const Look& look, Developed& out) {
    auto shown = show(picture, look.tone, look.how);
    if (!shown) return shown.error();
    out.image = std::move(shown->image);
    out.record = std::move(shown->record);
    out.transform = std::move(shown->transform);
    return look.isolines ? tonemap::drawIsolines(out.image, field, {}, look.logarithmic) : Result<void>{};
}

}  // namespace

Result<Developed> develop(const Image& picture, const Look& look) {
    const auto field = tonemap::luminanceField(picture);
    if (!field) return field.error();
    Developed out;
    out.range = look.range.value_or(tonemap::roundedRange(*field, look.logarithmic));
    out.histogram = tonemap::logHistogram(field->values);
    const auto done = look.falseColour ? addFalseColour(picture, *field, look, out) : addToneMapped(picture, *field, look, out);
    if (!done) return done.error();
    return out;
}

}  // namespace luxdeck::gui

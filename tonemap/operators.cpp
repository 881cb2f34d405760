#include "tonemap/operators.h"

#include "engine/core/parallel.h"
#include "tonemap/acuity.h"
#include "tonemap/adaptation.h"
#include "tonemap/foveal_image.h"
#include "tonemap/mesopic.h"
#include "tonemap/veil.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

constexpr double kAutomaticGrey = 0.18;   // where a photographer's meter puts the mean of a scene
constexpr int kCurvePoints = 64;
constexpr std::array kOperators{std::pair(Operator::Linear, std::string_view("linear")),
                                std::pair(Operator::Camera, std::string_view("camera")),
                                std::pair(Operator::Human, std::string_view("human"))};

Result<void> check(const Image& scene, const ToneMapSettings& settings) {
    const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidArgument, std::move(message), ""}; };
    if (scene.empty()) return invalid("the picture has no pixels");
    if (!scene.hasColour() && !scene.has("Y")) return invalid("the picture has no channels R, G, B and none called Y");
    const auto& display = settings.display;
    if (!(display.minCdM2 > 0 && display.maxCdM2 > display.minCdM2 && display.maxCdM2 <= 1e6))
        return invalid(fmt::format("the display shows {} to {} cd/m^2, expected 0 < black < white <= 1e6",
                                   display.minCdM2, display.maxCdM2));
    if (settings.exposure && !(*settings.exposure > 0 && std::isfinite(*settings.exposure)))
        return invalid(fmt::format("exposure is {}, expected a number above 0", *settings.exposure));
    if (!(std::abs(settings.exposureEv) <= 64)) return invalid(fmt::format("exposure by {} EV, expected -64 to 64", settings.exposureEv));
    if (settings.view && !(settings.view->verticalFovDeg >= 0 && settings.view->verticalFovDeg <= 360))
        return invalid(fmt::format("vertical angle of view is {} degrees, expected 0 (not known) to 360",
                                   settings.view->verticalFovDeg));
    return {};
}

/// World luminances over all pixels, before any effect.
void recordRange(const Picture& picture, ToneMapRecord& record) {
    double logSum = 0;
    std::size_t count = 0;
    for (const Rgb& c : picture.pixels) {
        const double l = luminance(c);
        if (!(l > 0)) continue;
        record.worldMinCdM2 = count == 0 ? l : std::min(record.worldMinCdM2, l);
        record.worldMaxCdM2 = std::max(record.worldMaxCdM2, l);
        logSum += std::log(l);
        ++count;
    }
    if (count > 0) record.worldLogMeanCdM2 = std::exp(logSum / static_cast<double>(count));
}

/// The stages of one mapping, in the paper's order; each writes what it decided into the record.
class Mapping {
public:
    Mapping(Picture picture, const ToneMapSettings& settings, const ViewGeometry& view, ToneMapRecord& record)
        : settings_(settings),
          record_(record),
          picture_(std::move(picture)),
          directions_(view, picture_.width, picture_.height),
          foveal_(fovealImage(picture_, directions_)) {
        record_.view = directions_.geometry();
        record_.viewAssumed = !view.known();
        record_.fovealWidth = foveal_.picture.width;
        record_.fovealHeight = foveal_.picture.height;
    }

    Picture run() {
        veilFovealImage();
        const ToneCurve curve = chooseCurve();
        recordCurve(curve);
        blurToAcuity();
        if (!veil_.pixels.empty()) addVeil(picture_, veil_);
        loseColours();
        apply(curve);
        return std::move(picture_);
    }

private:
    /// Notes the decision when an effect is not asked for.
    bool asked(const char* effect, const std::optional<bool>& choice) {
        const bool on = choice.value_or(settings_.op == Operator::Human);
        if (!on)
            record_.effects.push_back(
                {effect, false,
                 choice ? "switched off" : fmt::format("not part of the {} operator", name(settings_.op))});
        return on;
    }
    void decide(const char* effect, bool applied, std::string why) {
        record_.effects.push_back({effect, applied, std::move(why)});
    }

    void veilFovealImage() {
        if (!asked("veil", settings_.effects.veil)) return;
        const auto levels = foveal_.luminances();
        const auto [low, high] = std::ranges::minmax(levels);
        if (levels.size() < 2 || low == high)
            return decide("veil", false, "the view is uniform: its veil would not change it");
        veil_ = veil(foveal_);
        for (std::size_t i = 0; i < veil_.pixels.size(); ++i) {
            Rgb& c = foveal_.picture.pixels[i];
            c = c * static_cast<float>(1 - kVeilFraction) + veil_.pixels[i];
        }
        decide("veil", true,
               fmt::format("{:.1f} % of the light about each of {} directions", 100 * kVeilFraction, levels.size()));
    }

    ToneCurve chooseCurve() {
        const auto levels = foveal_.luminances();
        if (settings_.op == Operator::Linear) {
            const double mean = record_.worldLogMeanCdM2 > 0 ? record_.worldLogMeanCdM2 : 1;
            const double factor = settings_.exposure.value_or(kAutomaticGrey * settings_.display.maxCdM2 / mean) * std::exp2(settings_.exposureEv);
            record_.why = settings_.exposure ? "exposure as given"
                                             : "automatic exposure: the log-mean luminance shows as 18 % of white";
            if (settings_.exposureEv != 0) record_.why += fmt::format(", and {:+g} EV", settings_.exposureEv);
            return ToneCurve::linear(factor, settings_.display);
        }
        const auto ceiling = settings_.op == Operator::Human ? Ceiling::Human : Ceiling::Linear;
        AdjustedHistogram adjusted;
        const auto curve = toneCurve(levels, settings_.display, ceiling, &adjusted);
        record_.passes = adjusted.passes;
        record_.keptFraction = adjusted.keptFraction;
        if (!curve.isLinear()) record_.why = "the scene's range is wider than the display's";
        else if (adjusted.passes > 0) record_.why = "nearly all of the histogram is above the contrast ceiling";
        else if (record_.worldMaxCdM2 < kDarkestVisible) record_.why = "the scene is darker than the eye can see";
        else record_.why = "the scene's range fits the display's";
        return curve;
    }

    void recordCurve(const ToneCurve& curve) {
        const bool linear = curve.isLinear();
        record_.factor = curve.factor();
        record_.mapping = linear                            ? "linear"
                          : settings_.op == Operator::Human ? "histogram, human ceiling"
                                                            : "histogram, linear ceiling";
        const auto levels = foveal_.luminances();
        double low = 0, high = 0;
        for (const double l : levels) {
            if (l >= kDarkestVisible && (low == 0 || l < low)) low = l;
            high = std::max(high, l);
        }
        if (low == 0) return;
        for (int i = 0; i < kCurvePoints; ++i) {
            const double world = low * std::pow(high / low, static_cast<double>(i) / (kCurvePoints - 1));
            record_.curve.push_back({world, curve.displayLuminance(world)});
        }
    }

    void blurToAcuity() {
        if (!asked("acuity", settings_.effects.acuity)) return;
        const auto sizes = visibleSampleSizes(foveal_, directions_, picture_.width, picture_.height);
        const double largest = *std::ranges::max_element(sizes);
        if (largest <= 1) return decide("acuity", false, "the eye sees every pixel of this picture");
        picture_ = blurredToAcuity(picture_, foveal_, sizes);
        decide("acuity", true,
               fmt::format("details up to {:.1f} pixels are too fine for the eye in the darkest parts", largest));
    }

    void loseColours() {
        if (!asked("colour", settings_.effects.colour)) return;
        const bool dark = std::ranges::any_of(picture_.pixels, [](const Rgb& c) {
            const float l = luminance(c);
            return l > 0 && l < kPhotopicAbove;
        });
        if (!dark)
            return decide("colour", false,
                          fmt::format("every pixel is above {} cd/m^2, where colour vision is full", kPhotopicAbove));
        for (Rgb& c : picture_.pixels) c = withNightColours(c);
        decide("colour", true,
               fmt::format("colours fade below {} cd/m^2 and are gone below {}", kPhotopicAbove, kScotopicBelow));
    }

    /// Linear pictures have black at no light; the others have it at the display's black, which the display adds.
    [[nodiscard]] double displayValue(const ToneCurve& curve, double world) const {
        const auto& d = settings_.display;
        if (settings_.op == Operator::Linear) return curve.factor() * world / d.maxCdM2;
        return (curve.displayLuminance(world) - d.minCdM2) / (d.maxCdM2 - d.minCdM2);
    }

    void apply(const ToneCurve& curve) {
        std::atomic<std::size_t> clipped = 0;
        const auto width = static_cast<std::size_t>(picture_.width);
        parallelFor(static_cast<std::size_t>(picture_.height), [&](std::size_t row) {
            std::size_t clippedHere = 0;
            for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
                Rgb& c = picture_.pixels[i];
                const double world = luminance(c);
                if (!(world > 0)) {
                    c = {};
                    continue;
                }
                const double shown = displayValue(curve, world);
                c *= static_cast<float>(shown / world);
                if (c.max() > 1.0F) {
                    ++clippedHere;
                    c = inGamut(c, static_cast<float>(std::min(shown, 1.0)));
                }
            }
            clipped += clippedHere;
        });
        record_.clippedPixels = clipped;
    }

    /// A colour that is too strong for the display, paled at its luminance until it is not.
    static Rgb inGamut(const Rgb& c, float grey) {
        if (grey >= 1 || !isFinite(c)) return Rgb(1.0F);
        const Rgb chroma = c - Rgb(grey);
        const float keep = (1 - grey) / chroma.max();
        const Rgb out = Rgb(grey) + chroma * std::min(keep, 1.0F);
        return {std::clamp(out.r, 0.0F, 1.0F), std::clamp(out.g, 0.0F, 1.0F), std::clamp(out.b, 0.0F, 1.0F)};
    }

    const ToneMapSettings& settings_;
    ToneMapRecord& record_;
    Picture picture_;
    PixelDirections directions_;
    FovealImage foveal_;
    Picture veil_;  // empty when there is none
};

Image asImage(const Picture& picture, const Image& scene, const ToneMapRecord& record) {
    Image out(picture.width, picture.height, {"R", "G", "B"});
    auto &r = out.channel("R"), &g = out.channel("G"), &b = out.channel("B");
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const Rgb& c = picture.pixels[i];
        r[i] = c.r, g[i] = c.g, b[i] = c.b;
    }
    out.text = scene.text;
    for (auto& [key, value] : headerText(record)) out.text[key] = value;
    out.text["luxdeck:unit"] = "display white";
    out.numbers = scene.numbers;
    out.numbers["whiteLuminance"] = record.display.maxCdM2;
    return out;
}

}  // namespace

std::string_view name(Operator op) {
    for (const auto& [known, text] : kOperators)
        if (known == op) return text;
    return "";
}

Result<Operator> operatorNamed(std::string_view text) {
    for (const auto& [op, known] : kOperators)
        if (known == text) return op;
    return Error{ErrorCode::InvalidArgument, fmt::format("operator '{}', expected linear, camera or human", text), ""};
}

Result<ToneMapped> toneMap(const Image& scene, const ToneMapSettings& settings) {
    if (auto ok = check(scene, settings); !ok) return ok.error();
    ToneMapped out;
    out.record.op = settings.op;
    out.record.display = settings.display;
    auto [picture, nonFinite, negative] = cleaned(scene);
    out.record.nonFinitePixels = nonFinite;
    out.record.negativePixels = negative;
    recordRange(picture, out.record);
    const auto view = settings.view.value_or(viewGeometryOf(scene));
    const Picture shown = Mapping(std::move(picture), settings, view, out.record).run();
    out.image = asImage(shown, scene, out.record);
    return out;
}

std::map<std::string, std::string> headerText(const ToneMapRecord& r) {
    std::map<std::string, std::string> out{
        {"luxdeck:operator", std::string(name(r.op))},
        {"luxdeck:mapping", fmt::format("{} ({})", r.mapping, r.why)},
        {"luxdeck:display", fmt::format("{:g} to {:g} cd/m^2", r.display.minCdM2, r.display.maxCdM2)},
        {"luxdeck:world",
         fmt::format("{:.4g} to {:.4g} cd/m^2, log-mean {:.4g}", r.worldMinCdM2, r.worldMaxCdM2, r.worldLogMeanCdM2)}};
    if (r.factor > 0) out["luxdeck:exposure"] = fmt::format("{:.6g}", r.factor);
    for (const auto& e : r.effects)
        out["luxdeck:" + e.effect] = fmt::format("{}: {}", e.applied ? "applied" : "left out", e.why);
    if (r.nonFinitePixels + r.negativePixels > 0)
        out["luxdeck:repaired"] = fmt::format("{} pixels not finite, {} negative", r.nonFinitePixels, r.negativePixels);
    return out;
}

}  // namespace luxdeck::tonemap

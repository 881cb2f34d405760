#include "tonemap/display_transform.h"

#include "engine/core/parallel.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

namespace OCIO = OCIO_NAMESPACE;

namespace luxdeck::tonemap {

struct DisplayTransform::State {
    OCIO::ConstCPUProcessorRcPtr processor;
    std::string configName, display, view, sourceSpace;
    bool dither = false;
};

namespace {

/// Names that widely used configs give to linear Rec.709. A scene_linear role alone may mean ACEScg.
constexpr std::array kLinearRec709Names{"Linear Rec.709",
                                        "Linear Rec.709 (sRGB)",
                                        "lin_rec709",
                                        "lin_srgb",
                                        "lin_rec709_scene",
                                        "Utility - Linear - Rec.709",
                                        "Utility - Linear - sRGB",
                                        "Linear"};

/// Where in the 256ths each pixel's rounding threshold lies: Bayer's 8 x 8 pattern.
double ditherThreshold(int x, int y) {
    int value = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int bx = x >> bit & 1, by = y >> bit & 1;
        value |= ((bx ^ by) << 1 | by) << (2 * (2 - bit));
    }
    return (value + 0.5) / 64;
}

std::string listed(int count, const auto& nameOf) {
    std::string out;
    for (int i = 0; i < count; ++i) out += fmt::format("{}'{}'", i == 0 ? "" : ", ", nameOf(i));
    return out;
}

struct LoadedConfig {
    OCIO::ConstConfigRcPtr config;
    std::string name;
};

Result<LoadedConfig> load(const std::string& given) {
    std::string file = given;
    if (file.empty())
        if (const char* fromEnvironment = std::getenv("OCIO"); fromEnvironment != nullptr) file = fromEnvironment;
    if (file.empty()) {
        std::istringstream text{std::string(builtinConfig())};
        return LoadedConfig{OCIO::Config::CreateFromStream(text), "Luxdeck's own"};
    }
    const std::string where = given.empty() ? "$OCIO = " + file : file;
    std::error_code ec;
    if (!std::filesystem::exists(file, ec)) return Error{ErrorCode::FileNotFound, "no such OpenColorIO config", where};
    try {
        auto config = OCIO::Config::CreateFromFile(file.c_str());
        config->validate();
        return LoadedConfig{config, file};
    } catch (const OCIO::Exception& e) {
        return Error{ErrorCode::Parse, fmt::format("is not a usable OpenColorIO config: {}", e.what()), where};
    }
}

Result<std::string> chooseDisplay(const OCIO::Config& config, const std::string& wanted, const std::string& where) {
    if (wanted.empty()) return std::string(config.getDefaultDisplay());
    for (int i = 0; i < config.getNumDisplays(); ++i)
        if (wanted == config.getDisplay(i)) return wanted;
    return Error{ErrorCode::InvalidArgument,
                 fmt::format("no display '{}', expected one of {}", wanted,
                             listed(config.getNumDisplays(), [&](int i) { return config.getDisplay(i); })),
                 where};
}

Result<std::string> chooseView(const OCIO::Config& config, const std::string& display, const std::string& wanted,
                               const std::string& where) {
    if (wanted.empty()) return std::string(config.getDefaultView(display.c_str()));
    const int count = config.getNumViews(display.c_str());
    for (int i = 0; i < count; ++i)
        if (wanted == config.getView(display.c_str(), i)) return wanted;
    return Error{ErrorCode::InvalidArgument,
                 fmt::format("display '{}' has no view '{}', expected one of {}", display, wanted,
                             listed(count, [&](int i) { return config.getView(display.c_str(), i); })),
                 where};
}

/// The space that linear Rec.709 pictures are in; none when the config has neither one nor the role.
std::optional<std::string> chooseSource(const OCIO::Config& config) {
    for (const char* name : kLinearRec709Names)
        if (const auto space = config.getColorSpace(name)) return std::string(space->getName());
    if (const auto space = config.getColorSpace(OCIO::ROLE_SCENE_LINEAR)) return std::string(space->getName());
    return {};
}

}  // namespace

Result<std::vector<DisplayViews>> displaysOf(const std::string& given) {
    try {
        const auto loaded = load(given);
        if (!loaded) return loaded.error();
        const auto& config = *loaded->config;
        std::vector<DisplayViews> displays;
        for (int d = 0; d < config.getNumDisplays(); ++d) {
            DisplayViews each{config.getDisplay(d), {}};
            for (int v = 0; v < config.getNumViews(each.display.c_str()); ++v) each.views.emplace_back(config.getView(each.display.c_str(), v));
            const std::string first = config.getDefaultView(each.display.c_str());
            std::ranges::stable_partition(each.views, [&](const auto& view) { return view == first; });
            displays.push_back(std::move(each));
        }
        std::ranges::stable_partition(displays, [&](const auto& each) { return each.display == config.getDefaultDisplay(); });
        return displays;
    } catch (const OCIO::Exception& e) {
        return Error{ErrorCode::Parse, fmt::format("OpenColorIO: {}", e.what()), given};
    }
}

Result<DisplayTransform> DisplayTransform::create(const DisplayTransformSettings& settings) {
    try {
        const auto loaded = load(settings.config);
        if (!loaded) return loaded.error();
        const auto& [config, configName] = *loaded;
        const auto display = chooseDisplay(*config, settings.display, configName);
        if (!display) return display.error();
        const auto view = chooseView(*config, *display, settings.view, configName);
        if (!view) return view.error();
        const auto source = chooseSource(*config);
        if (!source)
            return Error{ErrorCode::InvalidArgument, "has no linear Rec.709 space and no scene_linear role",
                         configName};

        auto state = std::make_shared<State>();
        const auto processor =
            config->getProcessor(source->c_str(), display->c_str(), view->c_str(), OCIO::TRANSFORM_DIR_FORWARD);
        state->processor = processor->getDefaultCPUProcessor();
        state->configName = configName;
        state->display = *display;
        state->view = *view;
        state->sourceSpace = *source;
        state->dither = settings.dither;
        DisplayTransform out;
        out.state_ = std::move(state);
        return out;
    } catch (const OCIO::Exception& e) {
        return Error{ErrorCode::Parse, fmt::format("OpenColorIO: {}", e.what()), settings.config};
    }
}

Result<DisplayImage> DisplayTransform::apply(const Image& image) const {
    if (image.empty() || !image.hasColour())
        return Error{ErrorCode::InvalidArgument, "the picture has no R, G, B channels", ""};
    const auto &r = image.channel("R"), &g = image.channel("G"), &b = image.channel("B");
    DisplayImage out{image.width(), image.height(), std::vector<std::uint8_t>(3 * image.pixelCount()), image.text};
    out.text["luxdeck:displayTransform"] =
        fmt::format("{}: {} to {}, {}", state_->configName, state_->sourceSpace, state_->display, state_->view);
    const auto width = static_cast<std::size_t>(image.width());
    parallelFor(static_cast<std::size_t>(image.height()), [&](std::size_t row) {
        std::vector<float> line(3 * width);
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = row * width + x;
            const Rgb c = {r[i], g[i], b[i]};
            const Rgb clean = isFinite(c) ? c : Rgb();
            line[3 * x] = clean.r, line[3 * x + 1] = clean.g, line[3 * x + 2] = clean.b;
        }
        OCIO::PackedImageDesc description(line.data(), image.width(), 1, 3);
        state_->processor->apply(description);
        for (std::size_t k = 0; k < line.size(); ++k) {
            const double rounding =
                state_->dither ? ditherThreshold(static_cast<int>(k / 3), static_cast<int>(row)) : 0.5;
            const double value = std::isfinite(line[k]) ? std::clamp(line[k], 0.0F, 1.0F) : 0.0F;
            out.rgb[3 * row * width + k] =
                static_cast<std::uint8_t>(std::min(255.0, std::floor(255 * value + rounding)));
        }
    });
    return out;
}

const std::string& DisplayTransform::configName() const { return state_->configName; }
const std::string& DisplayTransform::display() const { return state_->display; }
const std::string& DisplayTransform::view() const { return state_->view; }
const std::string& DisplayTransform::sourceSpace() const { return state_->sourceSpace; }

}  // namespace luxdeck::tonemap

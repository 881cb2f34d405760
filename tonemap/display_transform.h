#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::tonemap {

/// Our own OpenColorIO config, also installed as a file (luxdeck.ocio).
std::string_view builtinConfig();

/// The view of our config that only encodes: for pictures that the operators made, which have a tone curve already.
inline constexpr std::string_view kToneMappedView = "Luxdeck (tone-mapped)";
/// The view with the Academy's tone curve: for Operator::Linear.
inline constexpr std::string_view kAcesView = "ACES SDR";

struct DisplayTransformSettings {
    std::string config;   ///< file; empty: $OCIO when it is set, else our own
    std::string display;  ///< empty: the config's default
    std::string view;     ///< empty: the config's default for that display
    bool dither = false;  ///< an ordered 8 x 8 pattern hides the steps of 8 bits in dark gradients
};

/// A display that a config knows, and what it can show there; the default first.
struct DisplayViews {
    std::string display;
    std::vector<std::string> views;
};

/// The displays of a config (empty: $OCIO when it is set, else our own), the default first.
///
/// errors  FileNotFound, Parse
Result<std::vector<DisplayViews>> displaysOf(const std::string& config = {});

/// From linear Rec.709 to the bytes of a display, by OpenColorIO. create() then apply() any number of times, from
/// any thread.
class DisplayTransform {
public:
    /// errors  FileNotFound, Parse (the config), InvalidArgument (no such display or view: the message lists them)
    static Result<DisplayTransform> create(const DisplayTransformSettings& settings);

    /// image    R, G, B; values that are not finite become black
    /// errors   InvalidArgument: no such channels
    [[nodiscard]] Result<DisplayImage> apply(const Image& image) const;

    [[nodiscard]] const std::string& configName() const;  ///< "Luxdeck's own", or the file
    [[nodiscard]] const std::string& display() const;
    [[nodiscard]] const std::string& view() const;
    /// The config's colour space that pictures are taken to be in.
    [[nodiscard]] const std::string& sourceSpace() const;

private:
    struct State;
    std::shared_ptr<const State> state_;
};

}  // namespace luxdeck::tonemap

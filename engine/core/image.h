#pragma once

#include "engine/core/rgb.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace luxdeck {

/// A picture of named float channels, rows from the top. `#P = width * height` values a channel.
/// Colour pictures hold "R", "G", "B" (and "Y" where only luminance was computed); layers add others,
/// such as "stderr.Y". Attributes are the header's text and numbers.
class Image {
public:
    Image() = default;
    Image(int width, int height, const std::vector<std::string>& channelNames) : width_(width), height_(height) {
        for (const auto& name : channelNames) addChannel(name);
    }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] std::size_t pixelCount() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
    [[nodiscard]] bool empty() const { return pixelCount() == 0 || channels_.empty(); }
    [[nodiscard]] bool has(const std::string& name) const { return channels_.contains(name); }
    [[nodiscard]] bool hasColour() const { return has("R") && has("G") && has("B"); }
    [[nodiscard]] const std::map<std::string, std::vector<float>>& channels() const { return channels_; }

    /// Adds a channel of zeros, or returns the one that is there.
    std::vector<float>& addChannel(const std::string& name) {
        auto& values = channels_[name];
        values.resize(pixelCount());
        return values;
    }
    /// Values of a channel that is there, #P.
    [[nodiscard]] std::vector<float>& channel(const std::string& name) { return channels_.at(name); }
    [[nodiscard]] const std::vector<float>& channel(const std::string& name) const { return channels_.at(name); }

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    std::map<std::string, std::string> text;   ///< header: luxdeck:unit, luxdeck:algorithm, view ...
    std::map<std::string, double> numbers;     ///< header: whiteLuminance, luxdeck:seconds ...
    LuminanceWeights weights;                  ///< of the working space the RGB channels are in

private:
    int width_ = 0;
    int height_ = 0;
    std::map<std::string, std::vector<float>> channels_;
};

/// The pixels of an image's R, G, B channels as colours, #P; a picture that has only Y gives greys.
std::vector<Rgb> colours(const Image& image);

/// An 8-bit sRGB picture for screens and print, RGB interleaved, rows from the top: #P x 3.
struct DisplayImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    std::map<std::string, std::string> text;  ///< operator, exposure ...: goes into the file's header
};

}  // namespace luxdeck

#include "engine/io/ies_tilt.h"

#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace luxdeck {

double LampTilt::factor(const Frame& frame) const {
    if (degrees.empty()) return 1;
    const double cosine = std::clamp(static_cast<double>(frame.normal.z), -1.0, 1.0);
    const double tilt = std::acos(cosine) / kDegree;
    const auto above = std::upper_bound(degrees.begin(), degrees.end(), tilt);
    if (above == degrees.begin()) return factors.front();
    if (above == degrees.end()) return factors.back();
    const auto i = static_cast<std::size_t>(above - degrees.begin());
    const double part = (tilt - degrees[i - 1]) / (degrees[i] - degrees[i - 1]);
    return factors[i - 1] + part * (factors[i] - factors[i - 1]);
}

namespace photometry {

namespace {

/// No lamp was measured in more positions.
constexpr std::size_t kMostAngles = 100'000;

/// Lamp geometry, angles and factors. The geometry says how the lamp lies in the luminaire, which is why its makers
/// measured these factors: in all three cases they are by the luminaire's tilt.
Result<LampTilt> readTable(TokenReader& tokens) {
    if (auto geometry = tokens.count("the lamp-to-luminaire geometry of TILT (1, 2 or 3)", 3); !geometry)
        return geometry.error();
    const auto pairs = tokens.count("the number of tilt angles", kMostAngles);
    if (!pairs) return pairs.error();
    if (2 * *pairs > tokens.remaining())
        return tokens.error(fmt::format("{} tilt angles and their multipliers take {} numbers after this one; seen {}",
                                        *pairs, 2 * *pairs, tokens.remaining()));
    LampTilt tilt;
    for (std::size_t i = 0; i < *pairs; ++i) {
        const auto angle = tokens.number("a tilt angle");
        if (!angle) return angle.error();
        if (!tilt.degrees.empty() && !(*angle > tilt.degrees.back()))
            return tokens.error(fmt::format("tilt angle {} is {:.6g}, expected more than the one before, {:.6g}", i + 1,
                                            *angle, tilt.degrees.back()));
        tilt.degrees.push_back(*angle);
    }
    for (std::size_t i = 0; i < *pairs; ++i) {
        const auto factor = tokens.number("a tilt multiplier");
        if (!factor) return factor.error();
        if (*factor < 0) return tokens.error(fmt::format("tilt multiplier {} is {}, expected >= 0", i + 1, *factor));
        tilt.factors.push_back(*factor);
    }
    return tilt;
}

Result<LampTilt> readTableFile(const Labels& labels, const std::filesystem::path& name, Photometry& p) {
    if (labels.year >= 2019) p.repairs.emplace_back("TILT=file, which LM-63-2019 no longer allows, accepted");
    std::string file = labels.tilt;
    std::replace(file.begin(), file.end(), '\\', '/');
    const auto path = name.parent_path() / std::filesystem::path(file).filename();
    const auto bytes = readFile(path, 1 << 20);
    if (!bytes) {
        p.warnings.push_back(
            fmt::format("the tilt file {} cannot be read: how tilting changes the lamp's output is not known",
                        inQuotes(labels.tilt)));
        return LampTilt{};
    }
    const auto text = decodeText(*bytes, path, p.repairs);
    if (!text) return text.error();
    const auto lines = splitLines(*text);
    TokenReader tokens(path, lines, 0, p.repairs);
    return readTable(tokens);
}

}  // namespace

Result<LampTilt> readTilt(const Labels& labels, const std::filesystem::path& name, TokenReader& tokens, Photometry& p) {
    const std::string kind = upperCase(labels.tilt);
    if (kind.empty() || kind == "NONE") return LampTilt{};
    auto tilt = kind == "INCLUDE" ? readTable(tokens) : readTableFile(labels, name, p);
    if (!tilt || tilt->factors.empty()) return tilt;
    const auto [least, most] = std::minmax_element(tilt->factors.begin(), tilt->factors.end());
    if (*least != 1 || *most != 1)
        p.warnings.push_back(
            fmt::format("the lamp's output depends on how the luminaire is tilted (TILT, factor {:.4g}..{:.4g}): the "
                        "intensities here are those of the measured position, a placed luminaire shines by its tilt",
                        *least, *most));
    return tilt;
}

}  // namespace photometry

Result<LampTilt> readLampTilt(std::string_view bytes, const std::filesystem::path& name) {
    Photometry unused;
    const auto text = photometry::decodeText(bytes, name, unused.repairs);
    if (!text) return text.error();
    const auto lines = photometry::splitLines(*text);
    const auto labels = photometry::readLabels(lines, name, unused);
    if (!labels) return labels.error();
    photometry::TokenReader tokens(name, lines, labels->tiltLine + 1, unused.repairs);
    return photometry::readTilt(*labels, name, tokens, unused);
}

}  // namespace luxdeck

#include "engine/io/rad_primitive.h"

#include <algorithm>
#include <array>

namespace luxdeck::rad {

namespace {

using Names = std::string_view;

constexpr std::array<Names, 11> kSurfaces = {"source", "sphere", "bubble", "polygon",  "cone", "cup",
                                             "cylinder", "tube", "ring",   "instance", "mesh"};
constexpr std::array<Names, 47> kModifiers = {
    "alias",      "light",     "illum",      "glow",       "spotlight",  "mirror",     "prism1",    "prism2",
    "mist",       "plastic",   "metal",      "trans",      "plastic2",   "metal2",     "trans2",    "ashik2",
    "WGMDfunc",   "dielectric", "interface", "glass",      "BRTDfunc",   "plasfunc",   "metfunc",   "transfunc",
    "BSDF",       "aBSDF",     "plasdata",   "metdata",    "transdata",  "antimatter", "texfunc",   "texdata",
    "colorfunc",  "brightfunc", "colordata", "brightdata", "colorpict",  "colortext",  "brighttext", "mixfunc",
    "mixdata",    "mixpict",   "mixtext",    "specfunc",   "specfile",   "specdata",   "specpict"};
constexpr std::array<std::array<Names, 2>, 3> kInverses = {{{"sphere", "bubble"}, {"cone", "cup"}, {"cylinder", "tube"}}};

}  // namespace

bool isSurface(std::string_view type) { return std::find(kSurfaces.begin(), kSurfaces.end(), type) != kSurfaces.end(); }

bool isKnownType(std::string_view type) {
    return isSurface(type) || type == "spectrum" || std::find(kModifiers.begin(), kModifiers.end(), type) != kModifiers.end();
}

std::string_view invertedType(std::string_view type) {
    for (const auto& [outward, inward] : kInverses) {
        if (type == outward) return inward;
        if (type == inward) return outward;
    }
    return type;
}

}  // namespace luxdeck::rad

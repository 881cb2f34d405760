#include "engine/io/rad_transform.h"

#include "engine/io/rad_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace luxdeck::rad {

namespace {

using Names = std::string_view;

/// What takes a transform at the end of its string arguments.
constexpr std::array<Names, 25> kWithWords = {
    "mesh",       "instance",   "plastic2",  "metal2",    "trans2",   "ashik2",   "WGMDfunc",   "BRTDfunc", "plasfunc",
    "metfunc",    "transfunc",  "BSDF",      "aBSDF",     "plasdata", "metdata",  "transdata",  "texfunc",  "texdata",
    "colorfunc",  "brightfunc", "colordata", "brightdata", "colorpict", "specfunc", "specdata"};
constexpr std::array<Names, 4> kMixtures = {"mixfunc", "mixdata", "mixpict", "specpict"};
constexpr std::array<Names, 3> kTexts = {"colortext", "brighttext", "mixtext"};

template <std::size_t N>
bool isOneOf(const std::string& type, const std::array<Names, N>& names) {
    return std::find(names.begin(), names.end(), type) != names.end();
}

void movePoint(std::vector<double>& n, std::size_t at, const Xform& xform) {
    const Vec3d p = xform.point({n[at], n[at + 1], n[at + 2]});
    for (std::size_t i = 0; i < 3; ++i) n[at + i] = p[static_cast<int>(i)];
}

void turnVector(std::vector<double>& n, std::size_t at, const Xform& xform, double scale = 1) {
    const Vec3d v = xform.vector({n[at], n[at + 1], n[at + 2]}) * scale;
    for (std::size_t i = 0; i < 3; ++i) n[at + i] = v[static_cast<int>(i)];
}

void transformPolygon(std::vector<double>& n, const Xform& xform, bool reverse) {
    for (std::size_t i = 0; i + 2 < n.size(); i += 3) movePoint(n, i, xform);
    if (!reverse) return;
    for (std::size_t low = 0, high = n.size() - 3; low < high; low += 3, high -= 3)
        for (std::size_t i = 0; i < 3; ++i) std::swap(n[low + i], n[high + i]);
}

void transformSurface(Primitive& p, const XformCopy& copy) {
    auto& n = p.numbers;
    const Xform& xform = copy.xform;
    if (p.type == "polygon") {
        transformPolygon(n, xform, xform.mirrored != copy.invert);
        for (auto& normal : p.normals) normal = xform.vector(normal) * (copy.invert ? -1 : 1) / xform.scale;
        if (xform.mirrored != copy.invert) std::reverse(p.normals.begin(), p.normals.end());
    } else if (p.type == "source") {
        turnVector(n, 0, xform);
    } else if (p.type == "sphere" || p.type == "bubble") {
        movePoint(n, 0, xform);
        n[3] *= xform.scale;
    } else if (p.type == "ring") {
        movePoint(n, 0, xform);
        turnVector(n, 3, xform, (copy.invert ? -1 : 1) / xform.scale);
        n[6] *= xform.scale, n[7] *= xform.scale;
    } else if (p.type != "mesh" && p.type != "instance") {  // cylinder, tube, cone, cup
        movePoint(n, 0, xform);
        movePoint(n, 3, xform);
        for (std::size_t i = 6; i < n.size(); ++i) n[i] *= xform.scale;
    }
    if (copy.invert) p.type = invertedType(p.type);
    if (!copy.prefix.empty()) p.name = copy.prefix + "." + p.name;
    if (!copy.modifier.empty()) p.modifier = copy.modifier;
}

/// Transmittances of a unit of length become those of the new unit.
void scaleAbsorption(std::vector<double>& n, std::size_t at, double scale) {
    for (std::size_t i = at; i < at + 3 && i < n.size(); ++i) n[i] = std::pow(n[i], 1 / scale);
}

void transformModifier(Primitive& p, const XformCopy& copy) {
    auto& n = p.numbers;
    const double scale = copy.xform.scale;
    if (p.type == "glow" && n.size() > 3) n[3] *= scale;
    if (p.type == "spotlight" && n.size() > 6) turnVector(n, 4, copy.xform);
    if (p.type == "dielectric" || p.type == "interface") scaleAbsorption(n, 0, scale);
    if (p.type == "interface") scaleAbsorption(n, 4, scale);
    if (p.type == "mist")
        for (std::size_t i = 0; i < 3 && i < n.size(); ++i) n[i] /= scale;
    if (isOneOf(p.type, kTexts) && n.size() >= 9) {
        movePoint(n, 0, copy.xform);
        turnVector(n, 3, copy.xform);
        turnVector(n, 6, copy.xform);
    }
    if (p.sky) p.sky = turned(*p.sky, copy.xform);
}

}  // namespace

Result<void> checkArguments(const Primitive& p) {
    struct Size {
        Names type;
        std::size_t numbers;
    };
    static constexpr std::array<Size, 8> kSizes = {{{"source", 4}, {"sphere", 4}, {"bubble", 4}, {"cylinder", 7},
                                                    {"tube", 7},   {"cone", 8},   {"cup", 8},    {"ring", 8}}};
    const auto seen = p.numbers.size();
    if (p.type == "polygon" && (seen < 9 || seen % 3 != 0))
        return p.place.error(ErrorCode::Parse, fmt::format("polygon {} has {} numbers, expected three for each of at least 3 corners", p.name, seen));
    for (const auto& size : kSizes)
        if (p.type == size.type && seen != size.numbers)
            return p.place.error(ErrorCode::Parse, fmt::format("{} {} has {} numbers, expected {}", p.type, p.name, seen, size.numbers));
    return {};
}

Result<Primitive> transformed(const Primitive& primitive, const XformCopy& copy) {
    if (auto sized = checkArguments(primitive); !sized) return sized.error();
    Primitive p = primitive;
    if (isSurface(p.type)) transformSurface(p, copy);
    else transformModifier(p, copy);
    if ((isOneOf(p.type, kWithWords) || isOneOf(p.type, kMixtures)) && !copy.words.empty()) {
        // Without it, a count that stands open in the earlier words would repeat the new ones too.
        if (copy.words.front() != "-i") p.strings.insert(p.strings.end(), {"-i", "1"});
        p.strings.insert(p.strings.end(), copy.words.begin(), copy.words.end());
    }
    for (const double x : p.numbers)
        if (!std::isfinite(x)) return p.place.error(ErrorCode::Parse, fmt::format("{} {} leaves the range of numbers when transformed", p.type, p.name));
    return p;
}

}  // namespace luxdeck::rad

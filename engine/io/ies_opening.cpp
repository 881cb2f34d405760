#include "engine/io/ies_opening.h"

#include "engine/io/photometry_opening.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::photometry {
namespace {

struct Mapped {
    LuminousOpening opening;
    const char* instead = nullptr;  // what the file means, where the opening only approximates it
};

/// 1986, 1991 and 1995: a negative width alone is a diameter (or an axis of an ellipse beside a length).
/// source  LIGHTING-FACTS C.3, after Radiance's ies2rad shape tables
Mapped beforeEdition2002(int year, double w, double l, double h) {
    if (w == 0 && l < 0) std::swap(w, l);
    const double aw = std::abs(w);
    const double al = std::abs(l);
    const double ah = std::abs(h);
    if (w == 0 && l > 0 && h < 0) return {boxOrRectangle(al, ah, ah), "horizontal cylinder along 0-180"};
    if (w > 0 && l == 0 && h < 0) return {boxOrRectangle(ah, aw, ah), "horizontal cylinder along 90-270"};
    if (l == 0 && h == 0) return {disc(aw), nullptr};
    if (l == 0 && h > 0) return {uprightCylinder(aw, ah), nullptr};
    if (l == 0) return {sphere(aw), aw == ah ? nullptr : "spheroid"};
    const double round = std::sqrt(aw * al);
    if (h == 0) return {disc(round), aw == al ? nullptr : "ellipse"};
    if (h < 0 || (year <= 1991 && w < 0 && l > 0)) return {sphere(std::cbrt(aw * al * ah)), "ellipsoid"};
    return {uprightCylinder(round, ah), aw == al ? nullptr : "elliptical cylinder"};
}

/// 2002 and 2019: negative width and length are the axes of something round seen from below.
Mapped sinceEdition2002(double w, double l, double h) {
    const double aw = std::abs(w);
    const double al = std::abs(l);
    const double ah = std::abs(h);
    if (w < 0 && l > 0 && h < 0) return {boxOrRectangle(al, aw, ah), "horizontal cylinder along 0-180"};
    if (w > 0 && l < 0 && h < 0) return {boxOrRectangle(al, aw, ah), "horizontal cylinder along 90-270"};
    // Facing the photometric horizontal (0 degrees, +x). ies2rad keys it on the length instead; either is read.
    if (w < 0 && l == 0 && h < 0) return {boxOrRectangle(0, aw, ah), "upright disc facing 0 degrees"};
    if (w == 0 && l < 0 && h < 0) return {boxOrRectangle(al, 0, ah), "upright disc facing 90 degrees"};
    if (w < 0 && l == 0) std::swap(l, w);
    if (w == 0 && l < 0) {  // older spelling of a disc or cylinder, still common in new files
        const double diameter = std::max(aw, al);
        return {h == 0 ? disc(diameter) : uprightCylinder(diameter, ah), nullptr};
    }
    const double round = std::sqrt(aw * al);
    if (h == 0) return {disc(round), aw == al ? nullptr : "ellipse"};
    if (h > 0) return {uprightCylinder(round, ah), aw == al ? nullptr : "elliptical cylinder"};
    if (aw == al && al == ah) return {sphere(aw), nullptr};
    return {sphere(std::cbrt(aw * al * ah)), "ellipsoid"};
}

const char* nameOf(OpeningShape shape) {
    switch (shape) {
        case OpeningShape::Point: return "point";
        case OpeningShape::Rectangle: return "rectangle";
        case OpeningShape::Disc: return "disc of equal area";
        case OpeningShape::Box: return "box around it";
        case OpeningShape::Cylinder: return "round cylinder of equal volume";
        case OpeningShape::Sphere: return "sphere of equal volume";
    }
    return "";
}

}  // namespace

void readOpening(const IesOpening& file, Photometry& p) {
    const double w = file.width * file.metresPerUnit;
    const double l = file.length * file.metresPerUnit;
    const double h = file.height * file.metresPerUnit;
    if (w == 0 && l == 0 && h == 0) return;  // a point

    if (w >= 0 && l >= 0 && h >= 0) {
        p.opening = boxOrRectangle(l, w, h);
        if (w == 0 || l == 0) p.repairs.emplace_back("luminous opening without width or length: given 1 mm");
    } else {
        const Mapped mapped = file.year >= 2002 ? sinceEdition2002(w, l, h) : beforeEdition2002(file.year, w, l, h);
        if (!(mapped.opening.lengthM > 0)) {
            p.warnings.push_back(
                fmt::format("luminous opening: width {:.4g}, length {:.4g}, height {:.4g} is no shape of "
                            "LM-63; taken as a point",
                            file.width, file.length, file.height));
            return;
        }
        p.opening = mapped.opening;
        if (mapped.instead) {
            p.repairs.push_back(fmt::format("luminous opening: {} ({:.4g} x {:.4g} x {:.4g} m) taken as the {}",
                                            mapped.instead, std::abs(w), std::abs(l), std::abs(h),
                                            nameOf(mapped.opening.shape)));
        }
    }
    warnIfHuge(p);
}

}  // namespace luxdeck::photometry

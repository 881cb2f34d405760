#pragma once

#include "analysis/validation/cie171.h"
#include "engine/core/vec.h"

#include <functional>
#include <vector>

/// What the cases are held against. Written apart from the engine on purpose: nothing here calls its sky, its glass or its samplers.
namespace luxdeck::cie171 {

/// The points corner + s u + t v, 0 <= s, t <= 1; u and v are orthogonal.
struct Patch {
    Vec3d corner{0, 0, 0}, u{1, 0, 0}, v{0, 1, 0};

    [[nodiscard]] std::vector<Vec3d> corners() const { return {corner, corner + u, corner + u + v, corner + v}; }
    [[nodiscard]] double area() const { return u.cross(v).length(); }
};

/// Illuminance at a point over pi times the luminance of a uniform polygon, what lies behind the receiver cut off.
/// Source: Lambert's contour formula, LIGHTING-FACTS F.3.
double configurationFactor(const std::vector<Vec3d>& polygon, const Vec3d& at, const Vec3d& normal);

/// What a slab of glass lets through of unpolarised light: surfaces by Fresnel, absorption along the refracted way, all
/// interreflections, each polarisation by itself.
class ReferenceGlass {
public:
    /// atNormal  transmittance of the whole slab at normal incidence
    ReferenceGlass(double atNormal, double ior);
    [[nodiscard]] double transmittance(double cosine) const;

private:
    double ior_;
    double inside_;  // what one passage at normal incidence leaves between the surfaces
};
/// The curve that CIE 171 takes for 6 mm of clear glass. Source: Mitalas & Arseneault 1968.
double mitalas(double atNormal, double cosine);

/// A sky by its CIE number: 0 uniform, 1 .. 15 of CIE S 011, 16 the traditional overcast; the zenith has luminance 1.
struct ReferenceSky {
    int type = 0;
    Vec3d sun{0, 0, 1};

    [[nodiscard]] double luminance(const Vec3d& direction) const;
    /// Of the unobstructed horizontal plane.
    [[nodiscard]] Cie171Reference horizontal() const;
};

/// Illuminance through an opening of which all is seen, from luminances by direction. Midpoints; the error is what halving
/// the step changes, which is three times the error of the finer step where the integrand is smooth.
Cie171Reference throughOpening(const Patch& opening, const Vec3d& at, const Vec3d& normal, const std::function<double(const Vec3d&)>& luminance);

/// Points and weights of Gauss's rule on 0 .. 1.
struct GaussRule {
    std::vector<double> points, weights;
};
GaussRule gaussRule(int n);

}  // namespace luxdeck::cie171

#include "engine/io/rad_material.h"

#include "engine/io/rad_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace luxdeck::rad {

namespace {

using Names = std::string_view;

constexpr std::array<Names, 4> kEmitters = {"light", "illum", "glow", "spotlight"};
constexpr std::array<Names, 11> kRead = {"plastic", "metal", "trans", "plastic2", "metal2", "trans2",
                                         "dielectric", "interface", "glass", "mirror", "BRTDfunc"};
constexpr std::array<Names, 14> kRefused = {"prism1", "prism2", "mist", "ashik2", "WGMDfunc", "plasfunc", "metfunc",
                                            "transfunc", "plasdata", "metdata", "transdata", "BSDF", "aBSDF", "antimatter"};

template <std::size_t N>
bool isOneOf(Names type, const std::array<Names, N>& names) {
    return std::find(names.begin(), names.end(), type) != names.end();
}

/// The cone that a spotlight keeps to, about its axis.
class SpotCone final : public Pattern {
public:
    SpotCone(const Vec3& axis, double halfAngleDeg) : axis_(axis), cosine_(static_cast<float>(std::cos(halfAngleDeg * kDegree))) {}
    [[nodiscard]] Rgb value(const PatternPoint& at) const override { return Rgb(-dot(at.direction, axis_) >= cosine_ ? 1.0F : 0.0F); }
    [[nodiscard]] std::string identity() const override { return fmt::format("spot {} {} {} {}", axis_.x, axis_.y, axis_.z, cosine_); }

private:
    Vec3 axis_;
    float cosine_;
};

/// One material being mapped.
class Mapper {
public:
    Mapper(const Primitive& p, double metresPerUnit, const Matrix4d& turn, WarningList& warnings)
        : p_(p), metresPerUnit_(metresPerUnit), turn_(turn), warnings_(warnings) {}

    Result<MappedMaterial> map() {
        if (isOneOf(p_.type, kRefused) || !isMaterial(p_.type))
            return p_.place.error(ErrorCode::Unsupported, fmt::format("the material {} {} is not read, expected one of plastic, metal, trans, plastic2, metal2, trans2, BRTDfunc, glass, dielectric, interface, mirror, light, glow, spotlight, illum", p_.type, p_.name));
        auto& m = out_.material;
        m.name = p_.name;
        m.source = fmt::format("{} of {}", p_.type, p_.place.text());
        m.reflectance = m.specular = Rgb(0.0F);
        auto done = isEmitter(p_.type) ? emitter() : p_.type == "BRTDfunc" ? functionMaterial() : isWard() ? ward() : specular();
        if (!done) return done.error();
        return std::move(out_);
    }

private:
    [[nodiscard]] bool isWard() const { return p_.type.starts_with("plastic") || p_.type.starts_with("metal") || p_.type.starts_with("trans"); }
    [[nodiscard]] double number(std::size_t i) const { return p_.numbers[i]; }

    Result<void> need(std::size_t count) const {
        if (p_.numbers.size() >= count) return {};
        return p_.place.error(ErrorCode::Parse, fmt::format("{} {} has {} numbers, expected {}", p_.type, p_.name, p_.numbers.size(), count));
    }
    void warn(const std::string& text) { warnings_.add(p_.type + text, fmt::format("{}: {} {} {}", p_.place.text(), p_.type, p_.name, text)); }

    /// A fraction; beyond 0..1 it is cut off with a warning.
    double fraction(std::size_t i, const char* what) {
        const double x = number(i);
        if (x >= 0 && x <= 1) return x;
        warn(fmt::format("has {} {}: taken as {}, expected 0 to 1", what, x, std::clamp(x, 0.0, 1.0)));
        return std::clamp(x, 0.0, 1.0);
    }
    Rgb fractions(std::size_t i, const char* what) {
        return {static_cast<float>(fraction(i, what)), static_cast<float>(fraction(i + 1, what)), static_cast<float>(fraction(i + 2, what))};
    }

    /// plastic, metal, trans and their forms with two widths.
    Result<void> ward() {
        const bool two = p_.type.ends_with('2'), trans = p_.type.starts_with("trans"), metal = p_.type.starts_with("metal");
        if (auto ok = need((two ? 6U : 5U) + (trans ? 2U : 0U)); !ok) return ok;
        auto& m = out_.material;
        const Rgb colour = fractions(0, "a colour of");
        const auto specular = static_cast<float>(fraction(3, "a specularity of"));
        m.specular = metal ? colour * specular : Rgb(specular);
        const std::size_t next = two ? 6 : 5;
        const auto through = trans ? static_cast<float>(fraction(next, "a transmission of")) : 0.0F;
        const auto straight = trans ? static_cast<float>(fraction(next + 1, "a specular part of the transmission of")) : 0.0F;
        m.reflectance = colour * ((1 - specular) * (1 - through));
        m.diffuseTransmittance = colour * ((1 - specular) * through * (1 - straight));
        m.specularTransmittance = colour * ((1 - specular) * through * straight);
        const bool matte = m.specular.isBlack() && through == 0;
        m.kind = matte ? MaterialKind::Matte : MaterialKind::Ward;
        if (matte) return {};
        m.wardU = static_cast<float>(fraction(4, "a roughness of"));
        m.wardV = two ? static_cast<float>(fraction(5, "a roughness of")) : m.wardU;
        if (two) setGrain();
        return {};
    }

    /// ux uy uz of the forms with two widths, where they are numbers.
    void setGrain() {
        auto& m = out_.material;
        if (m.wardU == m.wardV) return;
        std::array<double, 3> u{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto x = i < p_.strings.size() ? numberOf(p_.strings[i]) : std::nullopt;
            if (!x) {
                warn("has a grain that is an expression: taken as isotropic with the mean width");
                m.wardU = m.wardV = std::sqrt(m.wardU * m.wardV);
                return;
            }
            u[i] = *x;
        }
        Vec3d grain(0, 0, 0);
        turn_.multDirMatrix(Vec3d(u[0], u[1], u[2]), grain);
        if (grain.length() > 0) m.grain = Vec3(grain.normalized());
    }

    Result<void> functionMaterial() {
        if (auto ok = need(9); !ok) return ok;
        auto& m = out_.material;
        m.kind = MaterialKind::Ward;
        m.reflectance = (fractions(0, "a reflectance of") + fractions(3, "a reflectance of")) * 0.5F;
        m.diffuseTransmittance = fractions(6, "a transmittance of");
        std::array<float, 6> mirrored{};
        bool expression = false;
        for (std::size_t i = 0; i < 6; ++i) {
            const auto x = i < p_.strings.size() ? numberOf(p_.strings[i]) : std::nullopt;
            expression = expression || !x;
            mirrored[i] = static_cast<float>(std::clamp(x.value_or(0), 0.0, 1.0));
        }
        m.specular = {mirrored[0], mirrored[1], mirrored[2]};
        m.specularTransmittance = {mirrored[3], mirrored[4], mirrored[5]};
        const float total = (m.reflectance + m.diffuseTransmittance + m.specular + m.specularTransmittance).max();
        if (total > 1)
            for (auto* c : {&m.reflectance, &m.diffuseTransmittance, &m.specular, &m.specularTransmittance}) *c *= 1 / total;
        warn(fmt::format("is taken in its nearest isotropic form: its mean diffuse reflectance and its transmittance{}",
                         expression ? "; specular parts that are expressions are left out" : " and its specular parts"));
        return {};
    }

    Result<void> specular() {
        if (p_.type == "mirror") return mirror();
        if (p_.type == "glass") return glass();
        return solid();
    }

    Result<void> mirror() {
        if (auto ok = need(3); !ok) return ok;
        out_.material.kind = MaterialKind::Mirror;
        out_.material.specular = fractions(0, "a reflectance of");
        if (!p_.strings.empty() && p_.strings[0] != "void")
            warn(fmt::format("shows as {} when looked at in Radiance: here it is a mirror for every ray", p_.strings[0]));
        return {};
    }

    Result<void> glass() {
        if (auto ok = need(3); !ok) return ok;
        auto& m = out_.material;
        m.kind = MaterialKind::ThinGlass;
        if (p_.numbers.size() > 3) setIor(number(3));
        std::array<float, 3> t{};
        for (std::size_t i = 0; i < 3; ++i) {
            const double tn = number(i);
            if (!(tn >= 0 && tn <= 1)) warn(fmt::format("has a transmissivity of {}: taken as {}, expected 0 to 1", tn, std::clamp(tn, 0.0, 1.0)));
            t[i] = static_cast<float>(paneTransmittance(std::clamp(tn, 0.0, 1.0), double{m.ior}));
        }
        m.transmittance = {t[0], t[1], t[2]};
        return {};
    }

    /// dielectric, and interface where it is one against air.
    Result<void> solid() {
        const bool interface = p_.type == "interface";
        if (auto ok = need(interface ? 8 : 5); !ok) return ok;
        auto& m = out_.material;
        m.kind = MaterialKind::Dielectric;
        std::array<float, 3> t{};
        for (std::size_t i = 0; i < 3; ++i) t[i] = static_cast<float>(std::clamp(std::pow(std::max(0.0, fraction(i, "a transmittance of")), 1 / metresPerUnit_), 0.0, 1.0));
        m.transmittance = {t[0], t[1], t[2]};
        setIor(number(3));
        if (!interface) {
            if (number(4) != 0) warn(fmt::format("has a dispersion of {}: left out, the colours refract alike", number(4)));
            return {};
        }
        const bool air = number(7) == 1 && number(4) == 1 && number(5) == 1 && number(6) == 1;
        if (!air) {
            setIor(number(3) / std::max(number(7), 1e-6));
            warn("stands against another medium than air: taken as a solid in air with the ratio of the indices");
        }
        return {};
    }

    void setIor(double ior) {
        if (!(ior >= 1 && ior <= 4)) warn(fmt::format("has a refractive index of {}: taken as {}, expected 1 to 4", ior, std::clamp(ior, 1.0, 4.0)));
        out_.material.ior = static_cast<float>(std::clamp(ior, 1.0, 4.0));
    }

    Result<void> emitter() {
        if (auto ok = need(p_.type == "spotlight" ? 7 : p_.type == "glow" ? 4 : 3); !ok) return ok;
        auto& m = out_.material;
        m.kind = MaterialKind::Matte;
        std::array<float, 3> radiance{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (number(i) < 0 || number(i) > 1e30) warn(fmt::format("has a radiance of {}: taken as 0, expected 0 or more", number(i)));
            else radiance[i] = static_cast<float>(number(i) * kLumensPerWatt);
        }
        m.emission = {radiance[0], radiance[1], radiance[2]};
        if (p_.type == "glow" && number(3) < 0) m.emissionLights = false;  // seen alone
        const bool replaced = p_.type == "illum" && !p_.strings.empty();
        if (replaced && p_.strings[0] == "void") {  // seen through: the emission of a pane of air
            m.kind = MaterialKind::ThinGlass;
            m.ior = 1;
            m.transmittance = Rgb(1.0F);
        } else if (replaced) {
            warn(fmt::format("stands for light from behind {}: taken as a light that lets nothing through", p_.strings[0]));
        }
        if (p_.type == "spotlight") return spot();
        return {};
    }

    Result<void> spot() {
        const Vec3d axis(number(4), number(5), number(6));
        Vec3d turned(0, 0, 0);
        turn_.multDirMatrix(axis, turned);
        if (!(turned.length() > 0)) return p_.place.error(ErrorCode::Parse, fmt::format("spotlight {} has the direction 0 0 0, expected another", p_.name));
        if (number(3) < 360) out_.cone = std::make_shared<const SpotCone>(Vec3(turned.normalized()), number(3) / 2);
        return {};
    }

    const Primitive& p_;
    double metresPerUnit_;
    const Matrix4d& turn_;
    WarningList& warnings_;
    MappedMaterial out_;
};

double surfaceReflectance(double ior) {
    const double ratio = (ior - 1) / (ior + 1);
    return ratio * ratio;
}

}  // namespace

bool isMaterial(std::string_view type) { return isEmitter(type) || isOneOf(type, kRead) || isOneOf(type, kRefused); }

bool isEmitter(std::string_view type) { return isOneOf(type, kEmitters); }

double paneTransmittance(double t, double ior) {
    const double r = surfaceReflectance(ior);
    return (1 - r) * (1 - r) * t / (1 - r * r * t * t);
}

double paneTransmissivity(double transmittance, double ior) {
    // The positive root of T r^2 t^2 + (1 - r)^2 t - T = 0, in a form that stays exact as r vanishes.
    const double r = surfaceReflectance(ior), b = (1 - r) * (1 - r);
    return 2 * transmittance / (b + std::sqrt(b * b + 4 * r * r * transmittance * transmittance));
}

Result<MappedMaterial> mapMaterial(const Primitive& primitive, double metresPerUnit, const Matrix4d& turn, WarningList& warnings) {
    return Mapper(primitive, metresPerUnit, turn, warnings).map();
}

}  // namespace luxdeck::rad

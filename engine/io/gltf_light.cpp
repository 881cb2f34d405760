#include "engine/io/gltf_light.h"

#include "engine/io/gltf_uri.h"
#include "engine/io/photometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace luxdeck::gltf {

namespace {

/// Steps between the inner and the outer cone. The table is linear between them: the relative error of a
/// parabola cut into n pieces is at most 1 / (4 n^2) of the peak, 6e-5 here.
constexpr int kConeSteps = 64;

/// The frame of a node, without its scale; none when the scale has squashed it.
std::optional<Frame> frameOf(const Matrix4d& m) {
    Vec3d x(m[0][0], m[0][1], m[0][2]);
    Vec3d z(m[2][0], m[2][1], m[2][2]);
    if (!(z.length() > 0) || !isFinite(z)) return std::nullopt;
    z /= z.length();
    x -= z * x.dot(z);
    if (!(x.length() > 0) || !isFinite(x)) return std::nullopt;
    x /= x.length();
    return Frame{Vec3(x), Vec3(z.cross(x)), Vec3(z)};
}

Rgb toRgb(const std::array<double, 3>& c) {
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

double luminanceOf(const std::array<double, 3>& c) { return kRec709.r * c[0] + kRec709.g * c[1] + kRec709.b * c[2]; }

bool anyNegative(const std::array<double, 3>& c) { return *std::min_element(c.begin(), c.end()) < 0; }

}  // namespace

Result<CandelaTable> spotTable(double candela, double innerRad, double outerRad) {
    std::vector<double> angles{0}, values{candela};
    const double cosInner = std::cos(innerRad), cosOuter = std::cos(outerRad);
    for (int i = innerRad > 0 ? 0 : 1; i <= kConeSteps; ++i) {
        const double angle = innerRad + (outerRad - innerRad) * i / kConeSteps;
        const double part = std::clamp((std::cos(angle) - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
        angles.push_back(angle / kDegree);
        values.push_back(i == kConeSteps ? 0.0 : candela * part * part);
    }
    return CandelaTable::create(PhotometryType::C, std::move(angles), {0.0}, std::move(values));
}

std::int64_t LightReader::addType(LuminaireType type) {
    scene_.luminaireTypes.push_back(std::move(type));
    return static_cast<std::int64_t>(scene_.luminaireTypes.size()) - 1;
}

std::int64_t LightReader::makePunctual(const JsonView& light, std::size_t index) {
    const std::string kind = light["type"].text();
    const std::string name = light["name"].text(fmt::format("light {}", index));
    const auto colour = light["color"].numbers<3>({1, 1, 1});
    const double intensity = light["intensity"].number(1);
    if (kind != "point" && kind != "spot") light["type"].fail(fmt::format("is '{}', expected point, spot or directional", kind));
    if (intensity < 0 || anyNegative(colour)) light.fail("intensity and color must not be negative");
    if (light["range"].present()) document_.warnings.add("range", "light ranges are left out: light falls with the square of distance alone");
    const double inner = light["spot"]["innerConeAngle"].number(0);
    const double outer = light["spot"]["outerConeAngle"].number(kPiD / 4);
    if (kind == "spot" && !(inner >= 0 && inner < outer && outer <= kPiD / 2 + 1e-6))  // 1e-6: pi/2 written with few digits
        light["spot"].fail(fmt::format("cone angles are {:g} and {:g}, expected 0 <= inner < outer <= pi/2", inner, outer));
    const double luminance = luminanceOf(colour);
    if (document_.failure.failed() || luminance * intensity <= 0) return -1;

    // The renderer's light is color * intensity: its luminance goes into the candela, the rest is chromaticity.
    const double candela = intensity * luminance;
    auto table = kind == "spot"
                     ? spotTable(candela, inner, outer)
                     : CandelaTable::create(PhotometryType::C, {0.0, 180.0}, {0.0}, {candela, candela});
    if (!table) return light.fail(table.error().text()), -1;
    LuminaireType type;
    type.id = name;
    type.description = fmt::format("{} light of {:g} cd", kind, candela);
    type.file = light.path();
    type.colour = toRgb(colour) * static_cast<float>(1 / luminance);
    type.photometry.name = name;
    type.photometry.format = "KHR_lights_punctual";
    type.photometry.table = std::move(*table);
    type.photometry.symmetry = PhotometrySymmetry::Axial;
    type.photometry.lumensDeclared = type.photometry.table.lumens();
    type.photometry.absolute = true;
    return addType(std::move(type));
}

std::int64_t LightReader::punctualType(std::size_t index) {
    const auto [known, isNew] = punctualTypes_.try_emplace(index, -1);
    if (isNew) known->second = makePunctual(document_.root().extension("KHR_lights_punctual")["lights"].at(index), index);
    return known->second;
}

Result<Photometry> LightReader::loadProfile(const JsonView& profile) {
    const auto read = [&](std::string_view bytes, const std::filesystem::path& name) {
        if (auto tilt = readLampTilt(bytes, name)) profileTilt_ = *std::move(tilt);
        return readIes(bytes, name);
    };
    profileTilt_ = {};
    if (!profile["uri"].present()) {
        const auto view = profile["bufferView"].index(document_.bufferViewCount(), "bufferViews");
        if (document_.failure.failed()) return document_.failure.error();
        return read(document_.viewBytes(static_cast<std::size_t>(view)), document_.failure.file() + " " + profile.path());
    }
    const auto bytes = document_.load(profile["uri"]);
    if (!bytes) return bytes.error();
    const std::string uri = profile["uri"].text();
    const bool embedded = uri.starts_with("data:");
    const auto folder = std::filesystem::path(document_.failure.file()).parent_path();
    return read(*bytes, embedded ? std::filesystem::path(document_.failure.file() + " " + profile.path()) : folder / percentDecoded(uri));
}

std::int64_t LightReader::profileType(std::size_t index, const JsonView& colourJson) {
    auto colour = colourJson.numbers<3>({1, 1, 1});
    for (auto& c : colour) c = std::clamp(c, 0.0, 1.0);  // as the extension says
    const double luminance = luminanceOf(colour);
    if (document_.failure.failed() || luminance <= 0) return -1;
    const auto [known, isNew] = profileTypes_.try_emplace({index, colour}, -1);
    if (!isNew) return known->second;
    const auto profile = document_.root().extension("EXT_lights_ies")["lights"].at(index);
    auto photometry = loadProfile(profile);
    if (!photometry) {
        document_.failure.set(photometry.error());
        return -1;
    }
    LuminaireType type;
    type.id = profile["name"].text(fmt::format("IES {}", index));
    type.description = photometry->name;
    const std::string uri = profile["uri"].text();
    type.file = uri.starts_with("data:") || uri.empty() ? profile.path() : uri;
    type.colour = toRgb(colour) * static_cast<float>(1 / luminance);
    type.watts = photometry->watts;
    type.photometry = std::move(*photometry);
    known->second = addType(std::move(type));
    tilts_[static_cast<std::uint32_t>(known->second)] = std::move(profileTilt_);
    return known->second;
}

void LightReader::place(std::int64_t type, const std::string& name, const Matrix4d& world, double fluxScale) {
    if (type < 0 || document_.failure.failed()) return;
    const auto frame = frameOf(world);
    const Vec3d position(world[3][0], world[3][1], world[3][2]);
    if (!frame || !isFinite(Vec3(position)))
        return document_.failure.set("", fmt::format("light of node '{}': its transform has no direction or no finite place", name));
    Luminaire luminaire;
    luminaire.name = name;
    luminaire.type = static_cast<std::uint32_t>(type);
    luminaire.frame = *frame;
    const auto tilt = tilts_.find(luminaire.type);
    luminaire.fluxScale = fluxScale * (tilt == tilts_.end() ? 1.0 : tilt->second.factor(luminaire.frame));
    scene_.luminaires.push_back(std::move(luminaire));
    positions_.push_back(position);
}

/// It shines along the node's -z, wherever the node is; its intensity is in lx on a surface that faces it. The format
/// gives no size: it gets the sun's, 0.533 degrees.
void LightReader::addSun(const JsonView& light, const std::string& name, const Matrix4d& world) {
    const auto colour = light["color"].numbers<3>({1, 1, 1});
    const double lux = light["intensity"].number(1);
    if (lux < 0 || anyNegative(colour)) light.fail("intensity and color must not be negative");
    const double luminance = luminanceOf(colour);
    if (document_.failure.failed()) return;
    const auto frame = frameOf(world);
    if (!frame)
        return document_.failure.set("", fmt::format("light of node '{}': its transform has no direction", name));
    if (luminance * lux <= 0) return;
    const Rgb chromaticity = toRgb(colour) * static_cast<float>(1 / luminance);
    scene_.sky.suns.push_back(Sun::ofNormalLux(frame->normal, lux * luminance, chromaticity));
}

void LightReader::readNode(const JsonView& node, const std::string& name, const Matrix4d& world) {
    if (const auto light = node.extension("KHR_lights_punctual"); light.present()) {
        const auto count = document_.root().extension("KHR_lights_punctual")["lights"].size();
        const auto index = light["light"].index(count, "lights");
        if (index < 0) return;
        const auto lights = document_.root().extension("KHR_lights_punctual")["lights"];
        const auto definition = lights.at(static_cast<std::size_t>(index));
        if (definition["type"].text() == "directional") addSun(definition, name, world);
        else place(punctualType(static_cast<std::size_t>(index)), name, world, 1);
    }
    if (const auto light = node.extension("EXT_lights_ies"); light.present()) {
        const auto count = document_.root().extension("EXT_lights_ies")["lights"].size();
        const auto index = light["light"].index(count, "lights");
        const double multiplier = light["multiplier"].number(1);
        if (multiplier < 0) light["multiplier"].fail(fmt::format("is {:g}, expected >= 0", multiplier));
        if (index < 0 || document_.failure.failed()) return;
        auto colour = light["color"].numbers<3>({1, 1, 1});
        for (auto& c : colour) c = std::clamp(c, 0.0, 1.0);
        place(profileType(static_cast<std::size_t>(index), light["color"]), name, world, multiplier * luminanceOf(colour));
    }
}

}  // namespace luxdeck::gltf

#include "analysis/validation/cie171_cases.h"
#include "engine/scene/sky_models.h"

#include <cstddef>

namespace luxdeck {

std::vector<Cie171Case> cie171Cases() {
    cie171::Cases cases;
    cie171::addLampCases(cases);
    cie171::addFluxCases(cases);
    cie171::addGlassCases(cases);
    cie171::addReflectionCases(cases);
    cie171::addRoofCases(cases);
    cie171::addFacadeCases(cases);
    return cases;
}

namespace cie171 {

void integrateOver(const Patch& patch, const Vec3d& normal, int n, Cie171Quantity& quantity) {
    const auto rule = gaussRule(n);
    for (std::size_t j = 0; j < rule.points.size(); ++j)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            quantity.sensors.push_back(sensorAt(patch.corner + patch.u * rule.points[i] + patch.v * rule.points[j], normal));
            quantity.weights.push_back(patch.area() * rule.weights[i] * rule.weights[j]);
        }
}

Patch holeIn(const Patch& wall, const Hole& hole) {
    return {wall.corner + wall.u * hole.s0 + wall.v * hole.t0, wall.u * (hole.s1 - hole.s0), wall.v * (hole.t1 - hole.t0)};
}

void addWall(SceneBuilder& builder, const Patch& wall, const Hole& hole, std::uint32_t material) {
    for (const auto& part : {Hole{0, 1, 0, hole.t0}, Hole{0, 1, hole.t1, 1}, Hole{0, hole.s0, hole.t0, hole.t1}, Hole{hole.s1, 1, hole.t0, hole.t1}})
        if (part.s1 > part.s0 && part.t1 > part.t0) addQuad(builder, holeIn(wall, part), material);
}

Patch faceOf(const Vec3d& low, const Vec3d& high, Face face) {
    const Vec3d d = high - low, x{d.x, 0, 0}, y{0, d.y, 0}, z{0, 0, d.z};
    switch (face) {
        case Face::West: return {low, y, z};
        case Face::East: return {low + x, y, z};
        case Face::South: return {low, x, z};
        case Face::North: return {low + y, x, z};
        case Face::Floor: return {low, x, y};
        case Face::Ceiling: return {low + z, x, y};
    }
    return {};
}

void addOtherFaces(SceneBuilder& builder, const Vec3d& low, const Vec3d& high, Face open, std::uint32_t material) {
    for (const auto face : {Face::West, Face::East, Face::South, Face::North, Face::Floor, Face::Ceiling})
        if (face != open) addQuad(builder, faceOf(low, high, face), material);
}

Material clearGlass() {
    Material m;
    m.name = "clear glass, 6 mm", m.kind = MaterialKind::ThinGlass;
    m.transmittance = Rgb(static_cast<float>(kGlassTransmittance)), m.ior = static_cast<float>(kGlassIor);
    return m;
}

Sky engineSky(const ReferenceSky& sky, double groundReflectance) {
    Sky out(SkyKind::Uniform, kZenithCdM2);
    if (sky.type == 16) out.kind = SkyKind::CieOvercast;
    else if (sky.type > 0) out = cieGeneralSky(sky.type, Vec3(sky.sun));
    out.zenithCdM2 = kZenithCdM2;
    // Given: else the engine integrates the sky whenever it is asked for the ground.
    out.groundCdM2 = groundReflectance * sky.horizontal().value * kZenithCdM2 / kPiD;
    return out;
}

std::string nameOf(const ReferenceSky& sky) {
    if (sky.type == 0) return "uniform sky";
    return sky.type == 16 ? "overcast sky" : "CIE sky " + std::to_string(sky.type);
}

}  // namespace cie171
}  // namespace luxdeck

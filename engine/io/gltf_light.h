#pragma once

#include "engine/io/gltf_document.h"
#include "engine/io/ies_tilt.h"
#include "engine/scene/scene.h"

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace luxdeck::gltf {

/// Turns the lights that nodes carry (KHR_lights_punctual, EXT_lights_ies) into luminaires, directional ones into
/// suns. All shine along
/// the node's -z, which is also where a luminaire's nadir points in its own frame.
class LightReader {
public:
    LightReader(Document& document, Scene& scene) : document_(document), scene_(scene) {}

    /// The lights of one node.
    ///
    /// world  from the node's coordinates to the project's
    void readNode(const JsonView& node, const std::string& name, const Matrix4d& world);

    [[nodiscard]] const std::vector<Vec3d>& positions() const { return positions_; }  ///< of Scene::luminaires [m]

private:
    using ProfileKey = std::tuple<std::size_t, std::array<double, 3>>;  // light, colour

    std::int64_t punctualType(std::size_t index);
    std::int64_t makePunctual(const JsonView& light, std::size_t index);
    std::int64_t profileType(std::size_t index, const JsonView& colour);
    Result<Photometry> loadProfile(const JsonView& profile);
    std::int64_t addType(LuminaireType type);
    void addSun(const JsonView& light, const std::string& name, const Matrix4d& world);
    void place(std::int64_t type, const std::string& name, const Matrix4d& world, double fluxScale);

    Document& document_;
    Scene& scene_;
    std::vector<Vec3d> positions_;
    std::map<std::size_t, std::int64_t> punctualTypes_;  // -1: not a luminaire
    std::map<ProfileKey, std::int64_t> profileTypes_;
    std::map<std::uint32_t, LampTilt> tilts_;            // by type
    LampTilt profileTilt_;                               // of the profile read last
};

/// The intensity of a spot by angle from its axis, tabulated. Source: KHR_lights_punctual, "Inner and outer
/// cone angles": clamp((cos a - cos outer) / (cos inner - cos outer))^2.
///
/// innerRad, outerRad  0 <= inner < outer <= pi / 2
Result<CandelaTable> spotTable(double candela, double innerRad, double outerRad);

}  // namespace luxdeck::gltf

#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/scene/luminaire.h"
#include "engine/scene/material.h"
#include "engine/scene/mesh.h"
#include "engine/scene/pattern.h"
#include "engine/scene/sky.h"
#include "engine/scene/texture.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck {

/// Everything that light meets, in metres, z up, re-based: user coordinates = re-based + origin.
/// Built by engine/io or by tests, checked once by validate(), then read only.
struct Scene {
    std::string name;
    Vec3d origin{0, 0, 0};             ///< of the re-based coordinates, in the user's [m]
    std::vector<SceneObject> objects;
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<std::shared_ptr<const Pattern>> patterns;  ///< shared: a scene may be copied
    std::vector<LuminaireType> luminaireTypes;
    std::vector<Luminaire> luminaires;
    Sky sky;
    LuminanceWeights weights;          ///< of the working space
    std::string hash;                  ///< of geometry, materials, luminaires and sky
    std::vector<std::string> warnings; ///< from reading: what was repaired or looks wrong

    [[nodiscard]] std::size_t triangleCount() const;
    /// Part of the light that meets the material goes on in its direction: panes, holes, mixtures with them.
    /// Shadow rays ask such surfaces how much; all others hide what lies behind them.
    [[nodiscard]] bool letsStraightThrough(const Material& material) const;
    /// Bounds of all meshes and luminaires, re-based [m]; empty for an empty scene.
    [[nodiscard]] Box3 bounds() const;
    [[nodiscard]] Vec3 toRebased(const Vec3d& user) const { return Vec3(user - origin); }
    [[nodiscard]] Vec3d toUser(const Vec3& rebased) const { return Vec3d(rebased) + origin; }
};

/// Checks what every stage relies on: indices in range, finite coordinates, reflectances in 0..1 that
/// conserve energy, finite non-negative emission. Triangles without area, or that shine twice, are dropped with a warning.
///
/// errors  InvalidArgument naming mesh or material, index, value seen and value expected
Result<void> validate(Scene& scene);

/// The content hash of everything that changes the light (not names, not warnings).
std::string sceneHash(const Scene& scene);

}  // namespace luxdeck

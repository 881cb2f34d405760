#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace luxdeck {

/// A camera found in a file, in the file's coordinates after `GeometryPlacement`.
struct SceneCamera {
    std::string name;
    Vec3d position, direction, up;
    double verticalFovDeg = 50;
};

/// How a file's coordinates become the project's metres, z up.
struct GeometryPlacement {
    double metresPerUnit = 1;
    bool yUp = false;           ///< the file's y is up (glTF always): (x, y, z) -> (x, -z, y)
    Matrix4d transform;         ///< afterwards, in metres; Imath row vectors
};

/// What a geometry file holds. Its scene has an origin of its own: readers place vertices in double and
/// store them relative to chooseOrigin() of their bounds, so that coordinates of 10^6 m lose nothing.
struct ScenePart {
    Scene scene;
    std::vector<SceneCamera> cameras;
};

/// The re-based origin for a scene of these bounds: zero when they lie near the origin, else their centre,
/// rounded to whole metres so that the shift is exact.
Vec3d chooseOrigin(const Box3d& bounds);

/// glTF and GLB. Lights of KHR_lights_punctual (point, spot) and EXT_lights_ies become luminaires, directional ones
/// suns of the scene's sky.
///
/// errors  FileNotFound, Parse, Unsupported; nothing is allocated that the file's size does not justify
Result<ScenePart> readGltf(const std::filesystem::path& path, const GeometryPlacement& placement);

/// OBJ with its MTL.
Result<ScenePart> readObj(const std::filesystem::path& path, const GeometryPlacement& placement);

/// Radiance: files read in their order as one (engine/io/rad_reader.h).
bool isRadianceFile(const std::filesystem::path& path);

/// glTF, OBJ or Radiance, by extension.
Result<ScenePart> readSceneFile(const std::filesystem::path& path, const GeometryPlacement& placement);

/// Appends a part's objects, meshes, materials, textures, patterns, luminaires, suns and domes of the sky, moving its
/// indices and its origin. The first part's origin and luminance weights become the scene's; the colours of a part
/// with other weights are converted, their luminance kept.
void append(Scene& scene, ScenePart part);

}  // namespace luxdeck

#pragma once

#include "engine/core/result.h"
#include "engine/io/project.h"
#include "engine/scene/object_pose.h"
#include "engine/scene/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace luxdeck {

/// A coarse set of vertices that stands for all of an object while it moves.
struct DetailLevel {
    std::vector<std::uint32_t> shown;     // vertices that are lit
    std::vector<std::uint32_t> standsFor; // #V, index into `shown`: whose light a vertex has
};

struct ObjectSettings {
    double longestEdgeM = 0.1;   // triangles are divided until their edges are no longer: light varies across a desk's two triangles
    int levels = 3;              // of detail beside the finest, 0 .. 6
};

/// One thing that may be moved, as a mesh of its own: vertices in its own frame (pivot: centre of its bounds, at its foot),
/// each with its normal, fine enough to carry light.
struct MovableObject {
    std::string name;
    Vec3d pivot{0, 0, 0};                 // where the frame's origin was, re-based [m]
    std::vector<Vec3> positions;          // #V, own frame [m]
    std::vector<Vec3> normals;            // #V, unit
    std::vector<Rgb> reflectance;         // #V, diffuse, without textures [-]
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint8_t> solid;      // #T, 0: a pane, which hides nothing
    std::vector<float> workingAreaM2;     // #V, of the working surface: what the vertex counts in its statistics
    double workingSurfaceM2 = 0;          // 0: the object has none
    std::vector<DetailLevel> levels;      // finest first: levels[0] is all vertices
    std::vector<std::string> warnings;    // what is not done for it: its own lights, textures

    [[nodiscard]] Placement placed(const Pose& pose) const { return placementOf(pivot, pose); }
};

/// Makes the object of all meshes of one of the scene's objects.
///
/// The working surface is what faces up within 15 degrees in the highest band of 5 cm that holds at least half as much
/// of such area as the fullest: a desk's top, neither the foot below it nor the rim of a drawer.
///
/// errors  InvalidArgument: no such object (the movable ones are listed), an object without triangles, a vertex that is not
///         finite, settings out of range; OutOfResources: more than 20 million vertices
Result<MovableObject> makeMovableObject(const Scene& scene, const std::string& name, const ObjectSettings& settings = {});
/// The same of all objects of a scene together: a model in a file of its own.
Result<MovableObject> makeMovableObject(const Scene& scene, const ObjectSettings& settings = {});

/// The scene without an object: what its volume is of. errors  InvalidArgument: no such object
Result<Scene> withoutObject(const Scene& scene, const std::string& name);
/// The scene with an object added at a pose: the named one of `from`, which has the scene's materials; with an empty name
/// all of `from`, a model with materials of its own (whose pictures and patterns are left out).
Scene withObjectAt(const Scene& scene, const Scene& from, const std::string& name, const MovableObject& object, const Pose& pose);

}  // namespace luxdeck

#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/scene/scene.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

/// A limit to be met, the user's own data. Absent values are not required.
struct Requirement {
    std::string name;                       ///< "Office: writing, reading"
    std::string source;                     ///< where the numbers are from
    std::optional<double> meanLux;          ///< Ēm >= [lx]
    std::optional<double> minimumLux;       ///< Emin >= [lx]
    std::optional<double> uniformity;       ///< Uo >= [-]
    std::string where;                      ///< file:line, for messages
};

enum class GridKind { Planar, Cylindrical };

/// Where illuminance is asked for. A surface (origin, u, v spans it; its normal is u x v) is divided by
/// EN 12464-1's spacing formula unless `spacingM` or `counts` says otherwise; free points stand for themselves.
struct CalculationGrid {
    std::string name;
    GridKind kind = GridKind::Planar;
    Vec3d origin{0, 0, 0};                  ///< a corner [m], user coordinates
    Vec3d u{0, 0, 0};                       ///< edges of the surface [m]
    Vec3d v{0, 0, 0};
    double borderM = 0;                     ///< zone along the edges that is left out [m]
    std::optional<double> spacingM;
    std::optional<std::array<int, 2>> counts;
    std::vector<std::array<Vec3d, 2>> points;  ///< free points: position [m], normal; used when not empty
    std::vector<Requirement> requirements;
    std::string where;
};

enum class ViewKind { Perspective, Fisheye };

struct View {
    std::string name;
    ViewKind kind = ViewKind::Perspective;  ///< Fisheye: angular (r proportional to theta), 180 degrees
    Vec3d position{0, 0, 0};                ///< [m], user coordinates
    Vec3d direction{0, 1, 0};               ///< unit
    Vec3d up{0, 0, 1};
    double verticalFovDeg = 50;
    int width = 1200;
    int height = 800;
    std::string where;
};

/// An irradiance volume to be built (engine/volume).
struct VolumeSpec {
    std::string name;
    Vec3d min{0, 0, 0}, max{0, 0, 0};       ///< [m], user coordinates
    std::array<int, 3> firstLevel{7, 7, 7};
    int secondLevel = 3;
    int bins = 17;                          ///< n: 2 x n^2 directions a vertex
    std::string where;
};

/// A holodeck section (engine/holodeck): a parallelepiped with a grid on its walls.
struct HolodeckSection {
    std::string name;
    Vec3d origin{0, 0, 0};
    std::array<Vec3d, 3> axes;              ///< edges [m]
    std::array<int, 3> grid{8, 8, 8};       ///< cells along each axis, 1..64
    std::string where;
};

/// What the report's cover says.
struct ProjectInfo {
    std::string name;
    std::string client;
    std::string designer;
    std::string location;
    std::string date;
    std::string description;
    std::vector<std::string> notes;
};

/// A project file with everything it names, read and checked.
struct Project {
    ProjectInfo info;
    Scene scene;
    std::vector<CalculationGrid> grids;
    std::vector<View> views;
    std::vector<VolumeSpec> volumes;
    std::vector<HolodeckSection> holodeckSections;
    std::filesystem::path file;
    std::string fileHash;                   ///< of project.toml itself
};

/// Reads a project.toml, or makes a project without grids of a bare scene (.glb, .gltf, .obj, or Radiance's .rad and
/// .mat, as many as are to be read together, in their order): its cameras become views; without one, a view from a
/// corner of its bounds.
///
/// errors  FileNotFound, Parse, Unsupported, InvalidArgument: "file:line: what was seen, what was expected"
Result<Project> loadProject(const std::filesystem::path& path);
Result<Project> loadProject(const std::vector<std::filesystem::path>& paths);
/// The same of a project file's text that is not saved yet; the files it names are looked for beside `file`.
Result<Project> loadProjectText(const std::filesystem::path& file, const std::string& text);

}  // namespace luxdeck

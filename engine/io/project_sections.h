#pragma once

#include "engine/io/project.h"
#include "engine/io/scene_files.h"
#include "engine/io/toml_reader.h"
#include "engine/scene/object_pose.h"
#include "engine/scene/sun_position.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The parts of a project file. Reading goes in two passes: read...() turn tables into the specs below and tell
/// Diagnostics what is wrong, touching no file but to see that it is there; then load...() and place...() open the
/// files and build the scene. So a slip in the last line is reported before a large model is read.
namespace luxdeck::project {

inline constexpr std::size_t kMaxLuminaires = 1'000'000;
inline constexpr std::size_t kMaxGridPoints = 1'000'000;  ///< of one grid

/// A file that the project names.
struct FileReference {
    std::filesystem::path path;  ///< as it is opened
    std::string shown;           ///< as the project names it
    std::string where;           ///< file:line that names it
};

struct GeometrySpec {
    FileReference file;
    GeometryPlacement placement;
};

/// Furniture: an object of the geometry, or a file of its own.
struct FurnitureSpec {
    std::string name;                   ///< of the object
    std::optional<GeometrySpec> file;
    bool movable = true;
    Pose pose;                          ///< of an object of the geometry, from where that has it
    std::string where;
};

struct MaterialSpec {
    Material material;
    std::string where;
};

struct LuminaireTypeSpec {
    std::string id;
    std::string description;
    FileReference file;
    std::optional<double> lumens;       ///< luminaire flux wanted [lm]
    std::optional<double> watts;
    double maintenanceFactor = 1;
    Rgb colour{1.0F};
    bool lampTilt = true;               ///< apply the file's TILT
};

struct LuminaireSpec {
    std::size_t type = 0;               ///< index into the project's types
    std::string name;                   ///< empty: numbered
    Vec3d position;                     ///< [m], user coordinates
    Frame frame;
    std::optional<Frame> uprightFrame;  ///< types A and B: aimed without a rotation, their up is up
    double dimming = 1;
    std::optional<double> maintenanceFactor;
    std::array<int, 2> count{1, 1};
    std::array<double, 2> spacingM{0, 0};
    std::string where;
};

enum class SkyModel { None, Uniform, CieOvercast, CieClear, CieIntermediate, CieGeneral, Perez };

/// What the project says of the sky; which of the amounts are there depends on the model.
struct SkySpec {
    SkyModel model = SkyModel::None;
    int type = 1;                       ///< of the CIE general sky
    double groundReflectance = 0.2;
    bool sun = true;
    std::optional<double> zenithCdM2, horizontalLux, sunLux;
    double directNormalWm2 = 0, diffuseHorizontalWm2 = 0;
    std::optional<double> dewPointC;
    std::optional<SolarAngles> angles;  ///< given instead of place and time
    Site site;
    ClockTime time;
    std::optional<FileReference> weather;
    std::string where;                  ///< file:line
};

/// A requirement and the id that grids name it by.
struct NamedRequirement {
    std::string id;
    Requirement requirement;
};

/// Everything that the project file says.
struct ProjectSpec {
    ProjectInfo info;
    std::vector<GeometrySpec> geometry;
    std::vector<FurnitureSpec> furniture;
    std::vector<MaterialSpec> materials;
    std::vector<LuminaireTypeSpec> luminaireTypes;
    std::vector<LuminaireSpec> luminaires;
    SkySpec sky;
    std::vector<CalculationGrid> grids;
    std::vector<View> views;
    std::vector<VolumeSpec> volumes;
    std::vector<HolodeckSection> holodeckSections;
};

/// What others refer to by id, in the order of a vector beside it.
class Ids {
public:
    void add(const std::string& id) {
        index_.emplace(id, names_.size());
        names_.push_back(id);
    }
    [[nodiscard]] std::optional<std::size_t> find(const std::string& id) const {
        const auto at = index_.find(id);
        return at != index_.end() ? std::optional(at->second) : std::nullopt;
    }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

private:
    std::map<std::string, std::size_t> index_;
    std::vector<std::string> names_;
};

/// Refuses a name that was there before, in file order.
class UniqueNames {
public:
    void add(const TomlTable& table, std::string_view key, const std::string& name);

private:
    std::map<std::string, std::string> firstWhere_;
};

/// The file that `key` names, relative to the project's folder; an error, and no path, when it is not there.
FileReference readFileReference(const TomlTable& table, std::string_view key, const std::filesystem::path& folder);

/// What went wrong in a file that the project names, told from the line that names it:
/// `project.toml:17: luminaire type "A" -> luminaires/a.ies:12: ...`.
Error inNamedFile(const Error& error, const std::string& subject, const FileReference& file);

std::vector<GeometrySpec> readGeometry(const TomlTable& root, const std::filesystem::path& folder);
std::vector<FurnitureSpec> readFurniture(const TomlTable& root, const std::filesystem::path& folder);
std::vector<MaterialSpec> readMaterials(const TomlTable& root);
std::vector<LuminaireTypeSpec> readLuminaireTypes(const TomlTable& root, const std::filesystem::path& folder);
std::vector<LuminaireSpec> readLuminaires(const TomlTable& root, const std::vector<LuminaireTypeSpec>& types);
SkySpec readSky(const TomlTable& root, const std::filesystem::path& folder);
std::vector<NamedRequirement> readRequirements(const TomlTable& root, UniqueNames& ids);
std::vector<CalculationGrid> readGrids(const TomlTable& root, const std::vector<NamedRequirement>& requirements);
std::vector<View> readViews(const TomlTable& root);
std::vector<VolumeSpec> readVolumes(const TomlTable& root);
std::vector<HolodeckSection> readHolodeckSections(const TomlTable& root);

/// Reads the geometry and furniture into the scene, flags what may be moved and moves what has been. Returns the cameras found.
Result<std::vector<SceneCamera>> loadGeometry(Scene& scene, const ProjectSpec& spec);
Result<void> replaceMaterials(Scene& scene, const std::vector<MaterialSpec>& materials);
Result<std::vector<LuminaireType>> loadLuminaireTypes(const ProjectSpec& spec);
/// Places the luminaires in a scene whose geometry, and so origin, is there.
Result<void> placeLuminaires(Scene& scene, const ProjectSpec& spec, std::vector<LuminaireType> types);

/// Cameras as views; names are made unique.
std::vector<View> viewsOf(const std::vector<SceneCamera>& cameras, const std::string& where);
/// From a corner of the bounds [user coordinates, m], at eye height, towards their middle.
View cornerView(const Box3d& bounds);

}  // namespace luxdeck::project

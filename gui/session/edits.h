#pragma once

#include "engine/algorithms/lit_project.h"
#include "engine/scene/object_pose.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What designers change, as edits of the project's text for Session::edit(). Comments, order and layout stay.
///
///     session.edit("Dim A3", edits::changeLuminaires(session.project(), {i}, {.dimming = 0.5}));
///
/// Indices are those of the project that is shown (scene.luminaires, grids, views); an edit whose text has meanwhile become
/// another project's is refused. Coordinates are the user's [m].
namespace luxdeck::gui::edits {

using Edit = std::function<Result<std::string>(const std::string&)>;
using Shown = std::shared_ptr<const LitProject>;

// ---- luminaires ----

/// What becomes of each; what is empty stays.
struct LuminaireChange {
    std::optional<Vec3d> position;       ///< of the photometric centre
    std::optional<Vec3d> moveBy;
    std::optional<Vec3d> aim;            ///< of any length
    std::optional<double> rotationDeg;   ///< C0 towards C90, about the aim
    std::optional<double> dimming;       ///< 0 (off) .. 1
    std::optional<std::string> name;
    std::optional<std::string> type;     ///< id
};

/// What the project says of a luminaire, for fields that show it.
struct LuminairePlaced {
    Vec3d position{0, 0, 0};
    Vec3d aim{0, 0, -1};
    double rotationDeg = 0;
    double dimming = 1;
    std::string name, type;
    bool inArray = false;                ///< one of rows that are written together
};

/// errors  InvalidArgument: it is a light of a geometry file
Result<LuminairePlaced> placedLuminaire(const Project& project, const std::string& text, std::size_t luminaire);
/// Rows of which only some are changed are written as single luminaires from then on; all keep their names.
Edit changeLuminaires(Shown project, std::vector<std::size_t> luminaires, LuminaireChange change);
/// Off is dimmed to nothing; on is full output.
Edit switchLuminaires(Shown project, std::vector<std::size_t> luminaires, bool on);
/// Those that have no name in the text are numbered anew.
Edit removeLuminaires(Shown project, std::vector<std::size_t> luminaires);
Edit duplicateLuminaire(Shown project, std::size_t luminaire, Vec3d moveBy);
Edit addLuminaire(std::string type, Vec3d position);
std::vector<std::size_t> luminairesOfType(const Project& project, std::size_t type);

// ---- files ----

/// A file as the project will name it.
struct FileForProject {
    std::string shown;    ///< relative to the project's folder
    bool copied = false;  ///< it was elsewhere, and now has a copy in the project's folder
};
/// A photometric file below the project's folder is named as it is; one from elsewhere is copied into the folder's
/// "luminaires", never over another file, so that the folder holds the whole project.
///
/// errors  of reading and writing: nothing is copied
Result<FileForProject> photometryForProject(const std::filesystem::path& project, const std::filesystem::path& file);
/// Models are named where they are: they have pictures and materials beside them.
FileForProject geometryForProject(const std::filesystem::path& project, const std::filesystem::path& file);

Edit exchangePhotometry(std::string typeId, std::string shown);
/// With an id of its own, "A" .. "Z", "T27" ..., if none is given.
Edit addLuminaireType(std::string shown, std::string description, std::string id = {});
/// How a model's numbers are to be taken; empty: as its format says.
struct ModelUnit {
    std::string unit;  ///< "m", "cm", "mm", "in", "ft"; needed for OBJ
    std::string up;    ///< "y", "z"
};
Edit addGeometry(std::string shown, ModelUnit unit);
Edit addFurniture(std::string shown, ModelUnit unit, Vec3d position);

// ---- furniture ----

/// Moves an object from where it is shown: about its pivot, as live furniture has it (Pose).
///
/// errors  InvalidArgument: several objects of that name
Edit moveObject(Shown project, std::string object, Pose pose);
Edit setMovable(Shown project, std::string object, bool movable);

// ---- calculation surfaces, views, words ----

/// What becomes of a grid; what is empty stays. An empty requirement is taken away.
struct GridChange {
    std::optional<std::string> name;
    std::optional<Vec3d> origin, u, v;
    std::optional<double> spacingM, borderM;
    std::optional<std::array<int, 2>> counts;
    std::optional<std::string> requirement;  ///< id
};
Edit addGrid(GridChange grid);
Edit changeGrid(std::size_t grid, GridChange change);
Edit removeGrid(std::size_t grid);
/// Ids that grids of this text may name, of the text itself and those that its grids use.
std::vector<std::string> requirementIds(const std::string& text);
/// Of a grid; empty: none.
std::string requirementId(const std::string& text, std::size_t grid);

/// In a project whose views are its models' cameras these are written down too: they would be gone else.
Edit addView(Shown project, View view);
Edit changeView(std::size_t index, View view);
Edit renameView(std::size_t index, std::string name);
Edit removeView(std::size_t index);

/// key  "name", "client", "designer", "location", "date", "description"; an empty value takes it away
Edit setInfo(std::string key, std::string value);

}  // namespace luxdeck::gui::edits

#pragma once

#include "analysis/photometry/photometry_summary.h"
#include "engine/core/vec.h"
#include "gui/session/units.h"
#include "gui/session/workplace.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::gui {

enum class ImportKind { Project, Photometry, Geometry, Volume, Unknown };

/// What a file that was dropped is, found by reading it. Nothing is changed by looking.
struct ImportedFile {
    std::filesystem::path file;
    ImportKind kind = ImportKind::Unknown;
    std::string what;                        ///< "Photometric file (LM-63-2002)", "Model"
    std::vector<std::string> facts;          ///< a line each, for people
    std::vector<std::string> repairs;        ///< what was put right in reading, and why
    std::vector<std::string> warnings;       ///< what looks wrong
    std::optional<Error> refused;            ///< why it cannot be used: "file:line: seen, expected"
    bool needsUnit = false;                  ///< an OBJ does not say what its numbers are: ask, then addGeometry()

    std::shared_ptr<const CheckedFile> photometry;  ///< for its drawing
    std::size_t triangles = 0, objects = 0, materials = 0, luminaires = 0;
    Box3d bounds;                            ///< [m], as its format says or in metres
};

/// By its name alone.
ImportKind importKindOf(const std::filesystem::path& file);
/// Reads it. Safe on any thread.
ImportedFile lookAtFile(const std::filesystem::path& file, const Units& units = {});

/// Files that were dropped on the window, read in the background (Change::Import when there is something new).
///
/// What is to be done with one is an edit: photometryForProject() and exchangePhotometry() or addLuminaireType(),
/// geometryForProject() and addGeometry() or addFurniture(); a project is opened, a volume taken by Volumes::open().
class Importing {
public:
    explicit Importing(Workplace& place) : place_(place) {}

    /// Replaces what was found before.
    void look(const std::vector<std::filesystem::path>& files, const Units& units = {});
    [[nodiscard]] bool looking() const { return place_.jobs.running(JobKind::Import); }
    [[nodiscard]] const std::vector<ImportedFile>& found() const { return found_; }
    void clear();

private:
    Workplace& place_;
    std::vector<ImportedFile> found_;
    std::uint64_t round_ = 0;
};

}  // namespace luxdeck::gui

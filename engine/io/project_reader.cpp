#include "engine/io/project.h"

#include "engine/core/file.h"
#include "engine/io/project_keys.h"
#include "engine/io/project_sections.h"
#include "engine/io/project_sky.h"
#include "engine/io/rad_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <new>
#include <system_error>
#include <utility>

namespace luxdeck {

namespace fs = std::filesystem;

namespace project {

namespace {
constexpr std::size_t kMaxPathBytes = 4096;
}

void UniqueNames::add(const TomlTable& table, std::string_view key, const std::string& name) {
    if (name.empty()) return;  // missing or empty: an error of its own
    const auto [first, isNew] = firstWhere_.emplace(name, table.where(key));
    if (!isNew)
        table.error(ErrorCode::InvalidArgument, key,
                    fmt::format("{} {} is taken: it stands at {} already", key, inQuotes(name), first->second));
}

FileReference readFileReference(const TomlTable& table, std::string_view key, const fs::path& folder) {
    FileReference file;
    file.shown = table.text(key);
    file.where = table.where(key);
    file.path = folder / file.shown;
    if (file.shown.empty()) return file;
    std::error_code ec;
    const auto status = fs::status(file.path, ec);
    if (file.shown.find('\0') == std::string::npos && fs::exists(status) && !fs::is_directory(status)) return file;
    table.error(ErrorCode::FileNotFound, key,
                fmt::format("{} {}", fs::is_directory(status) ? "is a folder, expected a file:" : "no such file:",
                            inQuotes(file.path.string(), kMaxPathBytes)));
    file.path.clear();
    return file;
}

Error inNamedFile(const Error& error, const std::string& subject, const FileReference& file) {
    // Readers call the file by the path it was opened with; the project's own name for it is shorter.
    auto text = error.text();
    const auto opened = file.path.string();
    if (text.starts_with(opened)) text.replace(0, opened.size(), file.shown);
    else if (!text.starts_with(file.shown)) text = fmt::format("{}: {}", file.shown, text);
    return {error.code, fmt::format("{} -> {}", subject, text), file.where};
}

}  // namespace project

namespace {

using namespace project;

constexpr std::uint64_t kMaxProjectBytes = 8U << 20U;  // 100,000 luminaires one by one; a mistaken model is refused at once
constexpr std::string_view kSchema = "luxdeck-project/1";
constexpr std::string_view kRequirementsSchema = "luxdeck-requirements/1";

void checkSchema(const TomlTable& root, std::string_view expected) {
    const auto seen = root.text("schema");
    if (!seen.empty() && seen != expected)
        root.error(ErrorCode::Unsupported, "schema", fmt::format("schema is {}, expected \"{}\"", inQuotes(seen), expected));
}

ProjectInfo readInfo(const TomlTable& root, const fs::path& file) {
    ProjectInfo info;
    info.name = file.stem().string();
    const auto table = root.table("project", kInfo);
    if (!table) return info;
    info.name = table->text("name", info.name);
    info.client = table->text("client", "");
    info.designer = table->text("designer", "");
    info.location = table->text("location", "");
    info.date = table->text("date", "");
    info.description = table->text("description", "");
    info.notes = table->texts("notes");
    return info;
}

/// The rows of the project and those of its requirements_file.
Result<std::vector<NamedRequirement>> readAllRequirements(const TomlTable& root, const fs::path& folder, Diagnostics& diagnostics) {
    UniqueNames ids;
    auto requirements = readRequirements(root, ids);
    if (!root.has("requirements_file")) return requirements;
    const auto file = readFileReference(root, "requirements_file", folder);
    if (file.path.empty()) return requirements;
    const auto bytes = readFile(file.path, kMaxProjectBytes);
    if (!bytes) return inNamedFile(bytes.error(), "requirements_file", file);
    const auto document = TomlDocument::parse(*bytes, file.path.string(), diagnostics);
    if (!document) return document.error();
    const auto rows = document->root(kRequirementsFile);
    if (rows.has("schema")) checkSchema(rows, kRequirementsSchema);
    auto more = readRequirements(rows, ids);
    std::move(more.begin(), more.end(), std::back_inserter(requirements));
    return requirements;
}

/// First pass: what the file says, and everything that is wrong with it.
Result<ProjectSpec> readSpec(const TomlTable& root, const fs::path& file, Diagnostics& diagnostics) {
    const auto folder = file.parent_path();
    checkSchema(root, kSchema);
    ProjectSpec spec;
    spec.info = readInfo(root, file);
    spec.geometry = readGeometry(root, folder);
    spec.furniture = readFurniture(root, folder);
    spec.materials = readMaterials(root);
    spec.luminaireTypes = readLuminaireTypes(root, folder);
    spec.luminaires = readLuminaires(root, spec.luminaireTypes);
    spec.sky = readSky(root, folder);
    const auto requirements = readAllRequirements(root, folder, diagnostics);
    if (!requirements) return requirements.error();
    spec.grids = readGrids(root, *requirements);
    spec.views = readViews(root);
    spec.volumes = readVolumes(root);
    spec.holodeckSections = readHolodeckSections(root);
    if (diagnostics.first()) return *diagnostics.first();
    return spec;
}

/// Where a project without geometry is: its luminaires and grids.
Box3d namedBounds(const ProjectSpec& spec) {
    Box3d box;
    for (const auto& luminaire : spec.luminaires) box.extendBy(luminaire.position);
    for (const auto& grid : spec.grids) {
        if (grid.points.empty()) box.extendBy(grid.origin);
        for (const auto& point : grid.points) box.extendBy(point[0]);
    }
    return box;
}

Result<void> checkScene(Scene& scene, const std::string& where) {
    if (auto valid = validate(scene); !valid) return Error{valid.error().code, valid.error().text(), where};
    scene.hash = sceneHash(scene);
    return {};
}

/// Second pass: the files and the scene. Photometry first: it is small, and its errors come soonest.
Result<Project> build(ProjectSpec spec, const fs::path& file) {
    Project project;
    auto types = loadLuminaireTypes(spec);
    if (!types) return types.error();
    auto& scene = project.scene;
    scene.name = spec.info.name;
    auto cameras = loadGeometry(scene, spec);
    if (!cameras) return cameras.error();
    if (spec.geometry.empty() && scene.objects.empty())
        if (const auto box = namedBounds(spec); !box.isEmpty()) scene.origin = chooseOrigin(box);
    if (auto replaced = replaceMaterials(scene, spec.materials); !replaced) return replaced.error();
    if (auto placed = placeLuminaires(scene, spec, std::move(*types)); !placed) return placed.error();
    if (auto placed = placeSky(scene, spec.sky); !placed) return placed.error();
    if (auto checked = checkScene(scene, file.string()); !checked) return checked.error();

    project.info = std::move(spec.info);
    project.grids = std::move(spec.grids);
    project.views = spec.views.empty() ? viewsOf(*cameras, file.string()) : std::move(spec.views);
    project.volumes = std::move(spec.volumes);
    project.holodeckSections = std::move(spec.holodeckSections);
    return project;
}

Result<Project> readText(const fs::path& file, const std::string& text) {
    Diagnostics diagnostics;
    const auto document = TomlDocument::parse(text, file.string(), diagnostics);
    if (!document) return document.error();
    auto spec = readSpec(document->root(kRoot), file, diagnostics);
    if (!spec) return spec.error();
    auto project = build(std::move(*spec), file);
    if (!project) return project;
    auto& warnings = project->scene.warnings;
    warnings.insert(warnings.begin(), diagnostics.warnings().begin(), diagnostics.warnings().end());
    project->fileHash = contentHash(text);
    return project;
}

Result<Project> loadProjectFile(const fs::path& file) {
    const auto bytes = readFile(file, kMaxProjectBytes);
    return bytes ? readText(file, *bytes) : Result<Project>(bytes.error());
}

/// The files of a model by themselves, read as one.
Result<ScenePart> readBareFiles(const std::vector<fs::path>& files) {
    GeometryPlacement placement;
    if (isRadianceFile(files.front())) return readRad(files, placement);
    placement.yUp = true;  // glTF always; OBJ as most programs write it
    return readSceneFile(files.front(), placement);
}

/// A model by itself: no grids, and a view to begin with.
Result<Project> loadBareScene(const std::vector<fs::path>& files) {
    const auto& file = files.front();
    Project project;
    for (const auto& one : files) {  // read twice: a model may be large, and its reader opens it itself
        const auto bytes = readFile(one);
        if (!bytes) return bytes.error();
        project.fileHash = contentHash(project.fileHash + *bytes);
    }
    auto part = readBareFiles(files);
    if (!part) return part.error();
    project.scene = std::move(part->scene);
    project.scene.name = project.info.name = file.stem().string();
    if (lowerExtension(file) == ".obj")
        project.scene.warnings.push_back(fmt::format(
            "{}: an OBJ file says neither unit nor up axis: taken as metres, y up; [[geometry]] in a project.toml can say otherwise",
            file.string()));
    if (auto checked = checkScene(project.scene, file.string()); !checked) return checked.error();
    project.views = viewsOf(part->cameras, file.string());
    if (!project.views.empty()) return project;
    Box3d bounds;
    if (const auto box = project.scene.bounds(); !box.isEmpty())
        bounds = Box3d(project.scene.toUser(box.min), project.scene.toUser(box.max));
    project.views.push_back(cornerView(bounds));
    project.views.back().where = file.string();
    return project;
}

Result<Project> loadByExtension(const std::vector<fs::path>& files) {
    for (const auto& file : files) {
        const auto extension = lowerExtension(file);
        const bool known = extension == ".toml" || extension == ".obj" || extension == ".glb" || extension == ".gltf" || isRadianceFile(file);
        std::error_code ec;
        if (!known && !fs::exists(file, ec)) return Error{ErrorCode::FileNotFound, "no such file", file.string()};
        if (!known) return Error{ErrorCode::Unsupported, "expected a project (.toml) or a scene (.glb, .gltf, .obj, .rad, .mat)", file.string()};
        if (files.size() > 1 && !isRadianceFile(file))
            return Error{ErrorCode::InvalidArgument, fmt::format("is one of {} files, expected it alone: only Radiance's (.rad, .mat) are read together", files.size()), file.string()};
    }
    return lowerExtension(files.front()) == ".toml" ? loadProjectFile(files.front()) : loadBareScene(files);
}

/// What a reader did not expect becomes an error, and a project knows its file.
template <class Read>
Result<Project> guarded(const fs::path& file, const Read& read) {
    try {
        Result<Project> project = read();
        if (project) project->file = file;
        return project;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "too little memory to read it", file.string()};
    } catch (const std::exception& e) {
        return Error{ErrorCode::Internal, e.what(), file.string()};
    }
}

}  // namespace

Result<Project> loadProject(const std::vector<fs::path>& paths) {
    if (paths.empty()) return Error{ErrorCode::InvalidArgument, "no file is named, expected a project or a scene", {}};
    return guarded(paths.front(), [&] { return loadByExtension(paths); });
}

Result<Project> loadProject(const fs::path& path) { return loadProject(std::vector<fs::path>{path}); }

Result<Project> loadProjectText(const fs::path& file, const std::string& text) {
    return guarded(file, [&] { return readText(file, text); });
}

}  // namespace luxdeck

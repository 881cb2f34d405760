#include "gui/session/importing.h"

#include "engine/core/file.h"
#include "engine/io/photometry.h"
#include "engine/io/scene_files.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <utility>

namespace luxdeck::gui {

namespace fs = std::filesystem;

namespace {

std::string counted(std::size_t count, const char* what) { return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"); }

std::string degrees(const std::optional<double>& angle) { return angle ? fmt::format("{:.0f}°", *angle) : "none"; }

void tellPhotometry(ImportedFile& out) {
    auto photometry = loadPhotometry(out.file);
    if (!photometry) {
        out.refused = photometry.error();
        return;
    }
    const auto facts = measure(*photometry);
    const auto& p = *photometry;
    out.what = fmt::format("Photometric file ({})", p.format);
    if (!p.name.empty()) out.facts.push_back(p.manufacturer.empty() ? p.name : fmt::format("{}, {}", p.name, p.manufacturer));
    if (!p.lamp.empty()) out.facts.push_back("Lamp: " + p.lamp);
    out.facts.push_back(facts.declaredRatio ? fmt::format("{:.0f} lm, declared {:.0f} lm: {}", facts.lumens, p.lumensDeclared, facts.fluxJudgement)
                                            : fmt::format("{:.0f} lm: {}", facts.lumens, facts.fluxJudgement));
    if (facts.efficacy) out.facts.push_back(fmt::format("{:.1f} W, {:.0f} lm/W", p.watts, *facts.efficacy));
    out.facts.push_back(fmt::format("{:.0f} cd at most; beam {} in C0, {} in C90", facts.peak.candela, degrees(facts.c0.beamDegrees), degrees(facts.c90.beamDegrees)));
    out.facts.push_back(fmt::format("{:.0f} lm up, {:.0f} lm down; symmetry {}", facts.lumensUp, facts.lumensDown, symmetryText(facts.measured)));
    out.repairs = p.repairs, out.warnings = p.warnings;
    out.photometry = std::make_shared<const CheckedFile>(CheckedFile{out.file.string(), std::move(*photometry), facts});
}

void tellModel(ImportedFile& out, const Units& units) {
    const auto extension = lowerExtension(out.file);
    GeometryPlacement placement;
    placement.yUp = extension == ".glb" || extension == ".gltf";
    auto part = readSceneFile(out.file, placement);
    if (!part) {
        out.refused = part.error();
        return;
    }
    const auto& scene = part->scene;
    out.needsUnit = extension == ".obj";
    out.what = fmt::format("Model ({})", extension.substr(1));
    out.triangles = scene.triangleCount(), out.objects = scene.objects.size(), out.materials = scene.materials.size(), out.luminaires = scene.luminaires.size();
    for (const auto& mesh : scene.meshes)
        for (const auto& p : mesh.positions) out.bounds.extendBy(scene.toUser(p));
    out.facts.push_back(fmt::format("{}, {}, {}", counted(out.triangles, "triangle"), counted(out.objects, "object"), counted(out.materials, "material")));
    if (!out.bounds.isEmpty()) {
        const auto size = out.bounds.size();
        // Of an OBJ these are its own numbers: whoever says the unit has to see them.
        out.facts.push_back(out.needsUnit ? fmt::format("{:.4g} x {:.4g} x {:.4g} in its own unit, which it does not say", size.x, size.y, size.z)
                                          : fmt::format("{} x {} x {}", units.lengthText(size.x), units.lengthText(size.y), units.lengthText(size.z)));
    }
    if (out.luminaires > 0) out.facts.push_back(counted(out.luminaires, "light") + " of its own");
    out.warnings = scene.warnings;
    if (out.triangles == 0) out.warnings.emplace_back("it has no triangles");
}

}  // namespace

ImportKind importKindOf(const fs::path& file) {
    const auto extension = lowerExtension(file);
    if (extension == ".toml") return ImportKind::Project;
    if (extension == ".ies" || extension == ".ldt") return ImportKind::Photometry;
    if (extension == ".glb" || extension == ".gltf" || extension == ".obj" || isRadianceFile(file)) return ImportKind::Geometry;
    return extension == ".vtu" ? ImportKind::Volume : ImportKind::Unknown;
}

ImportedFile lookAtFile(const fs::path& file, const Units& units) {
    ImportedFile out;
    out.file = file;
    out.kind = importKindOf(file);
    try {
        switch (out.kind) {
            case ImportKind::Photometry: tellPhotometry(out); break;
            case ImportKind::Geometry: tellModel(out, units); break;
            case ImportKind::Project: out.what = "Project"; break;
            case ImportKind::Volume: out.what = "Irradiance volume"; break;
            case ImportKind::Unknown:
                out.refused = Error{ErrorCode::Unsupported,
                                    "is of a kind that is not known, expected a photometric file (.ies, .ldt), a model (.glb, .gltf, .obj, .rad), a project (.toml) or a volume (.vtu)",
                                    file.string()};
        }
    } catch (const std::bad_alloc&) {
        out.refused = Error{ErrorCode::OutOfResources, "too little memory to read it", file.string()};
    } catch (const std::exception& e) {
        out.refused = Error{ErrorCode::Internal, e.what(), file.string()};
    }
    return out;
}

void Importing::look(const std::vector<fs::path>& files, const Units& units) {
    place_.jobs.cancel(JobKind::Import);
    found_.clear();
    const auto round = ++round_;
    place_.jobs.start(JobKind::Import, files.size() == 1 ? "Looking at " + files.front().filename().string() : fmt::format("Looking at {} files", files.size()),
                      [=, this](const Progress& progress, const Jobs::Tell& tell) -> Jobs::Delivery {
                          for (const auto& file : files) {
                              if (progress.cancelled()) return {};
                              tell([this, round, looked = lookAtFile(file, units)] {
                                  if (round != round_) return;
                                  found_.push_back(looked);
                                  if (looked.refused) place_.complain(*looked.refused);
                                  place_.tell(Change::Import);
                              });
                          }
                          return {};
                      });
    place_.tell(Change::Jobs);
}

void Importing::clear() {
    ++round_;
    found_.clear();
    place_.tell(Change::Import);
}

}  // namespace luxdeck::gui

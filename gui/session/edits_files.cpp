#include "gui/session/edit_text.h"
#include "gui/session/edits.h"

#include "engine/core/file.h"

#include <fmt/format.h>

#include <system_error>

namespace luxdeck::gui::edits {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostPhotometryBytes = 64U << 20U;

/// As it is named from the project's folder; on another drive: wholly.
fs::path fromFolder(const fs::path& project, const fs::path& file) {
    std::error_code ec;
    const auto folder = fs::weakly_canonical(fs::absolute(project).parent_path(), ec);
    const auto target = fs::weakly_canonical(fs::absolute(file), ec);
    const auto relative = target.lexically_relative(folder);
    return relative.empty() ? target : relative;
}

bool isBelow(const fs::path& relative) { return !relative.is_absolute() && !relative.empty() && *relative.begin() != ".."; }

/// A name in the folder that is free, or that of a file that holds the same.
Result<fs::path> nameIn(const fs::path& folder, const fs::path& file, const std::string& bytes) {
    for (int i = 1; i < 1000; ++i) {
        const auto name = i == 1 ? file.filename() : fs::path(fmt::format("{} {}{}", file.stem().string(), i, file.extension().string()));
        std::error_code ec;
        if (!fs::exists(folder / name, ec)) return folder / name;
        if (const auto there = readFile(folder / name, kMostPhotometryBytes); there && *there == bytes) return folder / name;
    }
    return Error{ErrorCode::InvalidArgument, "holds too many files of that name", folder.string()};
}

void say(std::vector<KeyChange>& keys, const std::string& key, const std::string& value) {
    if (!value.empty()) keys.push_back({key, TomlValue(value)});
}

std::string freeId(const ProjectEdit& edit) {
    for (int i = 0;; ++i) {
        auto id = i < 26 ? std::string(1, static_cast<char>('A' + i)) : fmt::format("T{}", i + 1);
        if (!edit.find("luminaire_type", "id", id)) return id;
    }
}

}  // namespace

Result<FileForProject> photometryForProject(const fs::path& project, const fs::path& file) {
    const auto relative = fromFolder(project, file);
    if (isBelow(relative)) return FileForProject{relative.generic_string(), false};
    const auto bytes = readFile(file, kMostPhotometryBytes);
    if (!bytes) return bytes.error();
    const auto folder = fs::absolute(project).parent_path() / "luminaires";
    std::error_code ec;
    fs::create_directories(folder, ec);
    if (ec) return Error{ErrorCode::InvalidArgument, "cannot be made: " + ec.message(), folder.string()};
    const auto copy = nameIn(folder, file, *bytes);
    if (!copy) return copy.error();
    if (!fs::exists(*copy, ec))
        if (auto written = writeFileAtomically(*copy, *bytes); !written) return written.error();
    return FileForProject{("luminaires" / copy->filename()).generic_string(), true};
}

FileForProject geometryForProject(const fs::path& project, const fs::path& file) { return {fromFolder(project, file).generic_string(), false}; }

Edit exchangePhotometry(std::string typeId, std::string shown) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        const auto at = edit.find("luminaire_type", "id", typeId);
        if (!at) return Error{ErrorCode::InvalidArgument, fmt::format("there is no luminaire type \"{}\" in the project file", typeId), {}};
        edit.set({"luminaire_type", *at}, "file", shown);
        return {};
    });
}

Edit addLuminaireType(std::string shown, std::string description, std::string id) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        std::vector<KeyChange> keys{{"id", TomlValue(id.empty() ? freeId(edit) : id)}, {"file", TomlValue(shown)}};
        say(keys, "description", description);
        edit.append("luminaire_type", std::move(keys));
        return {};
    });
}

Edit addGeometry(std::string shown, ModelUnit unit) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        std::vector<KeyChange> keys{{"file", TomlValue(shown)}};
        say(keys, "unit", unit.unit), say(keys, "up", unit.up);
        edit.append("geometry", std::move(keys));
        return {};
    });
}

Edit addFurniture(std::string shown, ModelUnit unit, Vec3d position) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        std::vector<KeyChange> keys{{"file", TomlValue(shown)}};
        say(keys, "unit", unit.unit), say(keys, "up", unit.up);
        keys.push_back({"position", TomlValue(tidy(position))});
        edit.append("furniture", std::move(keys));
        return {};
    });
}

}  // namespace luxdeck::gui::edits

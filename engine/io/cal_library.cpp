#include "engine/io/cal_library.h"

#include "engine/core/file.h"
#include "engine/io/cal_builtin.h"
#include "engine/io/cal_module.h"
#include "engine/io/pattern_data.h"
#include "engine/io/pattern_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace luxdeck {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kLargestFunctionFile = 1U << 22;
constexpr std::uint64_t kLargestDataFile = 1U << 30;

bool isBelow(const fs::path& path, const fs::path& folder) {
    const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end();
}

}  // namespace

CalLibrary::CalLibrary(const std::vector<fs::path>& folders) {
    for (const auto& folder : folders) {
        std::error_code ec;
        auto canonical = fs::canonical(folder.empty() ? fs::path(".") : folder, ec);
        if (ec) continue;  // folders of $RAYPATH need not be there
        if (!canonical.has_filename()) canonical = canonical.parent_path();
        if (std::find(folders_.begin(), folders_.end(), canonical) == folders_.end()) folders_.push_back(canonical);
    }
}

std::vector<fs::path> CalLibrary::withRayPath(std::vector<fs::path> folders) {
    folders.emplace_back(".");  // names in a scene are relative to where Radiance's programs run
    const char* rayPath = std::getenv("RAYPATH");
    std::string_view rest = rayPath == nullptr ? "" : rayPath;
    while (!rest.empty()) {
        const auto end = rest.find(':');
        if (const auto folder = rest.substr(0, end); !folder.empty()) folders.emplace_back(folder);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return folders;
}

Result<fs::path> CalLibrary::find(std::string_view name, const fs::path& folder) const {
    if (name.empty() || name.find('\0') != std::string_view::npos)
        return Error{ErrorCode::InvalidArgument, "an empty file name", ""};
    std::vector<fs::path> places;
    const fs::path asked(name);
    if (asked.is_absolute()) {
        places.push_back(asked);
    } else {
        places.push_back((folder.empty() ? fs::path(".") : folder) / asked);
        for (const auto& f : folders_) places.push_back(f / asked);
    }
    std::string lookedAt;
    bool outside = false;
    for (const auto& place : places) {
        std::error_code ec;
        const auto canonical = fs::canonical(place, ec);
        if (!ec && fs::is_regular_file(canonical, ec)) {
            const auto contains = [&](const fs::path& f) { return isBelow(canonical, f); };
            if (std::any_of(folders_.begin(), folders_.end(), contains)) return canonical;
            outside = true;
        }
        const auto shown = place.lexically_normal().string();
        if (lookedAt.find("'" + shown + "'") == std::string::npos)
            lookedAt += (lookedAt.empty() ? "'" : ", '") + shown + "'";
    }
    if (outside)
        return Error{
            ErrorCode::Unsupported,
            fmt::format("'{}' is outside of the folders that were named; expected a file in one of them", name), ""};
    return Error{ErrorCode::FileNotFound, fmt::format("'{}' is not found; looked for {}", name, lookedAt), ""};
}

Result<std::shared_ptr<const cal::Module>> CalLibrary::functions(std::string_view name, const fs::path& folder) {
    const auto path = name == "." ? Result<fs::path>(fs::path(".")) : find(name, folder);
    const auto builtin = name == "." ? std::string_view("{ none }") : cal::builtinFile(name);
    if (!path && (path.error().code != ErrorCode::FileNotFound || builtin.empty())) {
        Error error = path.error();
        if (error.code == ErrorCode::FileNotFound)
            error.message += fmt::format(", and it is not built in ({} are)", fmt::join(cal::builtinFileNames(), ", "));
        return error;
    }
    const bool ours = !path || name == ".";
    const std::string key = ours ? fmt::format("{} (built in)", name) : path->string();
    const std::lock_guard lock(mutex_);
    if (const auto at = modules_.find(key); at != modules_.end()) return at->second;
    Result<std::string> text = ours ? std::string(builtin) : readFile(*path, kLargestFunctionFile);
    if (!text) return text.error();
    auto module = cal::Module::parse(*text, key);
    if (module) modules_.emplace(key, *module);
    return module;
}

Result<std::shared_ptr<const DataTable>> CalLibrary::data(std::string_view name, const fs::path& folder) {
    const auto path = find(name, folder);
    if (!path) return path.error();
    const std::lock_guard lock(mutex_);
    if (const auto at = tables_.find(path->string()); at != tables_.end()) return at->second;
    const auto text = readFile(*path, kLargestDataFile);
    if (!text) return text.error();
    auto table = DataTable::parse(*text, path->string());
    if (table) tables_.emplace(path->string(), *table);
    return table;
}

Result<std::shared_ptr<const PatternPicture>> CalLibrary::picture(std::string_view name, const fs::path& folder) {
    const auto path = find(name, folder);
    if (!path) return path.error();
    const std::lock_guard lock(mutex_);
    if (const auto at = pictures_.find(path->string()); at != pictures_.end()) return at->second;
    const auto bytes = readFile(*path);
    if (!bytes) return bytes.error();
    auto picture = PatternPicture::parse(*bytes, *path);
    if (picture) pictures_.emplace(path->string(), *picture);
    return picture;
}

}  // namespace luxdeck

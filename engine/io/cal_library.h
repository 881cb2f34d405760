#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace luxdeck {

namespace cal {
class Module;
}
class DataTable;
class PatternPicture;

/// Where function (.cal), data (.dat) and picture (.hdr) files are found, and what was read of them: each file is
/// read once, however many patterns name it. Safe to call concurrently; what it gives is constant.
///
/// A name is looked for in the folder of the file that names it, in the folders that the user named, and in those
/// of $RAYPATH, in this order. Nothing outside of these folders is opened, whatever "..", absolute names or
/// symbolic links say. A function file that is in none of them may be built in (engine/io/cal_builtin.h).
class CalLibrary {
public:
    /// folders   that files may come from; those of $RAYPATH belong at the end
    explicit CalLibrary(const std::vector<std::filesystem::path>& folders);

    /// The folders that the user named and those of $RAYPATH.
    static std::vector<std::filesystem::path> withRayPath(std::vector<std::filesystem::path> folders);

    /// The file that `name` means in a file of `folder`.
    /// errors  FileNotFound (naming every place that was looked at), Unsupported (leads out of the folders)
    [[nodiscard]] Result<std::filesystem::path> find(std::string_view name, const std::filesystem::path& folder) const;

    /// The definitions of a function file; "." has none of its own.
    /// errors  those of find(); Parse ("file:line")
    Result<std::shared_ptr<const cal::Module>> functions(std::string_view name, const std::filesystem::path& folder);

    /// errors  those of find(); Parse ("file:line"), OutOfResources
    Result<std::shared_ptr<const DataTable>> data(std::string_view name, const std::filesystem::path& folder);

    /// errors  those of find() and of parseRgbe()
    Result<std::shared_ptr<const PatternPicture>> picture(std::string_view name, const std::filesystem::path& folder);

private:
    std::vector<std::filesystem::path> folders_;  // canonical
    std::mutex mutex_;                            // of the three below
    std::unordered_map<std::string, std::shared_ptr<const cal::Module>> modules_;
    std::unordered_map<std::string, std::shared_ptr<const DataTable>> tables_;
    std::unordered_map<std::string, std::shared_ptr<const PatternPicture>> pictures_;
};

}  // namespace luxdeck

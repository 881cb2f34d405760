#pragma once

#include "engine/core/result.h"
#include "engine/io/cal_library.h"
#include "engine/io/rad_command.h"
#include "engine/io/rad_primitive.h"
#include "engine/io/rad_text.h"
#include "engine/io/warning_list.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::rad {

/// What reading may take: a few lines with arrays can ask for more than any memory.
struct Limits {
    std::size_t primitives = 8'000'000;
    std::size_t triangles = 200'000'000;
    std::size_t depth = 32;  ///< of files and commands within each other
};

/// Where a file lies: "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// Reads files as one stream of primitives, running their commands: xform, cat, the generators and the skies, and
/// pipes between them. No command is ever given to a shell.
class Stream {
public:
    Stream(CalLibrary& library, const Limits& limits, WarningList& warnings)
        : library_(library), limits_(limits), warnings_(warnings) {}

    using Shared = std::shared_ptr<const Primitives>;

    /// The primitives of a file, each file read once.
    ///
    /// errors  FileNotFound, Parse, Unsupported, OutOfResources: file:line, seen, expected
    Result<Shared> readFile(const std::filesystem::path& path);

private:
    Result<Primitives> readText(const std::string& text, const std::filesystem::path& path);
    Result<Primitives> run(const Command& command, const std::filesystem::path& folder);
    Result<Primitives> runProgram(const CommandWords& words, const Place& place, const std::filesystem::path& folder,
                                  const Primitives* piped);
    Result<Primitives> runXform(std::vector<std::string> words, const Place& place, const std::filesystem::path& folder,
                                const Primitives* piped);
    Result<Primitives> runXformList(const std::vector<std::string>& words, std::size_t option, const Place& place,
                                    const std::filesystem::path& folder, const Primitives* piped);
    /// The files that an xform or cat names, one after the other; what the pipe brings when it names none.
    Result<Primitives> inputs(const std::vector<std::string>& names, const Place& place, const std::filesystem::path& folder,
                              const Primitives* piped);
    [[nodiscard]] Result<void> append(Primitives& target, Primitives source, const Place& place) const;

    CalLibrary& library_;
    Limits limits_;
    WarningList& warnings_;
    std::map<std::filesystem::path, Shared> known_;      ///< read already: arrays name the same file again and again
    std::vector<std::filesystem::path> open_;            ///< being read, outermost first
    std::size_t listDepth_ = 0;                          ///< of argument files within each other
};

}  // namespace luxdeck::rad

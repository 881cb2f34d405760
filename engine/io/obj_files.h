#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::obj {

/// Where a file that an OBJ or MTL file names is.
struct NamedFile {
    std::filesystem::path path;  ///< perhaps of no file: then what is named is not there
    std::string note;            ///< what was taken instead of what is written; empty: just that
};

/// Finds such files. Looks at each folder once: a model may name thousands of files that are not there.
class FileFinder {
public:
    /// A name as people's programs write it: with either slash; relative to the file that names it; with a path of
    /// another machine, whose last part lies beside that file; or with letters of another case, as Windows does not
    /// mind. Files outside the folder are never opened.
    ///
    /// errors  Unsupported: the name leads out of the folder, and nothing of its last part lies there
    Result<NamedFile> find(const std::filesystem::path& folder, std::string_view name);

    /// The names of an mtllib line, which may hold several, and spaces within each: what there is of files decides,
    /// else a name ends with ".mtl".
    std::vector<std::string> libraryNames(const std::filesystem::path& folder, std::string_view line);

private:
    using Names = std::map<std::string, std::filesystem::path>;  // by name in lower case, the first in order

    const Names& namesIn(const std::filesystem::path& folder);
    std::map<std::filesystem::path, Names> folders_;
};

}  // namespace luxdeck::obj

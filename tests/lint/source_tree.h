#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::lint {

/// One violation, as "path:line: what was seen; what was expected".
using Findings = std::vector<std::string>;

/// Files below `root`, as sorted paths relative to it with forward slashes. Folders that hold no
/// sources (.git, build, out, any CMake build tree) are passed over.
std::vector<std::string> filesBelow(const std::filesystem::path& root);

/// The lines of a text file, without their ends; empty for a binary one (a zero byte in its first 4096).
std::vector<std::string> textLines(const std::filesystem::path& file);

/// A C++ source or header.
bool isSource(std::string_view path);

/// Findings one a line, for a test's message.
std::string joined(const Findings& findings);

/// A folder that exists as long as the object does, filled with made-up files: every check is run on a
/// tree that it must object to.
class TemporaryTree {
public:
    TemporaryTree();
    ~TemporaryTree();
    TemporaryTree(const TemporaryTree&) = delete;
    TemporaryTree& operator=(const TemporaryTree&) = delete;

    void write(const std::string& path, std::string_view text) const;
    [[nodiscard]] const std::filesystem::path& root() const { return root_; }

private:
    std::filesystem::path root_;
};

}  // namespace luxdeck::lint

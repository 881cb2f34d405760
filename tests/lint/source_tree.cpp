#include "tests/lint/source_tree.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace luxdeck::lint {

namespace fs = std::filesystem;

std::vector<std::string> filesBelow(const fs::path& root) {
    std::vector<std::string> files;
    for (fs::recursive_directory_iterator it(root), end; it != end; ++it) {
        const std::string name = it->path().filename().string();
        if (it->is_directory() &&
            (name == ".git" || name == "build" || name == "out" || fs::exists(it->path() / "CMakeCache.txt"))) {
            it.disable_recursion_pending();
        } else if (it->is_regular_file()) {
            files.push_back(it->path().lexically_relative(root).generic_string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> textLines(const fs::path& file) {
    constexpr std::size_t probeBytes = 4096;
    std::ifstream stream(file, std::ios::binary);
    std::string probe(probeBytes, '\1');
    stream.read(probe.data(), static_cast<std::streamsize>(probe.size()));
    if (probe.find('\0') != std::string::npos) return {};
    stream.clear();
    stream.seekg(0);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

bool isSource(std::string_view path) { return path.ends_with(".cpp") || path.ends_with(".h"); }

std::string joined(const Findings& findings) {
    std::string text;
    for (const std::string& finding : findings) text += finding + "\n";
    return text;
}

TemporaryTree::TemporaryTree() {
    static int count = 0;
    root_ = fs::temp_directory_path() / ("luxdeck_lint_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    fs::create_directories(root_);
}

TemporaryTree::~TemporaryTree() {
    std::error_code ignored;  // a left-over temporary folder is no reason to end the process
    fs::remove_all(root_, ignored);
}

void TemporaryTree::write(const std::string& path, std::string_view text) const {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path, std::ios::binary) << text;
}

}  // namespace luxdeck::lint

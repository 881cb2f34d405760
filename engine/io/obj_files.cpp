#include "engine/io/obj_files.h"

#include "engine/core/file.h"
#include "engine/io/gltf_uri.h"
#include "engine/io/obj_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace luxdeck::obj {

namespace {

namespace fs = std::filesystem;

/// Names of more words than this are not tried: a line of many words must not ask the disk for each pair of them.
constexpr std::size_t kMostWordsOfAName = 16;
constexpr std::size_t kMostWordsOfALine = 256;
constexpr int kMostFilesLookedAt = 20'000;

bool isFile(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    return text;
}

}  // namespace

const FileFinder::Names& FileFinder::namesIn(const fs::path& folder) {
    const auto [known, isNew] = folders_.try_emplace(folder);
    if (!isNew) return known->second;
    std::error_code error;
    const fs::directory_iterator end;
    int seen = 0;
    for (auto at = fs::directory_iterator(folder, error); !error && at != end; at.increment(error)) {
        if (++seen > kMostFilesLookedAt) break;
        const auto [other, first] = known->second.try_emplace(lower(at->path().filename().string()), at->path());
        if (!first && at->path() < other->second) other->second = at->path();
    }
    return known->second;
}

Result<NamedFile> FileFinder::find(const fs::path& folder, std::string_view name) {
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    std::string forward(name);
    std::replace(forward.begin(), forward.end(), '\\', '/');
    const auto below = gltf::resolveBelow(folder, forward);
    if (below && isFile(*below)) return NamedFile{*below, ""};
    if (forward.find('\0') != std::string::npos) return below.error();
    const auto last = forward.substr(forward.find_last_of("/:") + 1);  // npos + 1 is 0
    if (last.empty() || last == "." || last == "..") {
        if (!below) return below.error();
        return NamedFile{*below, ""};
    }
    for (const auto& place : {below ? below->parent_path() : folder, folder}) {
        const auto& names = namesIn(place);
        const auto found = names.find(lower(last));
        if (found != names.end() && isFile(found->second))
            return NamedFile{found->second, fmt::format("names '{}': taken is '{}', which is there", name,
                                                        found->second.lexically_relative(folder).string())};
    }
    if (!below) return below.error();
    return NamedFile{*below, ""};
}

std::vector<std::string> FileFinder::libraryNames(const fs::path& folder, std::string_view line) {
    std::vector<std::string_view> starts;  // each word with all that follows
    Words words(line);
    const auto whole = words.remainder();
    while (!words.atEnd()) {
        starts.push_back(words.remainder());
        (void)words.next();
    }
    const auto upTo = [&](std::size_t first, std::size_t end) {  // words [first, end) as they are written
        const auto cut = end < starts.size() ? starts[first].size() - starts[end].size() : starts[first].size();
        return Words(starts[first].substr(0, cut)).remainder();
    };
    const auto exists = [&](std::string_view name) {
        const auto found = find(folder, name);
        return found && isFile(found->path);
    };
    if (whole.empty() || starts.size() > kMostWordsOfALine) return {std::string(whole)};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < starts.size();) {
        std::size_t end = std::min(starts.size(), i + kMostWordsOfAName);
        while (end > i && !exists(upTo(i, end))) --end;
        if (end == i)  // nothing of it is there: what will be missed is named as it was meant
            do ++end;
            while (end < starts.size() && lowerExtension(fs::path(upTo(i, end))) != ".mtl");
        names.emplace_back(upTo(i, end));
        i = end;
    }
    return names;
}

}  // namespace luxdeck::obj

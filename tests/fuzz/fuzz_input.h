#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace luxdeck::fuzz {

/// A fuzzer's input as readers take it.
inline std::string_view text(const std::uint8_t* bytes, std::size_t size) {
    return {reinterpret_cast<const char*>(bytes), size};
}

/// A file that is written over and over. It stays open: file systems flush a file that is cut to nothing and
/// closed again, which takes a thousand times as long as reading most inputs.
class InputFile {
public:
    explicit InputFile(std::filesystem::path path)
        : path_(std::move(path)), file_(::open(path_.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600)) {}
    ~InputFile() { ::close(file_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    void write(std::string_view bytes) const {
        const auto size = static_cast<off_t>(bytes.size());
        if (::pwrite(file_, bytes.data(), bytes.size(), 0) != size || ::ftruncate(file_, size) != 0) {
            std::perror(path_.c_str());
            std::abort();
        }
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    int file_;
};

/// A folder of this process, for readers that open a path; gone when the process ends.
class InputFolder {
public:
    InputFolder()
        : path_(std::filesystem::temp_directory_path() / ("luxdeck-fuzz-" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~InputFolder() {
        std::error_code ignored;  // a folder left in /tmp is no finding
        std::filesystem::remove_all(path_, ignored);
    }
    InputFolder(const InputFolder&) = delete;
    InputFolder& operator=(const InputFolder&) = delete;

    /// Writes a file of the folder and returns its path.
    const std::filesystem::path& write(const std::string& name, std::string_view bytes) {
        auto& file = files_[name];
        if (!file) file = std::make_unique<InputFile>(path_ / name);
        file->write(bytes);
        return file->path();
    }

private:
    std::filesystem::path path_;
    std::map<std::string, std::unique_ptr<InputFile>> files_;
};

/// What every reader promises: a value or an Error that says something.
template <class Result>
void expectValueOrMessage(const Result& result) {
    if (!result && result.error().message.empty()) std::abort();
}

}  // namespace luxdeck::fuzz

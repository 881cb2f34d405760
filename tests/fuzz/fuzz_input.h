#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace luxdeck::fuzz {

/// A fuzzer's input as readers take it.
inline std::string_view text(const std::uint8_t* bytes, std::size_t size) {
    return {reinterpret_cast<const char*>(bytes), size};
}

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
    std::filesystem::path write(std::string_view name, std::string_view bytes) const {
        const auto path = path_ / name;
        std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return path;
    }

private:
    std::filesystem::path path_;
};

/// What every reader promises: a value or an Error that says something.
template <class Result>
void expectValueOrMessage(const Result& result) {
    if (!result && result.error().message.empty()) std::abort();
}

}  // namespace luxdeck::fuzz

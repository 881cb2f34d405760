#include "engine/core/file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace luxdeck {

namespace fs = std::filesystem;

Result<std::string> readFile(const fs::path& path, std::uint64_t maxBytes) {
    std::error_code ec;
    const auto status = fs::status(path, ec);
    if (!fs::exists(status)) return Error{ErrorCode::FileNotFound, "no such file", path.string()};
    if (fs::is_directory(status)) return Error{ErrorCode::Parse, "is a folder, expected a file", path.string()};
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{ErrorCode::FileNotFound, fmt::format("cannot be opened: {}", std::strerror(errno)), path.string()};

    std::string bytes;
    if (fs::is_regular_file(status)) {
        const auto size = fs::file_size(path, ec);
        if (size > maxBytes)
            return Error{ErrorCode::Parse, fmt::format("is {} bytes, expected at most {}", size, maxBytes), path.string()};
        bytes.resize(size);
        in.read(bytes.data(), static_cast<std::streamsize>(size));
        bytes.resize(static_cast<std::size_t>(in.gcount()));
        return bytes;
    }
    char block[65536];  // pipes and the like tell no size beforehand
    while (in.read(block, sizeof block) || in.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(in.gcount()));
        if (bytes.size() > maxBytes)
            return Error{ErrorCode::Parse, fmt::format("has more than the {} bytes expected", maxBytes), path.string()};
    }
    return bytes;
}

namespace {

Error writeError(const fs::path& path, int code) {
    const bool resource = code == ENOSPC || code == EDQUOT || code == EIO || code == EFBIG;
    return {resource ? ErrorCode::OutOfResources : ErrorCode::InvalidArgument,
            fmt::format("cannot be written: {}", std::strerror(code)), path.string()};
}

/// A name beside `path` that no other process uses.
fs::path temporaryName(const fs::path& path) {
    return path.parent_path() / fmt::format(".{}.{}.part", path.filename().string(), ::getpid());
}

Result<void> flushToDisk(const fs::path& temporary, const fs::path& path) {
    const int fd = ::open(temporary.c_str(), O_RDONLY);
    if (fd < 0) return writeError(path, errno);
    const int failed = ::fsync(fd) != 0 ? errno : 0;
    ::close(fd);
    if (failed != 0 && failed != EINVAL) return writeError(path, failed);
    return {};
}

/// Devices and pipes (/dev/stdout, /dev/full) have no old content to keep.
bool isStream(const fs::path& path) {
    std::error_code ec;
    const auto status = fs::status(path, ec);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Result<void> writeBytes(const fs::path& target, const fs::path& shown, std::string_view bytes) {
    errno = 0;
    std::ofstream out(target, std::ios::binary | std::ios::trunc);
    if (!out) return writeError(shown, errno != 0 ? errno : EACCES);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) return writeError(shown, errno != 0 ? errno : EIO);
    return {};
}

}  // namespace

Result<void> writeFileAtomically(const fs::path& path,
                                 const std::function<Result<void>(const fs::path&)>& write) {
    if (isStream(path)) return write(path);
    const auto temporary = temporaryName(path);
    auto written = write(temporary);
    if (written) written = flushToDisk(temporary, path);
    std::error_code ec;
    if (written) {
        fs::rename(temporary, path, ec);
        if (ec) written = writeError(path, ec.value());
    }
    if (!written) fs::remove(temporary, ec);
    return written;
}

Result<void> writeFileAtomically(const fs::path& path, std::string_view bytes) {
    return writeFileAtomically(path, [&](const fs::path& target) { return writeBytes(target, path, bytes); });
}

std::string contentHash(std::string_view bytes) {
    return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
}

std::string lowerExtension(const std::filesystem::path& path) {
    auto extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace luxdeck

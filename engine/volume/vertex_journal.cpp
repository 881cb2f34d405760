#include "engine/volume/vertex_journal.h"

#include "engine/core/file.h"
#include "engine/volume/volume_header.h"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace luxdeck {

namespace {

constexpr std::string_view kFirstLine = "luxdeck-volume-part/1 ";
constexpr std::size_t kHashBytes = 16;
constexpr double kFlushSeconds = 1;  // what a failure of power may cost; a killed process loses less
constexpr std::uint64_t kMostBytes = 1ULL << 37;

using Key = std::array<std::uint32_t, 3>;

Key keyOf(const Vec3& p) {
    return {std::bit_cast<std::uint32_t>(p.x + 0.0F), std::bit_cast<std::uint32_t>(p.y + 0.0F), std::bit_cast<std::uint32_t>(p.z + 0.0F)};
}

/// Fixed part of a record, before its bins and rays. Plain values without gaps.
struct RecordHead {
    Key place{};
    std::uint32_t samples = 0, rejected = 0, inside = 0, bins = 0, rays = 0;
    std::array<float, 6> lux{}, spread{};
    float backFaces = 0, nearestM = 0;
};

template <class T>
void put(std::string& out, const T* values, std::size_t count) {
    out.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

std::string recordOf(const Vec3& position, const VertexState& state) {
    const auto& q = state.quality;
    const RecordHead head{keyOf(position), q.samples, q.rejected, q.inside ? 1U : 0U, static_cast<std::uint32_t>(state.direct.size()), static_cast<std::uint32_t>(state.sources.size()),
                          q.lux, q.spread, q.backFaces, q.nearestM};
    std::string body;
    put(body, &head, 1);
    put(body, state.direct.data(), state.direct.size()), put(body, state.indirect.data(), state.indirect.size());
    for (const auto& ray : state.sources) {
        const std::array<float, 7> row{ray.direction.x, ray.direction.y, ray.direction.z, ray.lux.r, ray.lux.g, ray.lux.b, ray.direct ? 1.0F : 0.0F};
        put(body, row.data(), row.size());
    }
    const auto size = static_cast<std::uint64_t>(body.size());
    std::string out;
    put(out, &size, 1);
    return out + contentHash(body) + body;
}

std::size_t bodyBytes(const RecordHead& head) {
    return sizeof head + 2 * sizeof(Rgb) * std::size_t{head.bins} + 7 * sizeof(float) * std::size_t{head.rays};
}

/// The record is whole: it was checked when it was read.
VertexState stateOf(const std::string& body) {
    RecordHead head;
    const char* at = body.data();
    const auto get = [&](void* to, std::size_t bytes) { std::memcpy(to, at, bytes), at += bytes; };
    get(&head, sizeof head);
    VertexState state;
    state.direct.resize(head.bins), state.indirect.resize(head.bins);
    get(static_cast<void*>(state.direct.data()), head.bins * sizeof(Rgb));
    get(static_cast<void*>(state.indirect.data()), head.bins * sizeof(Rgb));
    for (std::uint32_t i = 0; i < head.rays; ++i) {
        std::array<float, 7> row{};
        get(row.data(), sizeof row);
        state.sources.push_back({{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, row[6] != 0});
    }
    state.quality = {head.samples, head.lux, head.spread, head.backFaces, head.nearestM, head.rejected, head.inside != 0};
    return state;
}

Error diskError(const std::filesystem::path& path, int code) {
    const bool resource = code == ENOSPC || code == EDQUOT || code == EIO || code == EFBIG;
    return {resource ? ErrorCode::OutOfResources : ErrorCode::InvalidArgument, fmt::format("cannot be written: {}", std::strerror(code)), path.string()};
}

}  // namespace

std::string buildIdentity(const std::string& sceneHash, const std::string& algorithm, std::uint64_t seed, const VolumeSettings& settings) {
    auto comparable = settings;
    comparable.firstLevel = {0, 0, 0};  // places tell vertices apart: another lattice may use what there is of them
    comparable.secondLevel = comparable.refineDepth = 0, comparable.refineBelow = comparable.insetM = 0, comparable.bounds = {};
    return fmt::format("scene {} algorithm {} seed {} {}", sceneHash, algorithm, seed, settingsText(comparable));
}

Result<std::unique_ptr<VertexJournal>> VertexJournal::open(const std::filesystem::path& path, const std::string& identity) {
    const std::string first = std::string(kFirstLine) + identity + "\n";
    std::string before;
    std::error_code ec;
    if (std::filesystem::exists(path, ec)) {
        auto bytes = readFile(path, kMostBytes);
        if (!bytes) return bytes.error();
        before = *std::move(bytes);
    }
    // A first line that was cut off by a kill is nobody's work.
    if (first.starts_with(before)) before.clear();
    if (!before.empty() && !before.starts_with(first))
        return Error{ErrorCode::InvalidArgument, fmt::format("belongs to another build ({}), expected {}: take another output, or remove it",
                                                             before.substr(0, std::min<std::size_t>(before.find('\n'), 300)), identity), path.string()};
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) return diskError(path, errno);
    std::unique_ptr<VertexJournal> journal(new VertexJournal(path, file));
    if (before.empty()) {
        if (::ftruncate(file, 0) != 0) return diskError(path, errno);
        if (const auto written = journal->append(first); !written) return written.error();
        return journal;
    }
    if (const auto read = journal->readKnown(before, first.size()); !read) return read.error();
    return journal;
}

VertexJournal::~VertexJournal() {
    if (file_ >= 0) ::close(file_);
}

Result<void> VertexJournal::readKnown(const std::string& bytes, std::size_t from) {
    std::size_t at = from;
    while (bytes.size() - at > sizeof(std::uint64_t) + kHashBytes) {
        std::uint64_t size = 0;
        std::memcpy(&size, bytes.data() + at, sizeof size);
        const std::size_t begin = at + sizeof size + kHashBytes;
        if (size < sizeof(RecordHead) || size > bytes.size() - begin) break;
        std::string body = bytes.substr(begin, size);
        RecordHead head;
        std::memcpy(&head, body.data(), sizeof head);
        if (contentHash(body) != std::string_view(bytes).substr(at + sizeof size, kHashBytes) || bodyBytes(head) != size) break;
        known_[head.place] = std::move(body);
        at = begin + size;
    }
    dropped_ = bytes.size() - at;
    if (::ftruncate(file_, static_cast<off_t>(at)) != 0) return diskError(path_, errno);
    if (::lseek(file_, 0, SEEK_END) < 0) return diskError(path_, errno);
    return {};
}

Result<void> VertexJournal::append(const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const auto wrote = ::write(file_, bytes.data() + done, bytes.size() - done);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) return diskError(path_, errno);
        done += static_cast<std::size_t>(wrote);
    }
    const auto now = std::chrono::steady_clock::now();
    if (std::chrono::duration<double>(now - flushed_).count() > kFlushSeconds) {
        flushed_ = now;
        if (::fdatasync(file_) != 0 && errno != EINVAL) return diskError(path_, errno);
    }
    return {};
}

std::optional<VertexState> VertexJournal::find(const Vec3& position) {
    const auto found = known_.find(keyOf(position));
    if (found == known_.end()) return std::nullopt;
    return stateOf(found->second);
}

Result<void> VertexJournal::keep(std::span<const Vec3> positions, std::span<const VertexState> states) {
    std::string bytes;
    for (std::size_t i = 0; i < positions.size(); ++i) bytes += recordOf(positions[i], states[i]);
    return append(bytes);
}

void VertexJournal::remove() {
    ::close(file_);
    file_ = -1;
    std::error_code ec;
    std::filesystem::remove(path_, ec);
}

}  // namespace luxdeck

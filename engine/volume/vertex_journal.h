#pragma once

#include "engine/volume/volume_build.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace luxdeck {

/// The vertices of a volume that is being built, in a file beside it: each is appended when it is finished, with a hash. A
/// process that is killed loses what it was working on; a record that was cut off is dropped by the next session.
class VertexJournal final : public VertexStore {
public:
    /// Opens or makes a journal.
    ///
    /// identity  of the build: what must be the same for a session to go on where another stopped
    /// errors    InvalidArgument: the file is of another build, or no journal, or its folder cannot be written;
    ///           OutOfResources
    static Result<std::unique_ptr<VertexJournal>> open(const std::filesystem::path& path, const std::string& identity);
    ~VertexJournal() override;
    VertexJournal(const VertexJournal&) = delete;
    VertexJournal& operator=(const VertexJournal&) = delete;

    std::optional<VertexState> find(const Vec3& position) override;
    Result<void> keep(std::span<const Vec3> positions, std::span<const VertexState> states) override;

    /// Vertices that earlier sessions finished.
    [[nodiscard]] std::size_t found() const { return known_.size(); }
    /// Bytes at the end that belonged to no whole record, and were cut off.
    [[nodiscard]] std::uint64_t dropped() const { return dropped_; }
    /// The volume is written: the journal is not needed any more.
    void remove();

private:
    VertexJournal(std::filesystem::path path, int file) : path_(std::move(path)), file_(file) {}

    Result<void> readKnown(const std::string& bytes, std::size_t from);
    Result<void> append(const std::string& bytes);

    std::filesystem::path path_;
    int file_;
    std::map<std::array<std::uint32_t, 3>, std::string> known_;  // records by the bits of their place
    std::uint64_t dropped_ = 0;
    std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

/// What a build is recognised by: scene, algorithm, settings, seed.
std::string buildIdentity(const std::string& sceneHash, const std::string& algorithm, std::uint64_t seed, const VolumeSettings& settings);

}  // namespace luxdeck

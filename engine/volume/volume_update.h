#pragma once

#include "engine/volume/volume_build.h"

#include <map>
#include <string>
#include <vector>

namespace luxdeck {

/// What of a volume may be kept for a scene in which objects moved, came or went: vertices that see nothing of where they
/// were and are. What changes there by light that is reflected to and fro is left as it was, and measured: see
/// measureKept(). Luminaires, sky or materials of everything: nothing may be kept.
class VolumeUpdate final : public VertexStore {
public:
    /// old      of an earlier state of the scene; with the settings, algorithm and seed of the build that follows
    /// journal  of the build that follows; may be null. All must outlive it.
    VolumeUpdate(const IrradianceVolume& old, const TransportScene& scene, VertexStore* journal);

    std::optional<VertexState> find(const Vec3& position) override;
    Result<void> keep(std::span<const Vec3> positions, std::span<const VertexState> states) override;

    /// "object desk 3 changed" ...
    [[nodiscard]] const std::vector<std::string>& changes() const { return changes_; }
    /// Vertices that were taken from the old volume so far.
    [[nodiscard]] std::size_t kept() const { return kept_; }

    /// How far kept vertices are off: some of them looked at again with the same random numbers, so that most noise cancels;
    /// relative rms of the irradiances in six directions.
    struct Deviation {
        double relative = 0;
        std::size_t vertices = 0;
    };
    [[nodiscard]] Deviation measureKept(const IrradianceVolume& updated, const VertexSampler& sampler) const;

private:
    [[nodiscard]] bool sees(const Vec3& position, const Box3& box) const;
    [[nodiscard]] bool affected(const Vec3& position) const;

    const IrradianceVolume& old_;
    TransportScene scene_;
    VertexStore* journal_;
    std::vector<std::string> changes_;
    std::vector<Box3> moved_;              // where changed objects were and are
    bool everything_ = false;
    std::map<std::array<float, 3>, std::uint32_t> vertexOf_;
    std::size_t kept_ = 0;
};

}  // namespace luxdeck

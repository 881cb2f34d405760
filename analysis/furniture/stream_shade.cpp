#include "analysis/furniture/stream_shade.h"

#include "engine/core/parallel.h"
#include "engine/core/stopwatch.h"
#include "engine/volume/group_lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck {

namespace {

constexpr std::size_t kBlock = 2048;   // triangles that one thread lights at a time
constexpr std::size_t kChunk = 32 * kBlock;

/// One block's own memory: blocks are the same whatever the number of threads, and so are their groups of points.
struct Block {
    explicit Block(const IrradianceVolume& volume, const Raycaster* room) : lookup(volume, room) {}

    GroupLookup lookup;
    std::vector<Vec3> normals;
    std::uint64_t unknown = 0;
};

class Shader {
public:
    Shader(const VolumeField& field, const Raycaster* room, const StreamSettings& settings) : field_(field), room_(room), settings_(settings) {
        const double angle = settings.turnDeg * kDegree;
        place_ = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), settings.at};
    }

    void shade(const std::vector<TriangleStream::Triangle>& triangles, StreamCounts& counts) {
        const Stopwatch clock;
        collect(triangles, counts);
        lux_.resize(positions_.size());
        const std::size_t count = (positions_.size() / 3 + kBlock - 1) / kBlock;
        while (blocks_.size() < count) blocks_.emplace_back(field_.volume(), room_);  // a polygon may be many triangles
        parallelFor(count, [&](std::size_t b) { shadeBlock(blocks_[b], 3 * kBlock * b, std::min(positions_.size(), 3 * kBlock * (b + 1))); });
        for (std::size_t b = 0; b < count; ++b) counts.unknown += blocks_[b].unknown;
        counts.shadingSeconds += clock.seconds();
        for (const auto& lux : lux_) {
            const double y = luminance(lux, field_.volume().weights);
            if (std::isnan(y)) continue;
            counts.minimumLux = std::min(counts.minimumLux, y), counts.maximumLux = std::max(counts.maximumLux, y);
        }
    }

    [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }
    [[nodiscard]] const std::vector<Rgb>& lux() const { return lux_; }

private:
    [[nodiscard]] Vec3 placed(const Vec3& p) const {
        const Vec3 q = p * static_cast<float>(settings_.metresPerUnit);
        return place_.point(settings_.yUp ? Vec3(q.x, -q.z, q.y) : q);
    }

    /// Triangles with a finite area, where they stand.
    void collect(const std::vector<TriangleStream::Triangle>& triangles, StreamCounts& counts) {
        positions_.clear();
        for (const auto& t : triangles) {
            const Vec3 a = placed(t[0]), b = placed(t[1]), c = placed(t[2]);
            const float area2 = cross(b - a, c - a).length2();
            ++counts.triangles;
            if (!(area2 > 0) || !std::isfinite(area2) || !isFinite(a)) {
                ++counts.skipped;
                continue;
            }
            positions_.insert(positions_.end(), {a, b, c});
        }
    }

    void shadeBlock(Block& block, std::size_t first, std::size_t last) {
        const std::span<const Vec3> positions(positions_.data() + first, last - first);
        block.normals.resize(positions.size());
        for (std::size_t i = 0; i < positions.size(); i += 3) {
            const Vec3 n = cross(positions[i + 1] - positions[i], positions[i + 2] - positions[i]).normalized();
            block.normals[i] = block.normals[i + 1] = block.normals[i + 2] = n;
        }
        block.lookup.find(positions, block.normals);
        block.unknown = 0;
        const auto bins = field_.volume().bins();
        DirectionBins::Blend blend{};
        for (std::size_t i = 0; i < positions.size(); ++i) {
            if (i % 3 == 0) blend = bins.blend(block.normals[i]);
            const auto corners = block.lookup.weights(i);
            Rgb lux(corners.known ? 0 : std::numeric_limits<float>::quiet_NaN());
            if (!corners.known) ++block.unknown;
            for (std::size_t c = 0; c < 8; ++c)
                if (corners.weights[c] != 0) lux += field_.atVertex(corners.vertices[c], blend) * corners.weights[c];
            lux_[first + i] = lux;
        }
    }

    const VolumeField& field_;
    const Raycaster* room_;
    StreamSettings settings_;
    Placement place_;
    std::vector<Block> blocks_;            // as many as the largest chunk had
    std::vector<Vec3> positions_;
    std::vector<Rgb> lux_;
};

}  // namespace

Result<StreamCounts> shadeStream(TriangleStream& stream, const VolumeField& field, const Raycaster* room, const StreamSettings& settings,
                                 const ShadedSink& sink, const Progress& progress) {
    StreamCounts counts;
    counts.minimumLux = std::numeric_limits<double>::infinity();
    Shader shader(field, room, settings);
    std::vector<TriangleStream::Triangle> triangles;
    for (;;) {
        if (progress.cancelled()) return Error{ErrorCode::Cancelled, "interrupted", {}};
        if (const auto read = stream.next(triangles, kChunk); !read) return read.error();
        if (triangles.empty()) break;
        shader.shade(triangles, counts);
        if (const auto kept = sink(shader.positions(), shader.lux()); !kept) return kept.error();
    }
    if (counts.minimumLux > counts.maximumLux) counts.minimumLux = 0;
    return counts;
}

}  // namespace luxdeck

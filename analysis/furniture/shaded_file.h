#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/core/vec.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace luxdeck {

/// Writes lit vertices as they come, then the triangles between them.
///
/// .ply  binary, little-endian: x y z (double, user coordinates in m), red green blue (false colour: 0 .. scale lx), lux,
///       lux_r lux_g lux_b (float); faces. MeshLab, Blender and ParaView open it.
/// .csv  x,y,z,lux,lux_r,lux_g,lux_b; no triangles
class ShadedFile {
public:
    struct Settings {
        Vec3d origin{0, 0, 0};   // user coordinates = re-based + origin [m]
        LuminanceWeights weights;
        double scaleLux = 1000;  // of the colours
    };

    /// kind  ".ply" or ".csv"
    /// errors  OutOfResources (disk)
    static Result<ShadedFile> create(const std::filesystem::path& path, const std::string& kind, const Settings& settings);

    /// positions re-based [m], lux; both #P.
    void vertices(std::span<const Vec3> positions, std::span<const Rgb> lux);
    void triangles(std::span<const std::array<std::uint32_t, 3>> triangles);
    /// Triangles of vertices one after the other, as many as were written.
    void trianglesInOrder();
    /// Puts the counts into the head. errors  OutOfResources: the disk was full
    Result<void> finish();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void put(const void* bytes, std::size_t size);
    void head();

    std::unique_ptr<std::FILE, Close> file_;
    std::string name_;
    Settings settings_;
    bool ply_ = true, failed_ = false;
    std::uint64_t vertexCount_ = 0, faceCount_ = 0;
};

}  // namespace luxdeck

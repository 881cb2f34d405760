#include "analysis/furniture/shaded_file.h"

#include "tonemap/colour_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck {

namespace {

constexpr std::size_t kHead = 512;  // bytes, padded by a comment: the counts are known at the end

}  // namespace

Result<ShadedFile> ShadedFile::create(const std::filesystem::path& path, const std::string& kind, const Settings& settings) {
    ShadedFile out;
    out.file_.reset(std::fopen(path.c_str(), "wb"));
    if (!out.file_) return Error{ErrorCode::OutOfResources, "cannot be written", path.string()};
    out.name_ = path.string(), out.settings_ = settings, out.ply_ = kind == ".ply";
    out.head();
    return out;
}

void ShadedFile::put(const void* bytes, std::size_t size) { failed_ = failed_ || std::fwrite(bytes, 1, size, file_.get()) != size; }

void ShadedFile::head() {
    if (!ply_) {
        const std::string names = "x,y,z,lux,lux_r,lux_g,lux_b\n";
        put(names.data(), names.size());
        return;
    }
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\ncomment Luxdeck: illuminance in lx, colours 0 to {:g} lx\nelement vertex {}\n"
                                   "property double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                                   "property float lux\nproperty float lux_r\nproperty float lux_g\nproperty float lux_b\nelement face {}\n"
                                   "property list uchar uint vertex_indices\ncomment ", settings_.scaleLux, vertexCount_, faceCount_);
    const std::string end = "\nend_header\n";
    text.append(kHead - text.size() - end.size(), '.');
    text += end;
    put(text.data(), text.size());
}

void ShadedFile::vertices(std::span<const Vec3> positions, std::span<const Rgb> lux) {
    std::string bytes;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3d p = Vec3d(positions[i]) + settings_.origin;
        const float y = luminance(lux[i], settings_.weights);
        if (!ply_) {
            bytes += fmt::format("{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{:.6g},{:.6g}\n", p.x, p.y, p.z, y, lux[i].r, lux[i].g, lux[i].b);
            continue;
        }
        const auto colour = std::isnan(y) ? tonemap::kNotANumber : tonemap::colourAt(tonemap::ColourMap::Dusk, y / settings_.scaleLux);
        const std::array<float, 4> values{y, lux[i].r, lux[i].g, lux[i].b};
        bytes.append(reinterpret_cast<const char*>(&p), 24);
        bytes.append(reinterpret_cast<const char*>(colour.data()), 3);
        bytes.append(reinterpret_cast<const char*>(values.data()), 16);
    }
    put(bytes.data(), bytes.size());
    vertexCount_ += positions.size();
}

void ShadedFile::triangles(std::span<const std::array<std::uint32_t, 3>> triangles) {
    if (!ply_) return;
    std::string bytes;
    for (const auto& t : triangles) bytes += '\3', bytes.append(reinterpret_cast<const char*>(t.data()), 12);
    put(bytes.data(), bytes.size());
    faceCount_ += triangles.size();
}

void ShadedFile::trianglesInOrder() {
    std::array<std::array<std::uint32_t, 3>, 1024> block{};
    for (std::uint64_t first = 0; first < vertexCount_ / 3; first += block.size()) {
        const auto count = std::min<std::uint64_t>(block.size(), vertexCount_ / 3 - first);
        for (std::uint64_t i = 0; i < count; ++i)
            for (std::uint64_t c = 0; c < 3; ++c) block[i][c] = static_cast<std::uint32_t>(3 * (first + i) + c);
        triangles({block.data(), static_cast<std::size_t>(count)});
    }
}

Result<void> ShadedFile::finish() {
    if (ply_) {
        failed_ = failed_ || std::fseek(file_.get(), 0, SEEK_SET) != 0;
        head();
    }
    failed_ = failed_ || std::fflush(file_.get()) != 0;
    file_.reset();
    if (failed_) return Error{ErrorCode::OutOfResources, "cannot be written: is the disk full?", name_};
    return {};
}

}  // namespace luxdeck

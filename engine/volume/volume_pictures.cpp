#include "engine/volume/volume_pictures.h"

#include "engine/core/file.h"
#include "engine/io/image_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace luxdeck {

namespace {

constexpr double kHalfWithoutGrid = 0.5;  // [m] to either side, along an axis with one coordinate
constexpr double kSameM = 1e-4;           // coordinates this near are one

/// The regular grid along one axis.
struct Axis {
    double first = 0, step = 1;
    int count = 1;

    [[nodiscard]] int indexOf(double x) const { return count == 1 ? 0 : static_cast<int>(std::lround((x - first) / step)); }
};

Result<Axis> axisOf(const PanoramaNodes& nodes, int axis) {
    std::vector<double> all;
    for (const auto& node : nodes.nodes) all.push_back(node.position[axis]);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < kSameM; }), all.end());
    Axis out{all.front(), 1, static_cast<int>(all.size())};
    if (out.count == 1) return out;
    out.step = (all.back() - all.front()) / (out.count - 1);
    for (int i = 0; i < out.count; ++i)
        if (std::abs(all[static_cast<std::size_t>(i)] - (out.first + i * out.step)) > std::max(kSameM, 1e-3 * out.step))
            return Error{ErrorCode::InvalidArgument, fmt::format("the nodes form no regular grid along {}: one is at {} m, expected {} m", "xyz"[axis],
                                                                 all[static_cast<std::size_t>(i)], out.first + i * out.step)};
    return out;
}

/// Parts of a pixel along each side: small against a bin, so that it spreads over the bins it covers.
int partsOf(double pixelRad, const DirectionBins& bins) {
    const double bin = std::sqrt(bins.solidAngleSr());
    return std::clamp(static_cast<int>(std::ceil(4 * pixelRad / bin)), 1, 64);
}

Result<std::vector<Rgb>> readNode(const PanoramaNode& node, double defaultCdM2, const DirectionBins& bins) {
    const auto picture = readHdrImage(node.picture);
    if (!picture) return picture.error();
    const double aspect = static_cast<double>(picture->width()) / picture->height(), expected = 360 / (node.highestDeg - node.lowestDeg);
    if (aspect < 0.95 * expected || aspect > 1.05 * expected)
        return Error{ErrorCode::InvalidArgument, fmt::format("is {} x {} pixels, expected {:.3g} times as wide as high for a panorama from {} to {} degrees of latitude",
                                                             picture->width(), picture->height(), expected, node.lowestDeg, node.highestDeg), node.picture.string()};
    return binsOfPanorama(*picture, node.lowestDeg, node.highestDeg, defaultCdM2, bins);
}

std::array<float, 6> axisLux(const std::vector<Rgb>& radiance, const DirectionBins& bins) {
    std::array<float, 6> lux{};
    for (int bin = 0; bin < bins.count(); ++bin) {
        const Vec3 d = bins.centre(bin);
        const auto y = static_cast<float>(luminance(radiance[static_cast<std::size_t>(bin)]) * bins.solidAngleSr());
        for (int axis = 0; axis < 3; ++axis) lux[static_cast<std::size_t>(2 * axis + (d[axis] < 0 ? 1 : 0))] += std::abs(d[axis]) * y;
    }
    return lux;
}

}  // namespace

std::vector<Rgb> binsOfPanorama(const Image& picture, double lowestDeg, double highestDeg, double defaultCdM2, const DirectionBins& bins) {
    const auto pixels = colours(picture);
    const double low = lowestDeg * kDegree, high = highestDeg * kDegree;
    const double rowRad = (high - low) / picture.height(), columnRad = 2 * kPiD / picture.width();
    const int parts = partsOf(std::max(rowRad, columnRad), bins);
    const auto count = static_cast<std::size_t>(bins.count());
    std::vector<std::array<double, 3>> sums(count);
    std::vector<double> covered(count);
    for (int row = 0; row < picture.height() * parts; ++row) {
        const double top = high - rowRad * row / parts, bottom = high - rowRad * (row + 1) / parts;
        const double solidAngle = (std::sin(top) - std::sin(bottom)) * columnRad / parts;
        const double sine = 0.5 * (std::sin(top) + std::sin(bottom)), cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
        for (int column = 0; column < picture.width() * parts; ++column) {
            const Rgb& c = pixels[picture.index(column / parts, row / parts)];
            if (!isFinite(c)) continue;
            const double longitude = columnRad * (column + 0.5) / parts - kPiD;
            const auto bin = static_cast<std::size_t>(bins.binOf(Vec3(Vec3d(cosine * std::sin(longitude), cosine * std::cos(longitude), sine))));
            sums[bin][0] += c.r * solidAngle, sums[bin][1] += c.g * solidAngle, sums[bin][2] += c.b * solidAngle;
            covered[bin] += solidAngle;
        }
    }
    std::vector<Rgb> out(count);
    for (std::size_t bin = 0; bin < count; ++bin) {
        // What no pixel covers has the default; parts of pixels may cover a little more than there is.
        const double rest = std::max(0.0, bins.solidAngleSr() - covered[bin]), all = covered[bin] + rest;
        const auto mix = [&](double sum) { return static_cast<float>((sum + rest * defaultCdM2) / all); };
        out[bin] = {mix(sums[bin][0]), mix(sums[bin][1]), mix(sums[bin][2])};
    }
    return out;
}

Result<IrradianceVolume> buildVolumeFromPictures(const PanoramaNodes& nodes, int side, const Progress& progress) {
    const auto begun = std::chrono::steady_clock::now();
    std::array<Axis, 3> axes{};
    std::size_t expected = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto one = axisOf(nodes, axis);
        if (!one) return one.error();
        axes[static_cast<std::size_t>(axis)] = *one, expected *= static_cast<std::size_t>(one->count);
    }
    if (expected != nodes.nodes.size())
        return Error{ErrorCode::InvalidArgument, fmt::format("{} nodes do not fill the grid of {} x {} x {} places that they lie on, one each", nodes.nodes.size(), axes[0].count, axes[1].count, axes[2].count)};
    IrradianceVolume v;
    v.settings.side = side;
    v.algorithm = "pictures", v.scene = "pictures";
    Box3 box;
    std::array<int, 3> cells{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& a = axes[axis];
        cells[axis] = std::max(1, a.count - 1), v.settings.firstLevel[axis] = cells[axis] + 1;
        box.min[static_cast<int>(axis)] = static_cast<float>(a.count > 1 ? a.first : a.first - kHalfWithoutGrid);
        box.max[static_cast<int>(axis)] = static_cast<float>(a.count > 1 ? a.first + a.step * (a.count - 1) : a.first + kHalfWithoutGrid);
    }
    v.settings.secondLevel = 1;
    auto lattice = Lattice::create(box, cells, 2, 0);
    if (!lattice) return lattice.error();
    v.lattice = *std::move(lattice);
    std::string hashes;
    std::vector<std::vector<Rgb>> spheres(nodes.nodes.size());
    for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::Cancelled, "interrupted while the pictures were read"};
        const auto& node = nodes.nodes[i];
        auto sphere = readNode(node, nodes.defaultCdM2, v.bins());
        if (!sphere) return sphere.error();
        const auto at = (static_cast<std::size_t>(axes[2].indexOf(node.position.z)) * static_cast<std::size_t>(axes[1].count) + static_cast<std::size_t>(axes[1].indexOf(node.position.y))) *
                            static_cast<std::size_t>(axes[0].count) + static_cast<std::size_t>(axes[0].indexOf(node.position.x));
        if (!spheres[at].empty()) return Error{ErrorCode::InvalidArgument, "two nodes are at one place", node.picture.string()};
        spheres[at] = *std::move(sphere);
        const auto bytes = readFile(node.picture);
        v.parts.push_back({"picture " + node.picture.filename().string(), bytes ? contentHash(*bytes) : "", {}});
        hashes += v.parts.back().hash;
        progress.report({"reading pictures", static_cast<double>(i + 1) / static_cast<double>(nodes.nodes.size())});
    }
    v.sceneHash = contentHash(hashes);
    const auto n = v.settings.firstLevel;
    for (int z = 0; z < n[2]; ++z)
        for (int y = 0; y < n[1]; ++y)
            for (int x = 0; x < n[0]; ++x) {
                const auto place = [&](int index, std::size_t axis) { return static_cast<std::size_t>(std::min(index, axes[axis].count - 1)); };
                const auto& sphere = spheres[(place(z, 2) * static_cast<std::size_t>(axes[1].count) + place(y, 1)) * static_cast<std::size_t>(axes[0].count) + place(x, 0)];
                v.indirect.insert(v.indirect.end(), sphere.begin(), sphere.end());
                VertexQuality quality;
                quality.samples = 1, quality.lux = axisLux(sphere, v.bins());
                v.quality.push_back(quality);
            }
    v.direct.resize(v.indirect.size());
    v.sources.resize(v.vertexCount());
    v.occupied.resize(v.lattice.cells().size());
    v.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return v;
}

}  // namespace luxdeck

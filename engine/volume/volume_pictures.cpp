#include "engine/volume/volume_pictures.h"

#include "engine/core/file.h"
#include "engine/core/stopwatch.h"
#include "engine/io/image_files.h"
#include "engine/volume/vertex_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
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

/// Parts of a pixel along each side: so small against a bin that sums over them know its solid angle.
int partsOf(double pixelRad, const DirectionBins& bins) {
    const double bin = std::sqrt(bins.solidAngleSr());
    return std::clamp(static_cast<int>(std::ceil(48 * pixelRad / bin)), 1, 64);
}

Result<Image> readPanorama(const PanoramaNode& node) {
    auto picture = readHdrImage(node.picture);
    if (!picture) return picture.error();
    const double aspect = static_cast<double>(picture->width()) / picture->height(), expected = 360 / (node.highestDeg - node.lowestDeg);
    if (aspect < 0.95 * expected || aspect > 1.05 * expected)
        return Error{ErrorCode::InvalidArgument, fmt::format("is {} x {} pixels, expected {:.3g} times as wide as high for a panorama from {} to {} degrees of latitude",
                                                             picture->width(), picture->height(), expected, node.lowestDeg, node.highestDeg), node.picture.string()};
    return picture;
}

std::array<float, 6> axisLux(const std::vector<Rgb>& radiance, const DirectionBins& bins, const LuminanceWeights& weights) {
    std::array<double, 6> sums{};
    for (int bin = 0; bin < bins.count(); ++bin) addToAxes(sums, bins.centre(bin), luminance(radiance[static_cast<std::size_t>(bin)], weights) * bins.solidAngleSr());
    std::array<float, 6> lux{};
    for (std::size_t i = 0; i < lux.size(); ++i) lux[i] = static_cast<float>(sums[i]);
    return lux;
}

}  // namespace

namespace {

/// Sums of radiance by bin while the sphere is walked over in small parts.
class BinSums {
public:
    explicit BinSums(const DirectionBins& bins) : bins_(bins), sums_(static_cast<std::size_t>(bins.count())) {}

    /// A band of latitudes [rad], in parts of equal longitude; radianceOf(part) is its radiance.
    template <class RadianceOf>
    void addBand(double bottom, double top, int parts, const RadianceOf& radianceOf) {
        const double solidAngle = (std::sin(top) - std::sin(bottom)) * 2 * kPiD / parts;
        const double sine = 0.5 * (std::sin(top) + std::sin(bottom)), cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
        for (int i = 0; i < parts; ++i) {
            const double longitude = 2 * kPiD * (i + 0.5) / parts - kPiD;
            auto& sum = sums_[static_cast<std::size_t>(bins_.binOf(Vec3(Vec3d(cosine * std::sin(longitude), cosine * std::cos(longitude), sine))))];
            const Rgb c = radianceOf(i);
            sum[0] += c.r * solidAngle, sum[1] += c.g * solidAngle, sum[2] += c.b * solidAngle, sum[3] += solidAngle;
        }
    }

    [[nodiscard]] std::vector<Rgb> means() const {
        std::vector<Rgb> out;
        for (const auto& s : sums_) {
            const double scale = s[3] > 0 ? 1 / s[3] : 0;
            out.emplace_back(static_cast<float>(s[0] * scale), static_cast<float>(s[1] * scale), static_cast<float>(s[2] * scale));
        }
        return out;
    }

private:
    const DirectionBins& bins_;
    std::vector<std::array<double, 4>> sums_;  // the last one of solid angles
};

}  // namespace

std::vector<Rgb> binsOfPanorama(const Image& picture, double lowestDeg, double highestDeg, double defaultCdM2, const DirectionBins& bins) {
    const auto pixels = colours(picture);
    const double low = lowestDeg * kDegree, high = highestDeg * kDegree;
    const double rowRad = (high - low) / picture.height();
    const int parts = partsOf(std::max(rowRad, 2 * kPiD / picture.width()), bins), across = picture.width() * parts;
    const Rgb none(static_cast<float>(defaultCdM2));
    BinSums sums(bins);
    for (int row = 0; row < picture.height() * parts; ++row)
        sums.addBand(high - rowRad * (row + 1) / parts, high - rowRad * row / parts, across, [&](int i) {
            const Rgb& c = pixels[picture.index(i / parts, row / parts)];
            return isFinite(c) ? c : none;
        });
    // What the picture does not show, above and below it.
    const double step = rowRad / parts;
    for (double bottom = high; bottom < kPiD / 2 - 1e-9; bottom += step) sums.addBand(bottom, std::min(bottom + step, kPiD / 2), across, [&](int) { return none; });
    for (double top = low; top > -kPiD / 2 + 1e-9; top -= step) sums.addBand(std::max(top - step, -kPiD / 2), top, across, [&](int) { return none; });
    return sums.means();
}

namespace {

using Axes = std::array<Axis, 3>;

Result<Axes> axesOf(const PanoramaNodes& nodes) {
    Axes axes{};
    std::size_t places = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto one = axisOf(nodes, axis);
        if (!one) return one.error();
        axes[static_cast<std::size_t>(axis)] = *one, places *= static_cast<std::size_t>(one->count);
    }
    if (places == nodes.nodes.size()) return axes;
    return Error{ErrorCode::InvalidArgument, fmt::format("{} nodes do not fill the grid of {} x {} x {} places that they lie on, one each", nodes.nodes.size(), axes[0].count,
                                                         axes[1].count, axes[2].count)};
}

std::size_t indexOf(const Axes& axes, int x, int y, int z) {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(axes[1].count) + static_cast<std::size_t>(y)) * static_cast<std::size_t>(axes[0].count) + static_cast<std::size_t>(x);
}

Result<void> layOut(const Axes& axes, IrradianceVolume& v) {
    Box3 box;
    std::array<int, 3> cells{};
    for (int i = 0; i < 3; ++i) {
        const auto& a = axes[static_cast<std::size_t>(i)];
        cells[static_cast<std::size_t>(i)] = std::max(1, a.count - 1), v.settings.firstLevel[static_cast<std::size_t>(i)] = cells[static_cast<std::size_t>(i)] + 1;
        box.min[i] = static_cast<float>(a.count > 1 ? a.first : a.first - kHalfWithoutGrid);
        box.max[i] = static_cast<float>(a.count > 1 ? a.first + a.step * (a.count - 1) : a.first + kHalfWithoutGrid);
    }
    v.settings.secondLevel = 1;
    auto lattice = Lattice::create(box, cells, 2, 0);
    if (!lattice) return lattice.error();
    v.lattice = *std::move(lattice);
    return {};
}

/// Spheres of all nodes, in the order of their places; what they were made of goes into the volume's parts.
Result<std::vector<std::vector<Rgb>>> readSpheres(const PanoramaNodes& nodes, const Axes& axes, const Progress& progress, IrradianceVolume& v) {
    std::vector<std::vector<Rgb>> spheres(nodes.nodes.size());
    std::string hashes;
    for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::Cancelled, "interrupted while the pictures were read"};
        const auto& node = nodes.nodes[i];
        auto& sphere = spheres[indexOf(axes, axes[0].indexOf(node.position.x), axes[1].indexOf(node.position.y), axes[2].indexOf(node.position.z))];
        if (!sphere.empty()) return Error{ErrorCode::InvalidArgument, "two nodes are at one place", node.picture.string()};
        const auto picture = readPanorama(node);
        if (!picture) return picture.error();
        if (i == 0) v.weights = picture->weights;
        if (!(picture->weights == v.weights)) return Error{ErrorCode::InvalidArgument, "has other primaries than the pictures before it", node.picture.string()};
        sphere = binsOfPanorama(*picture, node.lowestDeg, node.highestDeg, nodes.defaultCdM2, v.bins());
        const std::string_view bytes(reinterpret_cast<const char*>(sphere.data()), sphere.size() * sizeof(Rgb));
        v.parts.push_back({"picture " + node.picture.filename().string(), contentHash(bytes), {}});
        hashes += v.parts.back().hash;
        progress.report({"reading pictures", static_cast<double>(i + 1) / static_cast<double>(nodes.nodes.size())});
    }
    v.sceneHash = contentHash(hashes);
    return spheres;
}

}  // namespace

Result<IrradianceVolume> buildVolumeFromPictures(const PanoramaNodes& nodes, int side, const Progress& progress) {
    const Stopwatch clock;
    const auto axes = axesOf(nodes);
    if (!axes) return axes.error();
    IrradianceVolume v;
    v.settings.side = side;
    v.algorithm = "pictures", v.scene = "pictures";
    if (const auto done = layOut(*axes, v); !done) return done.error();
    const auto spheres = readSpheres(nodes, *axes, progress, v);
    if (!spheres) return spheres.error();
    const auto n = v.settings.firstLevel;
    const auto place = [&](int index, std::size_t axis) { return std::min(index, (*axes)[axis].count - 1); };
    for (int z = 0; z < n[2]; ++z)
        for (int y = 0; y < n[1]; ++y)
            for (int x = 0; x < n[0]; ++x) {
                const auto& sphere = (*spheres)[indexOf(*axes, place(x, 0), place(y, 1), place(z, 2))];
                v.indirect.insert(v.indirect.end(), sphere.begin(), sphere.end());
                VertexQuality quality;
                quality.samples = 1, quality.lux = axisLux(sphere, v.bins(), v.weights);
                v.quality.push_back(quality);
            }
    v.direct.resize(v.indirect.size());
    v.sources.resize(v.vertexCount());
    v.occupied.resize(v.lattice.cells().size());
    v.seconds = clock.seconds();
    return v;
}

}  // namespace luxdeck

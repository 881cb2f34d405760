#include "engine/volume/volume_build.h"

#include "engine/core/parallel.h"
#include "engine/core/stopwatch.h"
#include "engine/volume/corners.h"
#include "engine/volume/occupancy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace luxdeck {

Result<Lattice> volumeLattice(const Scene& scene, const VolumeSettings& s) {
    const auto bounds = volumeBounds(scene, s);
    if (!bounds) return bounds.error();
    std::array<int, 3> cells{};
    for (int axis = 0; axis < 3; ++axis) {
        if (s.firstLevel[axis] < 2 || s.firstLevel[axis] > 1025)
            return Error{ErrorCode::InvalidArgument, fmt::format("{} vertices along {} in the first level, expected 2 .. 1025", s.firstLevel[axis], "xyz"[axis])};
        cells[axis] = s.firstLevel[axis] - 1;
    }
    const bool byLight = s.refineBelow > 0;
    if (byLight && !(s.refineBelow < 10 && s.refineDepth >= 1 && s.refineDepth <= 8))
        return Error{ErrorCode::InvalidArgument, fmt::format("refinement below {} to depth {}, expected up to 10 and 1 .. 8", s.refineBelow, s.refineDepth)};
    const bool divides = !byLight && s.secondLevel >= 2 + 1;
    if (!byLight && s.secondLevel > 32) return Error{ErrorCode::InvalidArgument, fmt::format("{} vertices along a second level, expected up to 32", s.secondLevel)};
    auto lattice = Lattice::create(*bounds, cells, divides ? s.secondLevel - 1 : 2, byLight ? s.refineDepth : divides ? 1 : 0);
    if (lattice && divides) divideByGeometry(*lattice, scene);
    return lattice;
}

namespace {

constexpr double kSliceSeconds = 0.3;  // between two reports, and two entries into the store

/// The largest difference between vertices of a cell in the irradiance along an axis, beyond what noise explains, relative
/// to what the cell has there. Dark directions are judged on the cell's mean, as dark points of a grid are.
double contrast(const Lattice::Cell& cell, const std::vector<VertexQuality>& quality) {
    double mean = 0, usable = 0;
    for (const auto v : cell.vertices)
        if (quality[v].usable()) mean += quality[v].meanLux(), ++usable;
    if (usable < 2 || !(mean > 0)) return 0;
    mean /= usable;
    double worst = 0;
    for (std::size_t axis = 0; axis < 6; ++axis) {
        double low = std::numeric_limits<double>::infinity(), high = 0, noise = 0;
        for (const auto v : cell.vertices) {
            const auto& q = quality[v];
            if (!q.usable()) continue;
            low = std::min(low, double{q.lux[axis]}), high = std::max(high, double{q.lux[axis]});
            noise = std::max(noise, std::sqrt(q.variance(axis)));
        }
        // The range of eight equal values with this noise is 2.85 standard errors on average.
        worst = std::max(worst, (high - low - 2.85 * noise) / std::max(0.5 * (low + high), 0.25 * mean));
    }
    return worst;
}

/// What new vertices have against what their cell said of their place before it was divided.
class PredictionError {
public:
    void add(const IrradianceVolume& volume, std::uint32_t divided, std::uint32_t firstNew) {
        const auto box = volume.lattice.box(divided);
        const auto children = static_cast<std::uint32_t>(volume.lattice.split() * volume.lattice.split() * volume.lattice.split());
        for (std::uint32_t c = 0; c < children; ++c)
            for (const auto v : volume.lattice.cells()[volume.lattice.cells()[divided].firstChild + c].vertices)
                if (v >= firstNew && volume.quality[v].usable()) addVertex(volume, volume.lattice.cells()[divided], box, v);
    }
    /// Below 0: nothing was compared.
    [[nodiscard]] double relative() const { return lux2_ > 0 ? std::sqrt(std::max(0.0, error2_) / lux2_) : -1; }

private:
    void addVertex(const IrradianceVolume& volume, const Lattice::Cell& cell, const Box3& box, std::uint32_t vertex) {
        const auto& q = volume.quality[vertex];
        const auto weights = trilinearWeights((volume.lattice.vertices()[vertex] - box.min) / (box.max - box.min));
        for (std::size_t axis = 0; axis < 6; ++axis) {
            double predicted = 0, noise2 = q.variance(axis);
            for (std::uint32_t i = 0; i < 8; ++i) {
                const auto& corner = volume.quality[cell.vertices[i]];
                if (!corner.usable()) return;
                const double w = weights[i];
                predicted += w * corner.lux[axis];
                noise2 += w * w * corner.variance(axis);
            }
            error2_ += (predicted - q.lux[axis]) * (predicted - q.lux[axis]) - noise2;
            lux2_ += double{q.lux[axis]} * q.lux[axis];
        }
    }

    double error2_ = 0, lux2_ = 0;
};

class Build {
public:
    Build(const TransportScene& scene, const VertexSampler& sampler, const BuildOptions& options, const Progress& progress, IrradianceVolume& volume)
        : scene_(scene), sampler_(sampler), options_(options), progress_(progress), volume_(volume) {
        state_.stage = "building the volume";
        state_.rateUnit = "vertices";
    }

    Result<void> run() {
        if (const auto done = sampleFrom(0, volume_.settings.samplesPerBin); !done) return done;
        if (volume_.settings.refineBelow > 0)
            if (const auto done = refine(); !done) return done;
        // Twice the samples again and again: an eighth of a pass is the dearest mistake.
        for (std::uint32_t samples = 2 * volume_.settings.samplesPerBin; volume_.complete && options_.targetError > 0 && !reached(); samples *= 2) {
            if (samples > kMostSamples) break;
            if (const auto done = sampleFrom(0, samples); !done) return done;
        }
        volume_.seconds = clock_.seconds();
        volume_.rays = counters_.rays;
        return {};
    }

private:
    static constexpr std::uint32_t kMostSamples = 1U << 16;
    static constexpr double kMostBytes = 16e9;

    [[nodiscard]] bool reached() const { return 1.96 * volume_.relativeError() <= options_.targetError; }
    [[nodiscard]] bool mustStop() const { return progress_.cancelled() || (options_.timeSeconds && clock_.seconds() > *options_.timeSeconds); }

    Result<void> refine() {
        PredictionError errors;
        std::uint32_t firstCell = 0;
        while (volume_.complete) {
            const auto firstNew = static_cast<std::uint32_t>(volume_.vertexCount());
            const auto cells = static_cast<std::uint32_t>(volume_.lattice.cells().size());
            std::vector<std::uint32_t> divided;
            for (auto cell = firstCell; cell < cells; ++cell)
                if (volume_.lattice.levelOf(cell) < volume_.lattice.depth() && contrast(volume_.lattice.cells()[cell], volume_.quality) > volume_.settings.refineBelow)
                    volume_.lattice.divide(cell), divided.push_back(cell);
            if (divided.empty()) break;
            if (const auto done = sampleFrom(firstNew, volume_.settings.samplesPerBin); !done) return done;
            for (const auto cell : divided) errors.add(volume_, cell, firstNew);
            firstCell = cells;
        }
        volume_.interpolationError = errors.relative();
        return {};
    }

    /// Brings all vertices from `first` on to this number of samples, or as far as there is time.
    Result<void> sampleFrom(std::size_t first, std::uint32_t samples) {
        const std::size_t count = volume_.vertexCount(), bins = volume_.binCount();
        const double bytes = 2.0 * sizeof(Rgb) * static_cast<double>(count) * static_cast<double>(bins);
        if (bytes > kMostBytes)
            return Error{ErrorCode::OutOfResources, fmt::format("{} vertices with {} bins take {:.1f} GB, expected {:.0f} GB at most: fewer vertices or bins, or a larger refinement",
                                                                count, bins, bytes / 1e9, kMostBytes / 1e9)};
        volume_.direct.resize(count * bins), volume_.indirect.resize(count * bins);
        volume_.sources.resize(count), volume_.quality.resize(count);
        recall(first);
        std::size_t slice = static_cast<std::size_t>(4 * threadCount());
        for (std::size_t next = first; next < count;) {
            if (volume_.quality[next].samples >= samples) {
                ++next;
                continue;
            }
            if (mustStop()) {
                volume_.complete = false;
                return {};
            }
            const std::size_t end = std::min(count, next + slice);
            const double before = clock_.seconds();
            if (const auto kept = sampleSlice(next, end, samples); !kept) return kept;
            const double took = std::max(clock_.seconds() - before, 1e-3);
            tell(static_cast<double>(end - first), static_cast<double>(count - first));
            slice = std::clamp(static_cast<std::size_t>(static_cast<double>(end - next) * kSliceSeconds / took), std::size_t{1}, 4 * slice);
            next = end;
        }
        return {};
    }

    Result<void> sampleSlice(std::size_t first, std::size_t end, std::uint32_t samples) {
        const std::size_t count = end - first;
        const std::span positions(volume_.lattice.vertices().data() + first, count);
        std::vector<VertexState> states(count);
        std::vector<std::uint8_t> worked(count);
        for (std::size_t i = 0; i < count; ++i) states[i] = stateOf(volume_, first + i);
        std::vector<TransportCounters> counters(count);
        parallelFor(count, [&](std::size_t i) {
            worked[i] = states[i].quality.samples < samples ? 1 : 0;
            if (worked[i] != 0) sampler_.sample(positions[i], samples, states[i], counters[i]);
        });
        std::vector<Vec3> newPlaces;
        std::vector<VertexState> newStates;
        for (std::size_t i = 0; i < count; ++i) {
            counters_ += counters[i];
            take(first + i, states[i]);
            if (worked[i] != 0 && options_.store != nullptr) newPlaces.push_back(positions[i]), newStates.push_back(std::move(states[i]));
        }
        if (newPlaces.empty()) return {};
        return options_.store->keep(newPlaces, newStates);
    }

    /// Takes what earlier sessions knew.
    void recall(std::size_t first) {
        if (options_.store == nullptr) return;
        for (std::size_t v = first; v < volume_.vertexCount(); ++v)
            if (volume_.quality[v].samples == 0)
                if (const auto found = options_.store->find(volume_.lattice.vertices()[v])) take(v, *found);
    }

    void take(std::size_t vertex, const VertexState& state) {
        std::copy(state.direct.begin(), state.direct.end(), volume_.direct.begin() + static_cast<std::ptrdiff_t>(vertex * volume_.binCount()));
        std::copy(state.indirect.begin(), state.indirect.end(), volume_.indirect.begin() + static_cast<std::ptrdiff_t>(vertex * volume_.binCount()));
        volume_.sources[vertex] = state.sources;
        volume_.quality[vertex] = state.quality;
    }

    void tell(double done, double all) {
        state_.fraction = done / all;
        state_.rate = done / clock_.seconds();
        state_.secondsLeft = (all - done) / std::max(state_.rate, 1e-9);
        const double error = volume_.relativeError();
        state_.errorPercent = std::isfinite(error) ? 196 * error : -1;
        progress_.report(state_);
    }

    const TransportScene& scene_;
    const VertexSampler& sampler_;
    const BuildOptions& options_;
    const Progress& progress_;
    IrradianceVolume& volume_;
    TransportCounters counters_;
    ProgressState state_;
    Stopwatch clock_;
};

}  // namespace

Result<VolumeSettings> volumeSettingsOf(const Project& project, const std::string& name) {
    VolumeSettings s;
    for (const auto& spec : project.volumes) {
        if (!name.empty() && spec.name != name) continue;
        s.bounds = Box3(project.scene.toRebased(spec.min), project.scene.toRebased(spec.max));
        s.firstLevel = spec.firstLevel, s.secondLevel = spec.secondLevel, s.side = spec.bins;
        return s;
    }
    if (name.empty()) return s;
    std::string known;
    for (const auto& spec : project.volumes) known += (known.empty() ? "" : ", ") + spec.name;
    return Error{ErrorCode::InvalidArgument, fmt::format("no volume \"{}\", expected one of: {}", name, known.empty() ? "none is in the project" : known)};
}

Result<Box3> volumeBounds(const Scene& scene, const VolumeSettings& settings) {
    if (!settings.bounds.isEmpty()) return settings.bounds;
    auto box = scene.bounds();
    if (box.isEmpty()) return Error{ErrorCode::InvalidArgument, "a volume needs a scene with an extent: this one holds nothing"};
    const float size = std::max((box.max - box.min).length(), 1e-3F);
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = box.max[axis] - box.min[axis];
        if (extent < 1e-4F * size) {  // a floor alone, say: room for light on both sides
            const float middle = 0.5F * (box.min[axis] + box.max[axis]);
            box.min[axis] = middle - 0.05F * size, box.max[axis] = middle + 0.05F * size;
            continue;
        }
        const float inset = std::min(static_cast<float>(settings.insetM), 0.02F * extent);
        box.min[axis] += inset, box.max[axis] -= inset;
    }
    return box;
}

Result<IrradianceVolume> buildVolume(const TransportScene& scene, const RadianceEstimator& estimator, const VolumeSettings& settings,
                                     const BuildOptions& options, const Progress& progress) {
    const auto sampler = VertexSampler::create(scene, estimator, settings, options.seed);
    if (!sampler) return sampler.error();
    auto lattice = volumeLattice(scene.scene, settings);
    if (!lattice) return lattice.error();
    IrradianceVolume volume;
    volume.settings = settings;
    volume.scene = scene.scene.name, volume.sceneHash = sceneHash(scene.scene), volume.parts = contentParts(scene.scene);
    volume.algorithm = options.algorithm, volume.seed = options.seed;
    volume.origin = scene.scene.origin, volume.weights = scene.scene.weights;
    volume.lattice = *std::move(lattice);
    Build build(scene, *sampler, options, progress, volume);
    if (const auto done = build.run(); !done) return done.error();
    volume.occupied = occupiedCells(volume.lattice, scene.scene);
    return volume;
}

}  // namespace luxdeck

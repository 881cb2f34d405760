#include "engine/transport/photon_map/photon_field.h"

#include "engine/core/parallel.h"
#include "engine/transport/photon_map/photon_density.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck {

namespace {

// At effort 1. With N photons: elements as N^(3/4), elements in a disc as N^(1/4), and so a disc's area as N^(-1/2) and its
// photons as N^(1/2): discs shrink and fill.
constexpr double kPhotons = 1 << 19;
constexpr double kRays = 1 << 21;            // where photons are reflected often there are fewer of them
constexpr double kPieces = 55000;
constexpr double kDiscElements = 5;

constexpr std::uint32_t kTask = 1024;        // photons followed together
constexpr std::size_t kBetweenReports = 64;  // tasks
constexpr std::size_t kDensityTask = 256;    // elements

Error cancelled() { return {ErrorCode::Cancelled, "cancelled while the photon map was prepared", {}}; }

void tell(const Progress* progress, const char* stage, double fraction) {
    if (progress == nullptr) return;
    ProgressState state;
    state.stage = stage, state.fraction = fraction;
    progress->report(state);
}

/// Sums of what arrives on every element; merged in the order of the photons.
class Shooting {
public:
    Shooting(const PhotonTracer& tracer, std::size_t elements, const Progress* progress) : tracer_(tracer), progress_(progress), sums_(elements), lost_(elements) {}

    /// The first photons tell how many rays one takes, and that how many there are.
    ///
    /// errors  Cancelled
    Result<void> shoot(double effort) {
        if (auto ok = follow(static_cast<std::uint32_t>(std::min(double{kTask}, std::ceil(kPhotons * effort)))); !ok) return ok;
        const double raysEach = static_cast<double>(counters_.rays) / static_cast<double>(shot_);
        const auto photons = static_cast<std::uint32_t>(std::min(kPhotons, kRays / std::max(raysEach, 1.0)) * effort);
        if (photons > shot_)
            if (auto ok = follow(photons); !ok) return ok;
        for (auto* sums : {&sums_, &lost_})
            for (auto& s : *sums) s.power *= 1 / static_cast<float>(shot_);
        return {};
    }
    [[nodiscard]] std::span<const ElementPhotons> sums() const { return sums_; }
    /// The same of light that may be missing.
    [[nodiscard]] std::span<const ElementPhotons> lost() const { return lost_; }
    [[nodiscard]] bool unbounded() const { return unbounded_; }
    [[nodiscard]] const TransportCounters& counters() const { return counters_; }

private:
    Result<void> follow(std::uint32_t upTo) {
        std::vector<PhotonTracer::Arrived> arrived(kBetweenReports);
        while (shot_ < upTo) {
            const std::size_t tasks = std::min<std::size_t>(kBetweenReports, (upTo - shot_ + kTask - 1) / kTask);
            parallelFor(tasks, [&](std::size_t i) {
                const auto first = shot_ + static_cast<std::uint32_t>(i) * kTask;
                arrived[i] = {};
                if (progress_ == nullptr || !progress_->cancelled()) arrived[i] = tracer_.trace(first, std::min(kTask, upTo - first));
            });
            if (progress_ != nullptr && progress_->cancelled()) return cancelled();
            for (std::size_t i = 0; i < tasks; ++i) add(arrived[i]);
            shot_ = std::min(upTo, shot_ + static_cast<std::uint32_t>(tasks) * kTask);
            tell(progress_, "following photons", static_cast<double>(shot_) / upTo);
        }
        return {};
    }
    void add(const PhotonTracer::Arrived& arrived) {
        counters_ += arrived.counters;
        unbounded_ = unbounded_ || arrived.unbounded;
        for (const auto& d : arrived.deposits) {
            auto& sum = (d.lost ? lost_ : sums_)[d.element];
            sum.power += d.power, ++sum.count;
        }
    }

    const PhotonTracer& tracer_;
    const Progress* progress_;
    std::vector<ElementPhotons> sums_, lost_;
    bool unbounded_ = false;
    TransportCounters counters_;
    std::uint32_t shot_ = 0;
};

Result<std::vector<Rgb>> densities(const PhotonDensity& density, std::size_t elements, const Progress* progress) {
    std::vector<Rgb> lux(elements);
    parallelFor((elements + kDensityTask - 1) / kDensityTask, [&](std::size_t task) {
        if (progress != nullptr && progress->cancelled()) return;
        const std::size_t end = std::min(elements, (task + 1) * kDensityTask);
        for (std::size_t e = task * kDensityTask; e < end; ++e) lux[e] = density.lux(static_cast<std::uint32_t>(e));
    });
    if (progress != nullptr && progress->cancelled()) return cancelled();
    return lux;
}

}  // namespace

Result<std::unique_ptr<PhotonField>> PhotonField::create(const TransportScene& scene, const AlgorithmSettings& settings) {
    if (!(settings.effort >= 1e-3 && settings.effort <= 1e3))
        return Error{ErrorCode::InvalidArgument, fmt::format("effort is {}, expected 0.001 .. 1000", settings.effort)};
    const double pieces = kPieces * std::pow(settings.effort, 0.75), inDisc = std::max(3.0, kDiscElements * std::pow(settings.effort, 0.25));
    std::unique_ptr<PhotonField> field(new PhotonField(SurfaceElements(scene.scene, scene.needs, static_cast<std::size_t>(pieces))));
    const auto& elements = field->elements_;
    field->lux_.resize(elements.size());
    const LightEmission emission(scene);
    if (emission.dark() || elements.size() == 0) return field;
    const PhotonTracer tracer(scene, emission, elements, settings);
    Shooting shooting(tracer, elements.size(), settings.progress);
    if (auto ok = shooting.shoot(settings.effort); !ok) return ok.error();
    field->counters_ = shooting.counters();
    auto lux = densities(PhotonDensity(scene, elements, shooting.sums(), inDisc, settings.seed), elements.size(), settings.progress);
    if (!lux) return lux.error();
    field->lux_ = *std::move(lux);
    if (shooting.unbounded()) field->gaps_.assign(elements.size(), Rgb(std::numeric_limits<float>::infinity()));
    if (shooting.unbounded() || field->counters_.rejected == 0) return field;
    auto gaps = densities(PhotonDensity(scene, elements, shooting.lost(), inDisc, settings.seed), elements.size(), settings.progress);
    if (!gaps) return gaps.error();
    field->gaps_ = *std::move(gaps);
    return field;
}

void PhotonField::indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const { look(points, lux_, lux); }

void PhotonField::gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const { look(points, gaps_, lux); }

void PhotonField::look(std::span<const FieldPoint> points, std::span<const Rgb> of, std::span<Rgb> lux) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& p = points[i];
        const auto element = elements_.at(p.mesh, p.triangle, p.u, p.v, p.frontFace);
        lux[i] = element == SurfaceElements::kNone || of.empty() ? Rgb{} : of[element];
    }
}

}  // namespace luxdeck

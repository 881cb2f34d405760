#include "engine/transport/control/controlled_estimator.h"

#include "engine/core/rng.h"
#include "engine/sampling/warp.h"
#include "engine/transport/path/path_estimator.h"
#include "engine/transport/radiosity/radiosity_field.h"
#include "engine/transport/surface/surface_elements.h"
#include "engine/transport/tracer/path_batch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace luxdeck {

namespace {

// Measured on the sample projects: variance times time is flat about these.
constexpr SensorSettings kSharing{.lightSamples = 2, .goesOn = 0.5F, .share = true};
constexpr std::size_t kGroup = 16;
/// Of the radiosity solution, relative to the setting: a hundred times as much gains less than 1 % of variance, which is that of paths.
constexpr double kEffort = 0.01;
/// Pieces of surface for the weight, each asked once on either side: its error is some percent, and it matters in second order.
constexpr std::size_t kPilots = 2048;
constexpr std::uint64_t kPilotStream = 0x636f6e74726f6c00ULL;

/// `shared` that owns its field.
class ControlledEstimator final : public RadianceEstimator {
public:
    ControlledEstimator(std::shared_ptr<const IrradianceField> field, std::size_t bytes, std::unique_ptr<RadianceEstimator> sharing)
        : field_(std::move(field)), bytes_(bytes), sharing_(std::move(sharing)) {}

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return sharing_->radiance(queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return sharing_->irradiance(queries, samples);
    }
    [[nodiscard]] std::size_t groupSize() const override { return sharing_->groupSize(); }
    [[nodiscard]] std::size_t bytes() const override { return bytes_; }

private:
    std::shared_ptr<const IrradianceField> field_;
    std::size_t bytes_;
    std::unique_ptr<RadianceEstimator> sharing_;
};

Result<std::unique_ptr<RadianceEstimator>> makeControlled(const TransportScene& scene, const AlgorithmSettings& settings,
                                                          std::shared_ptr<const IrradianceField> field, std::size_t bytes) {
    auto sensors = kSharing;
    sensors.control = field.get();
    sensors.controlWeight = controlWeight(scene, settings, *field);
    auto sharing = makePathEstimator(scene, settings, sensors, kGroup);
    if (!sharing) return sharing.error();
    return std::unique_ptr<RadianceEstimator>(std::make_unique<ControlledEstimator>(std::move(field), bytes, *std::move(sharing)));
}

/// Places on matte surfaces, in the forms that the field and the paths from there ask for.
struct Pilots {
    std::vector<FieldPoint> points;
    std::vector<RadianceQuery> queries;
};

Vec3 cosineDirection(const SurfacePoint& at, SamplePath& numbers) {
    return Frame::about(at.shadingNormal).toWorld(cosineHemisphere(numbers.next2D()));
}

/// What surfaces see of each other, as sensors among them would.
Pilots pilots(const TransportScene& scene, std::uint64_t seed) {
    const SurfaceElements elements(scene.scene, scene.needs, kPilots);
    std::vector<SamplePath> numbers;
    std::vector<Ray> rays;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        auto& own = numbers.emplace_back(streamSeed(seed, e, kPilotStream), 0);
        const auto place = elements.place(e, own.next2D());
        const Vec3 direction = cosineDirection(place, own);
        rays.push_back({place.departure(direction), 0, direction, kInfinity});
    }
    std::vector<Hit> hits(rays.size());
    scene.raycaster.closestHits(rays, hits, Targets::Surfaces);
    Pilots out;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const auto& hit = hits[i];
        if (!hit.surface()) continue;
        const auto met = surfacePoint(scene.scene, scene.needs, rays[i], hit);
        if (met.material->kind != MaterialKind::Matte) continue;
        const Vec3 from = met.departure(met.geometricNormal);
        out.points.push_back({from, met.shadingNormal, met.geometricNormal, hit.mesh, hit.triangle, hit.u, hit.v, met.frontFace});
        RadianceQuery& query = out.queries.emplace_back();
        query.ray = {from, 0, cosineDirection(met, numbers[i]), kInfinity};
        query.numbers = numbers[i];
    }
    return out;
}

}  // namespace

float controlWeight(const TransportScene& scene, const AlgorithmSettings& settings, const IrradianceField& field) {
    const auto asked = pilots(scene, settings.seed);
    std::vector<Rgb> lux(asked.points.size());
    std::vector<RadianceSample> found(asked.queries.size());
    field.indirect(asked.points, lux);
    TracerSettings tracer;
    tracer.maxVertices = settings.maxVertices;
    tracePaths(scene, tracer, asked.queries, found);
    double both = 0, squares = 0;
    for (std::size_t i = 0; i < lux.size(); ++i) {
        if (!isFinite(lux[i]) || found[i].failure != RayFailure::None) continue;
        const double f = luminance(lux[i]), d = kPiD * luminance(found[i].direct + found[i].indirect);
        both += d * f, squares += f * f;
    }
    return squares > 0 ? static_cast<float>(std::clamp(both / squares, 0.0, 1e6)) : 0.0F;
}

Result<std::unique_ptr<RadianceEstimator>> makeControlledEstimator(const TransportScene& scene, const AlgorithmSettings& settings,
                                                                   std::shared_ptr<const IrradianceField> field) {
    if (field == nullptr) return Error{ErrorCode::InvalidArgument, "there is no field to control by"};
    return makeControlled(scene, settings, std::move(field), 0);
}

Result<std::unique_ptr<RadianceEstimator>> makeControlledEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    auto coarse = settings;
    coarse.effort = std::max(1e-3, kEffort * settings.effort);
    auto field = RadiosityField::create(scene, coarse);
    if (!field) return field.error();
    const std::size_t bytes = (*field)->bytes();
    return makeControlled(scene, settings, *std::move(field), bytes);
}

}  // namespace luxdeck

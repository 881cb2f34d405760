#include "engine/transport/sensor/field_gather.h"

#include "engine/transport/sensor/illuminance.h"
#include "engine/transport/tracer/path_batch.h"

#include <utility>

namespace luxdeck {

namespace {

class FieldGather final : public RadianceEstimator {
public:
    FieldGather(const TransportScene& scene, int maxVertices, std::unique_ptr<const IrradianceField> field, std::size_t bytes)
        : scene_(scene), field_(std::move(field)), bytes_(bytes) {
        ofSensors_.maxVertices = maxVertices;
        ofSensors_.field = field_.get();
        ofRays_ = ofSensors_;
        ofRays_.fieldAfter = 1;
    }

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, ofRays_, queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return gatherIlluminance(scene_, ofSensors_, queries, samples);
    }
    [[nodiscard]] std::size_t bytes() const override { return bytes_; }

private:
    TransportScene scene_;
    std::unique_ptr<const IrradianceField> field_;
    std::size_t bytes_;
    TracerSettings ofSensors_, ofRays_;
};

}  // namespace

std::unique_ptr<RadianceEstimator> makeFieldGather(const TransportScene& scene, const AlgorithmSettings& settings,
                                                   std::unique_ptr<const IrradianceField> field, std::size_t fieldBytes) {
    return std::make_unique<FieldGather>(scene, settings.maxVertices, std::move(field), fieldBytes);
}

}  // namespace luxdeck

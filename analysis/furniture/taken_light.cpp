#include "analysis/furniture/taken_light.h"

#include "analysis/grids/grid_points.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/sampling/warp.h"
#include "engine/transport/tracer/light_choice.h"
#include "engine/transport/tracer/shadow.h"
#include "engine/volume/visible_lookup.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace luxdeck {

namespace {

constexpr std::uint64_t kDirections = 0x7a, kLamps = 0x7b;  // purposes of random streams
constexpr int kAzimuths = 8;                                // of a cylinder's illuminance from the volume

struct GridPoint {
    Vec3 position{0, 0, 0}, normal{0, 0, 1};
    bool cylindrical = false;
    std::uint64_t stream = 0;
};

/// What one point loses, with all that is shared by them.
class Taken {
public:
    Taken(const LitScene& lit, const FurnitureLighting& lighting, const RadianceEstimator& direct, const TakenSettings& settings)
        : scene_(lit.transport()), lighting_(lighting), direct_(direct), settings_(settings), weights_(scene_.scene.weights) {}

    TakenLight at(const GridPoint& point, const GroupLookup::Corners& corners) const {
        TakenLight out;
        Rgb direct, indirect, returned;
        lookAtObject(point, corners, direct, indirect, returned);
        seekLamps(point, direct);
        out.direct = luminance(direct, weights_), out.indirect = luminance(indirect, weights_), out.returned = luminance(returned, weights_);
        return out;
    }

private:
    [[nodiscard]] Ray inObject(const Ray& ray) const {
        const auto& place = lighting_.placement();
        return {place.back(ray.origin - place.shift), ray.tMin, place.back(ray.direction), ray.tMax};
    }
    [[nodiscard]] float pdf(const GridPoint& point, const Vec3& direction) const {
        const float c = dot(point.normal, direction);
        return point.cylindrical ? std::sqrt(std::max(0.0F, 1 - c * c)) / (kPi * kPi) : std::max(0.0F, c) / kPi;
    }
    /// What light of unit irradiance from a direction gives a sensor there.
    [[nodiscard]] float response(const GridPoint& point, const Vec3& direction) const { return kPi * pdf(point, direction); }
    [[nodiscard]] Receiver receiver(const GridPoint& point) const { return Receiver{point.position, point.cylindrical ? Vec3(0, 0, 0) : point.normal}; }

    /// Directions that meet the object, before anything of the room: what came from there, and what comes now.
    void lookAtObject(const GridPoint& point, const GroupLookup::Corners& corners, Rgb& direct, Rgb& indirect, Rgb& returned) const {
        std::vector<Ray> rays, own;
        const Frame frame = Frame::about(point.normal);
        for (std::uint32_t i = 0; i < settings_.directions; ++i) {
            SamplePath numbers(streamSeed(settings_.seed, point.stream, kDirections), i);
            const Vec2 u = numbers.next2D();
            rays.push_back({point.position, 0, frame.toWorld(point.cylindrical ? sineSphere(u) : cosineHemisphere(u)), kInfinity});
            own.push_back(inObject(rays.back()));
        }
        std::vector<Hit> hits(rays.size());
        lighting_.objectRays().raycaster().closestHits(own, hits, Targets::Opaque);
        std::vector<Ray> hidden;
        std::vector<Hit> met;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!hits[i].surface()) continue;
            rays[i].tMax = hits[i].distance;
            hidden.push_back(rays[i]), met.push_back(hits[i]);
        }
        std::vector<std::uint8_t> behind(hidden.size());
        scene_.raycaster.occluded(hidden, behind, Targets::Opaque);
        std::vector<RadianceQuery> queries;
        const Rgb each(kPi / static_cast<float>(settings_.directions));
        const auto bins = lighting_.volume().bins();
        for (std::size_t i = 0; i < hidden.size(); ++i) {
            if (behind[i] != 0) continue;
            RadianceQuery query;
            query.ray = hidden[i], query.ray.tMax = kInfinity;
            query.numbers = SamplePath(streamSeed(settings_.seed, point.stream, kDirections + 2), static_cast<std::uint32_t>(i));
            query.pdfSolidAngle = pdf(point, hidden[i].direction) * static_cast<float>(settings_.directions) / static_cast<float>(settings_.lightSamples);
            query.origin = receiver(point);
            queries.push_back(query);
            const auto bin = static_cast<std::size_t>(bins.binOf(hidden[i].direction));
            for (std::size_t c = 0; c < 8; ++c)
                if (corners.weights[c] != 0) indirect += each * lighting_.volume().indirectAt(corners.vertices[c])[bin] * corners.weights[c];
            returned += each * seen(met[i], inObject(hidden[i]).direction);
        }
        std::vector<RadianceSample> samples(queries.size());
        direct_.radiance(queries, samples);
        for (const auto& sample : samples)
            if (sample.failure == RayFailure::None) direct += each * sample.emitted;
    }

    /// Radiance of the object where it is met.
    [[nodiscard]] Rgb seen(const Hit& hit, const Vec3& direction) const {
        const auto v = lighting_.objectRays().vertexAt(hit);
        const Rgb lux = lighting_.lux()[v];
        if (dot(lighting_.object().normals[v], direction) >= 0 || !isFinite(lux)) return Rgb{};
        return lux * lighting_.object().reflectance[v] * (1 / kPi);
    }

    void seekLamps(const GridPoint& point, Rgb& direct) const {
        const auto at = receiver(point);
        const auto weights = scene_.lights.weigh(at);
        std::vector<Ray> rays, own;
        std::vector<Rgb> lux;
        const auto count = static_cast<float>(settings_.lightSamples);
        for (std::uint32_t i = 0; i < settings_.lightSamples; ++i) {
            SamplePath numbers(streamSeed(settings_.seed, point.stream, kLamps), i);
            const float uSelect = numbers.next1D();
            const auto light = chooseLight(scene_, at, weights, uSelect, numbers.next2D());
            const float counts = light.lit() ? response(point, light.direction) : 0;
            if (!(counts > 0)) continue;
            Rgb value = light.weight * (counts / count);
            if (light.shared) value *= light.pdfSolidAngle / (light.pdfSolidAngle + pdf(point, light.direction) * static_cast<float>(settings_.directions) / count);
            rays.push_back({point.position, 0, light.direction, light.distance * (1 - kShadowShortening)});
            own.push_back(inObject(rays.back()));
            lux.push_back(value);
        }
        std::vector<std::uint8_t> byObject(rays.size()), byRoom(rays.size());
        lighting_.objectRays().raycaster().occluded(own, byObject, Targets::Opaque);
        if (std::find(byObject.begin(), byObject.end(), 1) == byObject.end()) return;
        scene_.raycaster.occluded(rays, byRoom, Targets::Opaque);
        TransportCounters counters;
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (byObject[i] != 0 && byRoom[i] == 0) direct += scene_.needs.transmission ? lux[i] * paneTransmittance(scene_, rays[i], counters) : lux[i];
    }

    TransportScene scene_;
    const FurnitureLighting& lighting_;
    const RadianceEstimator& direct_;
    TakenSettings settings_;
    LuminanceWeights weights_;
};

/// The room's own light at a point, from the volume; NaN where nothing is known.
double emptyLux(const GridPoint& point, const VisibleLookup& lookup, const LuminanceWeights& weights) {
    double sum = 0;
    const Frame frame = Frame::about(point.normal);
    const int count = point.cylindrical ? kAzimuths : 1;
    for (int i = 0; i < count; ++i) {
        const float angle = 2 * kPi * static_cast<float>(i) / static_cast<float>(count);
        const Vec3 direction = point.cylindrical ? frame.toWorld({std::cos(angle), std::sin(angle), 0}) : point.normal;
        Rgb lux;
        lookup.at({&point.position, 1}, {&direction, 1}, {}, {&lux, 1});
        sum += luminance(lux, weights) / count;
    }
    return sum;
}

void summarize(GridTaken& grid) {
    const auto known = [](const TakenLight& point) { return std::isfinite(point.empty); };
    std::size_t count = 0;
    for (std::size_t i = 0; i < grid.points.size(); ++i) {
        const auto& p = grid.points[i];
        if (p.taken() > grid.points[grid.most].taken()) grid.most = i;
        if (!known(p)) continue;
        ++count;
        grid.mean.empty += p.empty, grid.mean.direct += p.direct, grid.mean.indirect += p.indirect, grid.mean.returned += p.returned;
    }
    grid.unknown = grid.points.size() - count;
    for (double* x : {&grid.mean.empty, &grid.mean.direct, &grid.mean.indirect, &grid.mean.returned}) *x /= static_cast<double>(std::max<std::size_t>(count, 1));
}

}  // namespace

Result<std::vector<GridTaken>> estimateTaken(const Project& project, const LitScene& lit, const FurnitureLighting& lighting, const TakenSettings& settings) {
    const auto direct = makeEstimator("direct", lit.transport());
    if (!direct) return direct.error();
    FieldSettings fieldSettings;
    fieldSettings.blendBins = true;
    const auto field = VolumeField::make(lighting.volume(), fieldSettings);
    if (!field) return field.error();
    const VisibleLookup visible(*field, lit.raycaster());
    const Taken taken(lit, lighting, **direct, settings);
    std::vector<GridTaken> out;
    std::uint64_t stream = 0;
    for (const auto& grid : project.grids) {
        const auto layout = layOut(grid);
        if (!layout) return layout.error();
        std::vector<GridPoint> points;
        std::vector<Vec3> positions, normals;
        for (std::size_t i = 0; i < layout->points.size(); ++i) {
            points.push_back({project.scene.toRebased(layout->points[i]), Vec3(layout->normals[i]), grid.kind == GridKind::Cylindrical, stream++});
            positions.push_back(points.back().position), normals.push_back(points.back().normal);
        }
        GroupLookup lookup(lighting.volume(), &lit.raycaster());
        lookup.find(positions, normals);
        GridTaken result{grid.name, {}, {}};
        result.points.resize(points.size());
        parallelFor(points.size(), [&](std::size_t i) {
            result.points[i] = taken.at(points[i], lookup.weights(i));
            result.points[i].empty = emptyLux(points[i], visible, project.scene.weights);
        });
        summarize(result);
        out.push_back(std::move(result));
    }
    return out;
}

}  // namespace luxdeck

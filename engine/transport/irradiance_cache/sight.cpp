#include "engine/transport/irradiance_cache/sight.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Of the way between record and point, above or below the surfaces.
constexpr float kInPlane = 2e-3F;
constexpr float kInPlaneHeight = 0.02F;  // what is lower than this is no wall
constexpr float kOffPlane = 0.03F;
constexpr float kShortening = 1e-4F;

Ray between(const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const float length = way.length();
    return {from, 0, way / length, length * (1 - kShortening)};
}

/// Over a point half way between them, this high above both surfaces.
SightRays over(const IrradianceRecord& record, const FieldPoint& point, float height) {
    const Vec3 outwards = (record.geometricNormal + point.geometricNormal).normalized();
    const Vec3 peak = (record.position + point.position) * 0.5F + outwards * height;
    return {{between(point.position, peak), between(record.position, peak)}, 2};
}

}  // namespace

Sight sightOf(const IrradianceRecord& record, const FieldPoint& point, SightRays& rays) {
    const Vec3 way = point.position - record.position;
    const float length = way.length();
    if (!(length > 0)) return Sight::Open;
    const float aboveRecord = dot(way, record.geometricNormal), abovePoint = -dot(way, point.geometricNormal);
    if (std::abs(aboveRecord) <= kInPlane * length && std::abs(abovePoint) <= kInPlane * length) {
        const auto told = record.horizon.of(Frame::about(record.geometricNormal).toLocal(way));
        if (told != Horizon::Tells::Nothing) return told == Horizon::Tells::Seen ? Sight::Open : Sight::Hidden;
        rays = over(record, point, kInPlaneHeight * length);
        return Sight::Asked;
    }
    if (std::abs(aboveRecord - abovePoint) > 2 * kOffPlane * length || dot(record.geometricNormal, point.geometricNormal) < 0) return Sight::Hidden;
    const float below = std::max(-aboveRecord, -abovePoint);
    // Where the surface bulges, half way at this height lies the meeting of the tangent planes.
    if (below > 0) rays = over(record, point, 0.5F * below * (1 + kInPlane));
    else rays.rays[0] = between(point.position, record.position), rays.count = 1;
    return Sight::Asked;
}

}  // namespace luxdeck

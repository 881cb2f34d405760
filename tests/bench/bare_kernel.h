#pragma once

// Embree without any of Luxdeck around it: what the engine's rates are compared with.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#define LUXDECK_BENCH_EMBREE 4
#else
#include <embree3/rtcore.h>
#define LUXDECK_BENCH_EMBREE 3
#endif

#include "engine/raycast/raycaster.h"

#include <cstring>
#include <span>

namespace luxdeck::bench {

/// Triangles of a scene in a robust Embree scene, asked in a bare loop.
class BareKernel {
public:
    enum class Holds { Surfaces, OpaqueSurfaces };

    BareKernel(const Scene& scene, Holds holds) : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        for (const auto& mesh : scene.meshes) {
            const bool pane = scene.letsStraightThrough(scene.materials[mesh.material]);
            if (!mesh.triangles.empty() && !(pane && holds == Holds::OpaqueSurfaces)) attach(mesh);
        }
        rtcCommitScene(scene_);
    }
    ~BareKernel() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }
    BareKernel(const BareKernel&) = delete;
    BareKernel& operator=(const BareKernel&) = delete;

    /// How many of the rays meet something.
    [[nodiscard]] std::size_t closestHits(std::span<const Ray> rays) const {
        std::size_t hits = 0;
        RTCRayHit query;
        for (const auto& ray : rays) {
            fill(query.ray, ray);
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if LUXDECK_BENCH_EMBREE == 4
            rtcIntersect1(scene_, &query);
#else
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            rtcIntersect1(scene_, &context, &query);
#endif
            hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
        return hits;
    }

    /// How many of the rays are occluded.
    [[nodiscard]] std::size_t occluded(std::span<const Ray> rays) const {
        std::size_t hits = 0;
        RTCRay query;
        for (const auto& ray : rays) {
            fill(query, ray);
#if LUXDECK_BENCH_EMBREE == 4
            rtcOccluded1(scene_, &query);
#else
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            rtcOccluded1(scene_, &context, &query);
#endif
            hits += query.tfar < 0 ? 1 : 0;
        }
        return hits;
    }

private:
    void attach(const Mesh& mesh) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                                  mesh.positions.size());
        std::memcpy(positions, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3));
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                                   sizeof(mesh.triangles[0]), mesh.triangles.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }

    static void fill(RTCRay& out, const Ray& ray) {
        out.org_x = ray.origin.x, out.org_y = ray.origin.y, out.org_z = ray.origin.z;
        out.dir_x = ray.direction.x, out.dir_y = ray.direction.y, out.dir_z = ray.direction.z;
        out.tnear = ray.tMin, out.tfar = ray.tMax;
        out.time = 0, out.id = 0, out.flags = 0, out.mask = 0xffffffffU;
    }

    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace luxdeck::bench

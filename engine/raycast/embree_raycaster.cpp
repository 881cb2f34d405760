// The only file that names Embree. Version 3 (Debian 12) and 4 (Debian 13) differ in include path, in the
// query's context and in the user-geometry arguments' names; nothing else.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#define LUXDECK_EMBREE 4
#else
#include <embree3/rtcore.h>
#define LUXDECK_EMBREE 3
#endif

#include "engine/raycast/raycaster.h"
#include "engine/scene/opening.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <memory>
#include <vector>

namespace luxdeck {

namespace {

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using KernelScene = std::unique_ptr<RTCSceneTy, SceneRelease>;

/// The openings as Embree's user geometry.
struct Openings {
    std::vector<PlacedOpening> shapes;       // #O
    std::vector<std::uint32_t> luminaires;   // #O, index into Scene::luminaires
};

void openingBounds(const RTCBoundsFunctionArguments* args) {
    const auto box = static_cast<const Openings*>(args->geometryUserPtr)->shapes[args->primID].bounds();
    auto& out = *args->bounds_o;
    out.lower_x = box.min.x, out.lower_y = box.min.y, out.lower_z = box.min.z;
    out.upper_x = box.max.x, out.upper_y = box.max.y, out.upper_z = box.max.z;
}

void intersectOpening(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);  // only single-ray queries are made: N is 1
    const auto& ray = rayhit.ray;
    const auto& shape = static_cast<const Openings*>(args->geometryUserPtr)->shapes[args->primID];
    const auto met = shape.intersect({ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tnear, ray.tfar);
    if (!met) return;
    rayhit.ray.tfar = met->distance;
    rayhit.hit.geomID = args->geomID;
    rayhit.hit.primID = args->primID;
    rayhit.hit.u = rayhit.hit.v = 0;
}

void occludeByOpening(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& ray = *reinterpret_cast<RTCRay*>(args->ray);  // N is 1 here as well
    const auto& shape = static_cast<const Openings*>(args->geometryUserPtr)->shapes[args->primID];
    if (shape.intersect({ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tnear, ray.tfar))
        ray.tfar = -kInfinity;
}

bool has(Targets targets, Targets one) {
    return (static_cast<std::uint32_t>(targets) & static_cast<std::uint32_t>(one)) != 0;
}

void setRay(RTCRay& out, const Ray& ray) {
    out.org_x = ray.origin.x, out.org_y = ray.origin.y, out.org_z = ray.origin.z;
    out.dir_x = ray.direction.x, out.dir_y = ray.direction.y, out.dir_z = ray.direction.z;
    out.tnear = ray.tMin, out.tfar = ray.tMax;
    out.time = 0, out.id = 0, out.flags = 0;
    out.mask = 0xffffffffU;
}

void intersect1(RTCScene scene, RTCRayHit& rayhit) {
#if LUXDECK_EMBREE == 4
    rtcIntersect1(scene, &rayhit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &rayhit);
#endif
}

bool occluded1(RTCScene scene, RTCRay& ray) {
#if LUXDECK_EMBREE == 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
    return ray.tfar < 0;  // set to -infinity by the kernel
}

/// Opaque triangles, panes and openings lie in a kernel scene each: a question about panes alone, which every
/// unhidden shadow ray asks, then costs a look at a few triangles instead of a walk through all that it passes;
/// and no query pays for masks. A question about several kinds asks one after the other, each only up to
/// what was met before.
class EmbreeRaycaster final : public Raycaster {
public:
    static Result<std::unique_ptr<Raycaster>> make(const Scene& scene) {
        auto caster = std::make_unique<EmbreeRaycaster>();
        if (auto ok = caster->build(scene); !ok) return ok.error();
        return std::unique_ptr<Raycaster>(std::move(caster));
    }

    void closestHits(std::span<const Ray> rays, std::span<Hit> hits, Targets targets) const override {
        const Kernels kernels = kernelsOf(targets);
        RTCRayHit rayhit;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i] = Hit{};
            if (!isGood(rays[i])) {
                hits[i].badRay = true;
                continue;
            }
            setRay(rayhit.ray, rays[i]);
            rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            for (std::size_t k = 0; k < kernels.count; ++k) intersect1(kernels.scenes[k], rayhit);
            if (rayhit.hit.geomID != RTC_INVALID_GEOMETRY_ID) hits[i] = hitOf(rayhit);
        }
    }

    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> out, Targets targets) const override {
        const Kernels kernels = kernelsOf(targets);
        RTCRay ray;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            out[i] = 1;
            if (!isGood(rays[i])) continue;
            setRay(ray, rays[i]);
            bool met = false;
            for (std::size_t k = 0; k < kernels.count && !met; ++k) met = occluded1(kernels.scenes[k], ray);
            out[i] = met ? 1 : 0;
        }
    }

    [[nodiscard]] std::string kernel() const override {
        const auto version = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_VERSION);
        return fmt::format("Embree {}.{}.{}", version / 10000, version / 100 % 100, version % 100);
    }

    [[nodiscard]] std::size_t bytes() const override {
        return static_cast<std::size_t>(std::max<std::int64_t>(0, bytes_.load()));
    }

private:
    /// The kernel scenes that a question is about, those left out that hold nothing.
    struct Kernels {
        std::array<RTCScene, 3> scenes{};
        std::size_t count = 0;
    };
    [[nodiscard]] Kernels kernelsOf(Targets targets) const {
        Kernels out;
        const auto add = [&](Targets kind, const KernelScene& scene) {
            if (scene && has(targets, kind)) out.scenes[out.count++] = scene.get();
        };
        add(Targets::Opaque, opaque_), add(Targets::Panes, panes_), add(Targets::Openings, openingScene_);
        return out;
    }

    [[nodiscard]] Hit hitOf(const RTCRayHit& rayhit) const {
        Hit hit;
        hit.distance = rayhit.ray.tfar;
        if (rayhit.hit.geomID == openingGeometry_) {
            hit.luminaire = openings_.luminaires[rayhit.hit.primID];
        } else {
            hit.mesh = rayhit.hit.geomID;
            hit.triangle = rayhit.hit.primID;
            hit.u = rayhit.hit.u, hit.v = rayhit.hit.v;
        }
        return hit;
    }

    Result<void> build(const Scene& scene) {
        device_.reset(rtcNewDevice(nullptr));
        if (!device_) return Error{ErrorCode::OutOfResources, "the ray kernel cannot start"};
        rtcSetDeviceMemoryMonitorFunction(device_.get(), [](void* self, ssize_t bytes, bool) {
            static_cast<EmbreeRaycaster*>(self)->bytes_ += bytes;
            return true;
        }, this);
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) attachMesh(scene, static_cast<unsigned>(i));
        openingGeometry_ = static_cast<unsigned>(scene.meshes.size());
        attachOpenings(scene);
        for (const auto* kernel : {&opaque_, &panes_, &openingScene_})
            if (*kernel) rtcCommitScene(kernel->get());
        if (const auto code = rtcGetDeviceError(device_.get()); code != RTC_ERROR_NONE)
            return Error{code == RTC_ERROR_OUT_OF_MEMORY ? ErrorCode::OutOfResources : ErrorCode::Internal,
                         fmt::format("the ray kernel failed to build (Embree error {})", static_cast<int>(code))};
        return {};
    }

    /// Attaches a geometry to a kernel scene, made when it is first needed.
    void attach(KernelScene& kernel, RTCGeometry geometry, unsigned id) {
        if (!kernel) {
            kernel.reset(rtcNewScene(device_.get()));
            rtcSetSceneFlags(kernel.get(), RTC_SCENE_FLAG_ROBUST);  // without it shared edges lose rays
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(kernel.get(), geometry, id);
        rtcReleaseGeometry(geometry);
    }

    void attachMesh(const Scene& scene, unsigned index) {
        const auto& mesh = scene.meshes[index];
        if (mesh.triangles.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        // Positions are copied: the kernel reads 16 bytes at the last one, 4 beyond a shared vector's end.
        void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                                  mesh.positions.size());
        if (positions != nullptr) std::memcpy(positions, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3));
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                                   sizeof(mesh.triangles[0]), mesh.triangles.size());
        const bool pane = scene.letsStraightThrough(scene.materials[mesh.material]);
        attach(pane ? panes_ : opaque_, geometry, index);
    }

    void attachOpenings(const Scene& scene) {
        for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
            const auto& l = scene.luminaires[i];
            const auto& type = scene.luminaireTypes[l.type];
            const auto placed = PlacedOpening::of(l, type.photometry.opening);
            // Those that give light, exactly: paths ask the light sampler for every opening that they meet.
            if (placed.shape == OpeningShape::Point || !(runningLumens(l, type) > 0)) continue;
            openings_.shapes.push_back(placed);
            openings_.luminaires.push_back(static_cast<std::uint32_t>(i));
        }
        if (openings_.shapes.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(openings_.shapes.size()));
        rtcSetGeometryUserData(geometry, &openings_);
        rtcSetGeometryBoundsFunction(geometry, openingBounds, nullptr);
        rtcSetGeometryIntersectFunction(geometry, intersectOpening);
        rtcSetGeometryOccludedFunction(geometry, occludeByOpening);
        attach(openingScene_, geometry, openingGeometry_);
    }

    std::atomic<std::int64_t> bytes_{0};  // first: the device reports to it until it is released
    Openings openings_;
    Device device_;
    KernelScene opaque_, panes_, openingScene_;  // null: the scene has none
    unsigned openingGeometry_ = RTC_INVALID_GEOMETRY_ID;
};

}  // namespace

Result<std::unique_ptr<Raycaster>> makeEmbreeRaycaster(const Scene& scene) { return EmbreeRaycaster::make(scene); }

}  // namespace luxdeck

#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/spectrum.h"
#include "engine/transport/tracer/irradiance_field.h"
#include "engine/transport/tracer/media.h"
#include "engine/transport/tracer/mirrored_light.h"

#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

struct SurfacePoint;

/// Where a path was first scattered, met straight: nothing but glass panes before it. What its surface scatters
/// alike in all directions looks the same to all who see the place, but for a factor of the angle.
struct FirstBounce {
    bool met = false;
    Vec3 position{0, 0, 0};         // just off the surface [m]
    Vec3 geometricNormal{0, 0, 1};  // to the side that was met
    Vec3 shadingNormal{0, 0, 1};
    Hit hit;                        // for the factor of the angle; of a matte or Ward surface it is 1
    bool coated = false;            // the factor is not 1
    bool behindPanes = false;
    Rgb passed{1.0F};               // transmittance of the panes over the chance of going through
    Rgb diffuse;                    // the part of the sample's reflected radiance that was scattered so [cd/m^2]
};

/// What a tracer follows.
struct TracerSettings {
    int maxReflections = 1 << 30;  // light that was reflected more often is left out
    int maxVertices = 20000;       // the cap on what Russian roulette leaves alive
    Rgb ambientRadiance{0.0F};     // constant radiance that every rough surface reflects instead of the
                                   // reflections left out [cd/m^2]
    const IrradianceField* field = nullptr;      // not null: matte surfaces take their indirect light from it, and no
                                                 // path goes on from them but to see light straight
    int fieldAfter = 0;                          // reflections before the field is asked: 0 from the first surface on
    std::vector<FieldLink>* links = nullptr;     // not null, with a field: where it was asked is appended, and what for; of
                                                 // failed samples too
    std::vector<SourceShare>* shares = nullptr;  // not null: what each light gave is appended to it; of radiance,
                                                 // `direct` being what was emitted
    std::span<FirstBounce> bounces;              // empty, or filled for each query
    float goesOn = 1;                            // with bounces: the part of the paths that go on from a matte one
    const IrradianceField* control = nullptr;    // with bounces, not null: lights are sought at a matte one by all paths;
                                                 // what lies beyond is the field's word for all, and for the part that
                                                 // goes on what the path found instead. Samples may be negative
    float controlWeight = 1;                     // of the field's word: any value is exact in the mean
};

/// A batch of light paths, followed together from where light is asked for towards the lights: trace all
/// rays, shade all hits, trace all shadow rays, drop what ended, again. One call per batch to the kernel,
/// nothing allocated inside the loop.
template <Spectrum S>
class PathBatch {
public:
    PathBatch(const TransportScene& scene, const TracerSettings& settings, std::span<const RadianceQuery> queries,
              std::span<RadianceSample> samples);

    /// Follows every path to its end and fills the samples.
    TransportCounters run();

private:
    /// All there is to one path between two rays.
    struct Path {
        Ray ray;
        SamplePath numbers;
        S throughput{1.0F};
        std::uint32_t query = 0;
        int reflections = 0;       // so far, mirrors included, passages through panes and into solids not
        int vertices = 0;
        int mostReflections = 1 << 30;  // of its light
        bool straight = true;      // only panes so far, passed straight through
        S passed{1.0F};            // their weights
        S diffuse{0.0F};           // the part of what comes that its first bounce scattered alike in all directions
        Receiver from;             // where the direction was sampled
        float pdfSolidAngle = 0;   // of the direction; 0: no other strategy, light counts in full
        float travelled = 0;       // along specular vertices since the start [m]
        std::uint32_t mirror = kNoMirror;  // the flat mirror or pane that turned the path since it was scattered last,
                                           // when next-event estimation looked that way too
        bool virtualOpen = true;   // only mirrors and panes so far
        bool lost = false;         // it met a surface without a value and goes on as from a white one: what it finds may
                                   // be missing in the sample, and is no part of it
        bool byChance = false;     // what it meets next is found by no other strategy
        bool ended = false;
    };
    struct Shadow {
        S contribution;
        std::uint32_t query;
        int reflections;
        LightSource source;
        S diffuse;
    };

    /// What a field is asked, and what its answer counts.
    struct FromField {
        S weight;              // radiance for each lx
        std::uint32_t query;
        int reflections;
        S diffuse;
    };

    struct Mirrored {
        MirrorPath path;
        S contribution;
        Vec3 origin;
        std::uint32_t query;
        int reflections;
        S diffuse;
    };

    void trace();
    void passOpenings(std::size_t i);
    void findMedia();
    void shade(std::size_t i);
    [[nodiscard]] bool meets(Path& path, const Hit& hit, SurfacePoint& point);
    void shadeMet(Path& path, const Hit& hit, const SurfacePoint& point);
    void fail(std::uint32_t query, RayFailure failure, const Rgb& lost);
    void loseSight(Path& path, const Hit& hit, SurfacePoint& point);
    void weighUnseen(Path& path, const SurfacePoint& point);
    [[nodiscard]] bool reaches(Ray ray);
    void noteFound(const Path& path, const S& radiance);
    static void goStraightOn(Path& path, const SurfacePoint& point);
    /// The path's throughput when it has gone this far through what it is in.
    [[nodiscard]] S throughputAfter(const Path& path, float distance) const;
    [[nodiscard]] float surroundingIor(const Path& path, const SurfacePoint& point) const;
    void seeSky(Path& path);
    void seeOpening(const Path& path, const Hit& hit);
    void seeSurface(const Path& path, const Hit& hit, const SurfacePoint& point);
    void recordFirst(const Path& path, const Hit& hit, const SurfacePoint& point);
    void recordVirtual(Path& path, float distance, bool specular);
    void roulette(Path& path);
    void truncate(Path& path);
    template <class B>
    void connectByMirror(Path& path, const Receiver& here, const SurfacePoint& point, const Frame& frame, const Vec3& wo, const B& bsdf);
    void traceMirrored();
    void traceShadows();
    void askField(const Path& path, const Hit& hit, const SurfacePoint& point, const Receiver& here, const S& albedo, float factor);
    [[nodiscard]] bool goesBeyondControl(Path& path, const Hit& hit, const SurfacePoint& point, const Receiver& here, const S& albedo);
    void takeFromField();
    void takeGaps();
    void removeEnded();
    /// Adds to the part that light with this many reflections belongs to.
    void add(std::uint32_t query, int reflections, LightSource source, const S& radiance, const S& diffuse);
    void add(const Path& path, LightSource source, const S& radiance) {
        add(path.query, countedAs(path, path.reflections), source, radiance, path.diffuse);
    }
    /// What add() is told of light that comes to a path's end after so many reflections.
    static int countedAs(const Path& path, int reflections) { return path.lost ? kLost : reflections; }
    [[nodiscard]] bool looksAlike(const Path& path, const Hit& hit, const SurfacePoint& point) const;
    void thinOut(Path& path, const SurfacePoint& point);
    [[nodiscard]] S diffusePart(const Path& path, const S& diffuse, const S& all) const;
    [[nodiscard]] bool atFirstBounce(const Path& path) const { return path.straight && !settings_.bounces.empty(); }
    TransportCounters finish();

    /// The part of light found by the path's own direction, next-event estimation taking the rest.
    static float weightOfDirection(const Path& path, float lightPdf) {
        return path.pdfSolidAngle == 0 ? 1.0F : path.pdfSolidAngle / (path.pdfSolidAngle + lightPdf);
    }

    template <class B>
    void scatterSpecular(Path& path, const Hit& hit, const SurfacePoint& point, const B& bsdf);
    template <class B>
    void scatterBoundary(Path& path, const SurfacePoint& point, const B& bsdf);
    template <class B>
    void scatterRough(Path& path, const Hit& hit, const SurfacePoint& point, const B& bsdf, bool last);
    template <class B>
    void connectLight(Path& path, const Receiver& here, const SurfacePoint& point, const Frame& frame, const Vec3& wo,
                      const B& bsdf);
    template <class B>
    void scatter(Path& path, const Receiver& here, const SurfacePoint& point, const Frame& frame, const Vec3& wo,
                 const B& bsdf);

    static constexpr int kLost = -1;  // reflections of light that a failed sample may be missing

    const TransportScene& scene_;
    TracerSettings settings_;
    bool byMirrors_;  // lights are sought by way of mirrors
    std::span<const RadianceQuery> queries_;
    std::span<RadianceSample> samples_;
    std::vector<Path> paths_;
    std::vector<Media> media_;  // by query; empty where no solid refracts
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    std::vector<Shadow> shadows_;
    std::vector<Mirrored> mirrored_;
    std::vector<FromField> fromField_;
    std::vector<FieldPoint> fieldPoints_;
    std::vector<Rgb> fieldLux_;
    std::vector<Ray> shadowRays_;
    std::vector<std::uint8_t> shadowed_;
    TransportCounters counters_;
};

/// Follows a batch in the spectrum that the scene needs.
TransportCounters tracePaths(const TransportScene& scene, const TracerSettings& settings,
                             std::span<const RadianceQuery> queries, std::span<RadianceSample> samples);

}  // namespace luxdeck

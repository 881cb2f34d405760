#pragma once

#include "engine/core/vec.h"
#include "engine/sampling/alias_table.h"
#include "engine/sampling/light_tree.h"
#include "engine/sampling/receiver.h"
#include "engine/scene/needs.h"
#include "engine/scene/opening.h"
#include "engine/scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luxdeck {

/// Where light comes from: the index of a luminaire, or one of these.
using LightSource = std::uint32_t;
inline constexpr LightSource kFromSky = 0xffffffffU;       // sky and sun
inline constexpr LightSource kFromSurfaces = 0xfffffffeU;  // emitting surfaces
inline constexpr LightSource kFromAmbient = 0xfffffffdU;   // an algorithm's constant term

/// A direction towards a light, chosen by next-event estimation.
struct LightSample {
    Vec3 direction{0, 0, 1};   // unit, from the point to the light
    float distance = 0;        // [m]
    Rgb weight;                // radiance over density; of a point light: intensity / d^2 over probability
    float pdfSolidAngle = 0;   // density of the direction; 0: a point, which no other strategy can find
    bool shared = false;       // the receiver's own directions look for this light too: weigh the two
    LightSource source = kFromSky;

    [[nodiscard]] bool lit() const { return !weight.isBlack(); }
};

/// A rectangle that light must pass on its way.
struct MirrorFrame {
    Vec3 centre{0, 0, 0};
    Vec3 u{1, 0, 0}, v{0, 1, 0};  // unit, in its plane
    float halfU = 0, halfV = 0;   // [m]
};

/// Chooses points on luminaires and emitting surfaces. With few luminaires each is weighed at the receiver
/// by its intensity towards it, 1/d^2 and the cosine; with many a tree over luminaires and emitting
/// triangles chooses. The sky is left to the receivers' own directions.
///
/// A light that is small as seen from a matte receiver is left to next-event estimation alone: weighing in
/// directions that rarely meet it would only add noise. Near or glossy, both strategies share it.
class LightSampler {
public:
    LightSampler(const Scene& scene, const SceneNeeds& needs);

    [[nodiscard]] bool empty() const { return lights_.empty() && triangles_.empty(); }

    /// How much each light matters at a receiver, weighed once for thousands of samples at one place. One by one up
    /// to kMostWeighed lights; beyond, the tree is asked for every sample.
    struct Weights {
        std::array<float, kManyLights + 1> few{};  // sums of importances up to each, the triangles last
        std::vector<float> many;                   // sums of chances in the tree's order; empty: descend
    };
    static constexpr std::size_t kMostWeighed = 16384;
    [[nodiscard]] Weights weigh(const Receiver& at) const;

    /// The same where light comes through a window, as by way of a mirror behind which the receiver stands: lights
    /// that do not show in it keep a small part of their weight.
    [[nodiscard]] Weights weighThrough(const Receiver& at, const MirrorFrame& window) const;

    /// uSelect chooses the light, u the point on it.
    [[nodiscard]] LightSample sample(const Receiver& at, float uSelect, Vec2 u) const;
    /// The same for a receiver that was weighed before.
    [[nodiscard]] LightSample sample(const Receiver& at, const Weights& weights, float uSelect, Vec2 u) const;

    /// The opening of a luminaire that gives light.
    [[nodiscard]] const PlacedOpening& opening(std::uint32_t luminaire) const { return lights_[lightOfLuminaire_[luminaire]].opening; }
    /// Radiance that an opening gives into a unit direction leaving it [cd/m^2].
    [[nodiscard]] Rgb openingRadiance(std::uint32_t luminaire, const Vec3& leaving) const;
    /// Density with which sample() would have chosen the direction in which a ray met this opening;
    /// infinite when next-event estimation has this light to itself.
    [[nodiscard]] float pdfOpening(const Receiver& at, std::uint32_t luminaire, const Vec3& direction) const;
    /// The same for an emitting triangle, `cosine` being that between its normal and the direction.
    [[nodiscard]] float pdfTriangle(const Receiver& at, std::uint32_t mesh, std::uint32_t triangle, float distance,
                                    float cosine) const;

private:
    /// A luminaire as sampling needs it, in one cache-friendly record.
    struct Light {
        PlacedOpening opening;
        const CandelaTable* table;
        std::uint32_t luminaire;
        std::uint32_t type;
        float radius;                 // of the opening about its centre [m]
        float scale;                  // of the table
        float powerShare;             // of all lights
        Rgb colour;
    };
    struct TriangleLight {
        std::uint32_t mesh, triangle;
        float areaM2;
        Vec3 centroid;
        float fluxCd;                 // luminance * area
    };
    /// What weighing a light takes, a row for each number: weighing all lights at every vertex of every path is
    /// the dearest thing beside the rays, and in rows the compiler does several at once.
    struct WeighingRows {
        using Row = std::array<float, kManyLights>;
        Row x{}, y{}, z{};                 // centre [m]
        Row radius{};                      // of the opening about its centre [m]
        Row tx{}, ty{}, tz{}, bx{}, by{}, bz{}, nx{}, ny{}, nz{};  // axes of its frame
        Row scale{};                       // of the table; 0 beyond the last light
        std::array<int, kManyLights> map{};  // where the light's importance map begins in maps_
    };
    static constexpr int kMapSide = LightTree::kMapSide;

    using Sums = std::array<float, kManyLights + 1>;
    struct Choice {
        std::uint32_t light;  // from lights_.size() on the triangles: all as one, with the tree each
        float probability;
    };

    void addLuminaires(const Scene& scene);
    void addTriangles(const Scene& scene);
    void addImportanceMap(const CandelaTable& table);
    void fillRows();
    void growTree();
    [[nodiscard]] TreeLight treeLight(const TriangleLight& light, std::uint32_t firstMap) const;
    [[nodiscard]] float triangleImportance(const Receiver& at) const;
    [[nodiscard]] float powerShare(std::uint32_t light) const {
        return light < lights_.size() ? lights_[light].powerShare : trianglesPowerShare_;
    }
    [[nodiscard]] static float importanceIn(const Sums& sums, std::uint32_t light);
    [[nodiscard]] float mixed(float importance, float sum, float powerShare) const;
    [[nodiscard]] Choice choose(const Receiver& at, const Sums& sums, float& u) const;
    [[nodiscard]] Sums sumsOfFew(const Receiver& at) const;
    [[nodiscard]] LightSample choosePoint(const Receiver& at, const Choice& choice, float uSelect, Vec2 u) const;
    [[nodiscard]] float probability(const Receiver& at, std::uint32_t light) const;
    [[nodiscard]] static bool shared(const Receiver& at, const Light& light);
    [[nodiscard]] static bool shared(const Receiver& at, const TriangleLight& light);
    [[nodiscard]] LightSample sampleLuminaire(const Light& light, const Receiver& at, Vec2 u) const;
    [[nodiscard]] LightSample sampleTriangle(const Receiver& at, const AliasTable::Draw& draw, Vec2 u) const;
    [[nodiscard]] Rgb triangleRadiance(const TriangleLight& light, const Vec3& position, const Vec2& uv,
                                       const LightSample& towards) const;

    const Scene* scene_;
    bool manyLights_;
    std::vector<Light> lights_;
    std::vector<std::uint32_t> lightOfLuminaire_;  // index into lights_, kNoLight
    /// Intensity by direction, coarse and quick: an octahedral map of kMapSide^2 for each type of luminaire, one
    /// after the other. They decide only how often a light is asked.
    std::vector<float> maps_;
    WeighingRows rows_;
    LightTree tree_;                               // over lights_, then triangles_; empty where there are few
    AliasTable powers_;                            // of lights_, then the triangles as one
    std::vector<TriangleLight> triangles_;
    std::vector<std::vector<std::uint32_t>> triangleIndex_;  // by mesh and triangle: index into triangles_
    AliasTable trianglePowers_;
    float trianglesFlux_ = 0;                      // sum of luminance * area [cd]
    float trianglesPowerShare_ = 0;
    Vec3 trianglesCentre_;
    float trianglesRadius_ = 0;
};

}  // namespace luxdeck

#include "analysis/stability/cases.h"

#include <cmath>
#include <limits>

namespace luxdeck::stability {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// A lit room in which one vertex of the mesh "broken" is not a place.
Result<Scene> withVertex(float coordinate) {
    SceneBuilder b;
    const auto matte = b.matte(0.5F);
    b.box({0, 0, 0}, {4, 4, 4}, matte, true).isotropic({2, 2, 2}, 1000);
    Mesh broken;
    broken.name = "broken", broken.material = matte;
    broken.positions = {{1, 1, 1}, {2, 1, 1}, {1, coordinate, 1}};
    broken.triangles = {{0, 1, 2}};
    return b.mesh(std::move(broken)).checked();
}

Result<Scene> withReflectance(float reflectance) {
    SceneBuilder b;
    return b.box({0, 0, 0}, {4, 4, 4}, b.matte(reflectance, "broken"), true).checked();
}

}  // namespace

void addInputCases(Cases& cases) {
    const std::vector<SensorQuery> floor{facing({2, 2, 0}, {0, 0, 1})};
    const auto vertex = isRefused("\"broken\": vertex 2 is"), material = isRefused("\"broken\": reflectance is");
    cases.push_back({"a vertex that is NaN", [] { return withVertex(kNan); }, floor, vertex, vertex});
    cases.push_back({"a vertex that is infinite", [] { return withVertex(kInf); }, floor, vertex, vertex});
    cases.push_back({"a reflectance of 1.2", [] { return withReflectance(1.2F); }, floor, material, material});
    cases.push_back({"a reflectance that is NaN", [] { return withReflectance(kNan); }, floor, material, material});
}

}  // namespace luxdeck::stability

#include "engine/transport/surface/surface_elements.h"

#include "engine/core/rng.h"
#include "engine/sampling/octahedral.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck {

namespace {

constexpr double kMostOfOne = 0.125;    // of all pieces that one triangle may take
constexpr double kMuchSmaller = 0.25;   // of a piece: a triangle below it is joined with its neighbours
constexpr int kFacingSide = 6;          // of the map of directions: those of one texel face the same way
constexpr float kBorder = 1e-3F;        // points on an edge might lie beyond the face that meets there, and leak light
constexpr int kBisections = 60;
constexpr double kDeepest = 24;         // halvings

/// A part of a triangle: corners, and barycentric weights of something there.
struct Part {
    std::array<Vec3, 3> corners;
    std::array<float, 3> weights;

    /// Turns it so that its longest edge is opposite its first corner.
    void turn() {
        const float opposite0 = (corners[2] - corners[1]).length2(), opposite1 = (corners[0] - corners[2]).length2();
        const float opposite2 = (corners[1] - corners[0]).length2();
        if (opposite0 >= opposite1 && opposite0 >= opposite2) return;
        const int by = opposite1 >= opposite2 ? 1 : 2;
        std::rotate(corners.begin(), corners.begin() + by, corners.end());
        std::rotate(weights.begin(), weights.begin() + by, weights.end());
    }
    [[nodiscard]] Vec3 middle() const { return (corners[1] + corners[2]) * 0.5F; }
    /// To the half on the second corner's side, or to that on the third's.
    void goTo(bool third) { corners[third ? 1 : 2] = middle(); }
};

std::array<Vec3, 3> cornersOf(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

double areaOf(const std::array<Vec3, 3>& p) { return Vec3d(p[1] - p[0]).cross(Vec3d(p[2] - p[0])).length() / 2; }

bool isMatte(const Material& m) { return m.kind == MaterialKind::Matte && !m.reflectance.isBlack(); }

bool canBeMatte(const Scene& scene, const Material& m) {
    return m.kind == MaterialKind::Mix ? isMatte(scene.materials[m.mixFirst]) || isMatte(scene.materials[m.mixSecond]) : isMatte(m);
}

/// The area of a piece so that there are about as many as wanted.
double pieceArea(std::span<const double> areasM2, double wanted, double most) {
    double total = 0;
    for (const double a : areasM2) total += a;
    double low = std::log(total * 1e-12), high = std::log(total);
    for (int i = 0; i < kBisections; ++i) {
        const double middle = (low + high) / 2, piece = std::exp(middle);
        double count = 0;
        for (const double a : areasM2) count += std::min(a / piece, most);
        (count > wanted ? low : high) = middle;
    }
    return std::exp(high);
}

/// Equal for triangles that are joined: of one mesh, one cell, one way to face.
std::uint64_t cellKey(std::uint32_t mesh, const std::array<Vec3, 3>& p, double cellM) {
    const Vec3d centre = Vec3d(p[0] + p[1] + p[2]) / (3 * cellM);
    std::uint64_t key = streamSeed(mesh, static_cast<std::uint64_t>(octahedralTexel(cross(p[1] - p[0], p[2] - p[0]), kFacingSide)));
    for (const double x : {centre.x, centre.y, centre.z}) key = streamSeed(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x))));
    return key;
}

}  // namespace

SurfaceElements::SurfaceElements(const Scene& scene, const SceneNeeds& needs, std::size_t wanted)
    : scene_(&scene), needs_(&needs), firstCut_(scene.meshes.size(), kNone) {
    std::vector<double> areas;
    for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
        const auto& mesh = scene.meshes[m];
        if (!canBeMatte(scene, scene.materials[mesh.material])) continue;
        firstCut_[m] = static_cast<std::uint32_t>(areas.size());
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            areas.push_back(areaOf(cornersOf(mesh, t)));
            triangles_.push_back({m, t});
        }
    }
    cuts_.resize(areas.size());
    if (!areas.empty()) {
        const double most = std::max(1.0, kMostOfOne * static_cast<double>(wanted));
        const double piece = pieceArea(areas, static_cast<double>(wanted), most);
        cutLarge(areas, piece, most);
        joinSmall(areas, piece);
    }
    firstMember_.push_back(static_cast<std::uint32_t>(members_.size()));
}

void SurfaceElements::cutLarge(std::span<const double> areas, double piece, double most) {
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (areas[i] < kMuchSmaller * piece) continue;
        const double depth = std::clamp(std::round(std::log2(std::min(areas[i] / piece, most))), 0.0, kDeepest);
        cuts_[i] = {static_cast<std::uint32_t>(areasM2_.size()), static_cast<std::uint32_t>(depth)};
        const double own = areas[i] / std::exp2(depth);
        for (std::uint32_t part = 0; part < 1U << cuts_[i].depth; ++part) {
            firstMember_.push_back(static_cast<std::uint32_t>(members_.size()));
            members_.push_back({triangles_[i][0], triangles_[i][1], static_cast<float>(own)});
            addPiece(own);
        }
    }
}

void SurfaceElements::joinSmall(std::span<const double> areas, double piece) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> small;
    for (std::uint32_t i = 0; i < areas.size(); ++i)
        if (cuts_[i].first == kNone)
            small.emplace_back(cellKey(triangles_[i][0], cornersOf(scene_->meshes[triangles_[i][0]], triangles_[i][1]), std::sqrt(piece)), i);
    std::sort(small.begin(), small.end());
    for (std::size_t i = 0; i < small.size();) {
        double own = 0;
        firstMember_.push_back(static_cast<std::uint32_t>(members_.size()));
        const auto key = small[i].first;
        for (; i < small.size() && small[i].first == key; ++i) {
            const auto triangle = small[i].second;
            cuts_[triangle].first = static_cast<std::uint32_t>(areasM2_.size());
            members_.push_back({triangles_[triangle][0], triangles_[triangle][1], static_cast<float>(own += areas[triangle])});
        }
        addPiece(own);
    }
}

std::uint32_t SurfaceElements::at(std::uint32_t mesh, std::uint32_t triangle, float u, float v, bool front) const {
    if (firstCut_[mesh] == kNone) return kNone;
    const auto& cut = cuts_[firstCut_[mesh] + triangle];
    std::uint32_t place = 0;
    if (cut.depth > 0) {
        Part part{cornersOf(scene_->meshes[mesh], triangle), {1 - u - v, u, v}};
        for (std::uint32_t i = 0; i < cut.depth; ++i) {
            part.turn();
            auto& w = part.weights;
            const bool third = w[2] > w[1];
            if (third) w = {w[0], 2 * w[1], w[2] - w[1]};
            else w = {w[0], w[1] - w[2], 2 * w[2]};
            part.goTo(third);
            place = 2 * place + (third ? 1U : 0U);
        }
    }
    return 2 * (cut.first + place) + (front ? 0U : 1U);
}

SurfacePoint SurfaceElements::place(std::size_t element, Vec2 u) const {
    const std::size_t piece = element / 2;
    const auto begin = members_.begin() + firstMember_[piece], end = members_.begin() + firstMember_[piece + 1];
    const float wanted = u.x * std::prev(end)->upToM2;
    const auto found = std::min(std::upper_bound(begin, end, wanted, [](float area, const Member& m) { return area < m.upToM2; }), std::prev(end));
    const float below = found == begin ? 0.0F : std::prev(found)->upToM2;
    const float rest = std::clamp((wanted - below) / std::max(found->upToM2 - below, 1e-37F), 0.0F, 1.0F);

    const auto& mesh = scene_->meshes[found->mesh];
    const auto whole = cornersOf(mesh, found->triangle);
    const auto& cut = cuts_[firstCut_[found->mesh] + found->triangle];
    // The halves are followed by their corners' weights in the whole triangle, where the longest edge is found by position.
    Part part{whole, {0, 1, 2}};
    std::array<Vec2, 3> uv{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    for (std::uint32_t i = cut.depth; i > 0; --i) {
        part.weights = {0, 1, 2};
        part.turn();
        std::rotate(uv.begin(), uv.begin() + static_cast<int>(part.weights[0]), uv.end());
        const bool third = (((piece - cut.first) >> (i - 1)) & 1U) != 0;
        part.goTo(third);
        uv[third ? 1 : 2] = (uv[1] + uv[2]) * 0.5F;
    }
    const float root = std::sqrt(rest);
    const Vec2 inside = uv[0] * (1 - root) + uv[1] * (root * (1 - u.y)) + uv[2] * (root * u.y);
    const Vec2 at = inside * (1 - kBorder) + (uv[0] + uv[1] + uv[2]) * (kBorder / 3);
    Hit hit;
    hit.distance = 1, hit.mesh = found->mesh, hit.triangle = found->triangle, hit.u = at.x, hit.v = at.y;
    const Vec3 normal = cross(whole[1] - whole[0], whole[2] - whole[0]).normalized();
    return surfacePoint(*scene_, *needs_, {{0, 0, 0}, 0, element % 2 == 0 ? -normal : normal, kInfinity}, hit);
}

std::size_t SurfaceElements::bytes() const {
    return cuts_.size() * (sizeof(Cut) + sizeof(triangles_[0])) + areasM2_.size() * (sizeof(float) + sizeof(std::uint32_t)) +
           members_.size() * sizeof(Member);
}

}  // namespace luxdeck

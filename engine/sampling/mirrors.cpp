#include "engine/sampling/mirrors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace luxdeck {

namespace {

/// More planes than this and the smallest are left to chance: every one costs a look at all lights.
constexpr std::size_t kMostMirrors = 32;

/// Triangles whose planes differ by less are one plane [rad, and m per m of the scene].
constexpr double kSamePlane = 1e-4;

bool mirrors(const Material& m) {
    return (m.kind == MaterialKind::ThinGlass || m.kind == MaterialKind::Mirror) && m.reflectancePattern < 0 && !m.hasHoles();
}

/// At normal incidence, for choosing alone.
float reflectanceOf(const Material& m) {
    if (m.kind == MaterialKind::Mirror) return luminance(m.specular);
    const float r = (m.ior - 1) / (m.ior + 1);
    return 2 * r * r;
}

/// Interpolated normals, where there are any, are the triangle's own.
bool isFlat(const Mesh& mesh, std::uint32_t triangle, const Vec3& normal) {
    if (mesh.normals.empty()) return true;
    return std::ranges::all_of(mesh.triangles[triangle], [&](auto v) { return std::abs(dot(mesh.normals[v], normal)) > 1 - 1e-6F; });
}

struct Found {
    FlatMirror mirror;
    std::vector<Vec3> corners;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> triangles;  // mesh, triangle
};

/// A plane's key: rounded, so that triangles of one plane meet in one place or in few.
using Key = std::tuple<std::uint32_t, long, long, long, long>;

MirrorFrame frameAbout(const Vec3& normal, const std::vector<Vec3>& corners) {
    MirrorFrame out;
    const auto frame = Frame::about(normal);
    Box3 box;
    for (const auto& c : corners) box.extendBy(frame.toLocal(c));
    const Vec3 middle = box.center(), half = box.size() * 0.5F;
    out.centre = frame.toWorld(middle);
    out.u = frame.tangent, out.v = frame.bitangent;
    out.halfU = half.x, out.halfV = half.y;
    return out;
}

/// A normal and its opposite are one plane's: the one of them that points up the first axis that it leans to.
Vec3d canonical(const Vec3d& n) {
    for (const double lean : {n.x, n.y, n.z})
        if (std::abs(lean) > 1e-9) return lean < 0 ? -n : n;
    return n;
}

/// The planes of all mirrors and panes, most important first.
std::vector<Found> flatMirrors(const Scene& scene) {
    const Vec3 size = scene.bounds().size();
    const double grain = kSamePlane * std::max({1.0F, size.x, size.y, size.z});
    const auto rounded = [](double x, double step) { return std::lround(x / step); };
    std::map<Key, Found> found;
    for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
        const auto& mesh = scene.meshes[m];
        const auto& material = scene.materials[mesh.material];
        if (!mirrors(material)) continue;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const Vec3d pa(mesh.positions[a]), pb(mesh.positions[b]), pc(mesh.positions[c]);
            const Vec3d cross = (pb - pa).cross(pc - pa);
            if (!(cross.length() > 0) || !isFlat(mesh, t, Vec3(cross.normalized()))) continue;
            const Vec3d n = canonical(cross.normalized());
            const double offset = n.dot(pa);
            auto& f = found[{mesh.material, rounded(n.x, kSamePlane * 10), rounded(n.y, kSamePlane * 10), rounded(n.z, kSamePlane * 10),
                             rounded(offset, grain)}];
            if (f.triangles.empty()) f.mirror.normal = Vec3(n), f.mirror.offset = static_cast<float>(offset);
            f.mirror.importance += static_cast<float>(0.5 * cross.length()) * reflectanceOf(material);
            f.triangles.emplace_back(m, t);
            for (const auto v : {a, b, c}) f.corners.push_back(mesh.positions[v]);
        }
    }
    std::vector<Found> all;
    for (auto& [key, f] : found)
        if (f.mirror.importance > 0) all.push_back(std::move(f));
    std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.mirror.importance > b.mirror.importance; });
    return all;
}

}  // namespace

Mirrors::Mirrors(const Scene& scene, const SceneNeeds& needs) {
    if (!needs.specularChains) return;
    auto all = flatMirrors(scene);
    if (all.size() > kMostMirrors) all.resize(kMostMirrors);
    ofTriangle_.resize(scene.meshes.size());
    float sum = 0;
    for (auto& f : all) {
        f.mirror.frame = frameAbout(f.mirror.normal, f.corners);
        for (const auto& [m, t] : f.triangles) {
            auto& row = ofTriangle_[m];
            if (row.empty()) row.assign(scene.meshes[m].triangles.size(), kNoMirror);
            row[t] = static_cast<std::uint32_t>(mirrors_.size());
        }
        mirrors_.push_back(f.mirror);
        sums_.push_back(sum += f.mirror.importance);
    }
}

Mirrors::Choice Mirrors::choose(float u) const {
    const float wanted = u * sums_.back();
    auto at = static_cast<std::size_t>(std::upper_bound(sums_.begin(), sums_.end(), wanted) - sums_.begin());
    at = std::min(at, mirrors_.size() - 1);
    return {static_cast<std::uint32_t>(at), mirrors_[at].importance / sums_.back()};
}

}  // namespace luxdeck

#include "engine/io/rad_texture.h"

#include "engine/io/pattern_radiance.h"
#include "engine/io/xform.h"

#include <cmath>
#include <filesystem>
#include <span>
#include <string>

namespace luxdeck::rad {

namespace {

/// The number of coefficients of each component of the normal: tmesh.cal is linear in the two coordinates across
/// its axis, surf.cal bilinear. 0: neither.
std::size_t coefficients(const Primitive& texture) {
    if (texture.type != "texfunc" || texture.strings.size() < 4) return 0;
    const auto file = std::filesystem::path(texture.strings[3]).filename().string();
    if (file == "tmesh.cal" && texture.numbers.size() == 10) return 3;
    if (file == "surf.cal" && texture.numbers.size() == 13) return 4;
    return 0;
}

}  // namespace

std::optional<std::vector<Vec3d>> smoothedNormals(const Primitive& texture, const std::vector<Vec3d>& points, const Vec3d& normal) {
    const auto count = coefficients(texture);
    if (count == 0) return std::nullopt;
    std::size_t used = 0;
    const auto first = firstTransformArgument(3, texture.strings);
    const auto xform = parseXform(std::span(texture.strings).subspan(first), used);
    const double axis = texture.numbers[0];
    if (!xform || !(axis == 0 || axis == 1 || axis == 2)) return std::nullopt;
    const int u = (static_cast<int>(axis) + 1) % 3, v = (static_cast<int>(axis) + 2) % 3;
    const Matrix4d back = xform->matrix.inverse();
    std::vector<Vec3d> normals;
    for (const auto& point : points) {
        const Vec3d p = point * back;
        Vec3d local(0, 0, 0);
        for (int i = 0; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(i);
            // tmesh.cal has three numbers for each component, surf.cal three components for each of uv, u, v and 1.
            const auto* a = &texture.numbers[1];
            local[i] = count == 3 ? a[3 * at] * p[u] + a[3 * at + 1] * p[v] + a[3 * at + 2]
                                  : a[at] * p[u] * p[v] + a[3 + at] * p[u] + a[6 + at] * p[v] + a[9 + at];
        }
        Vec3d turned = xform->vector(local) / xform->scale;
        if (count == 4) turned += normal;  // what surf.cal gives is the difference
        const double length = turned.length();
        // Turned away from the surface it would hide it from the light that meets it.
        if (!(length > 1e-6) || !(turned.dot(normal) > 0)) return std::nullopt;
        normals.push_back(turned / length);
    }
    return normals;
}

}  // namespace luxdeck::rad

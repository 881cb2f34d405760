#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/io/warning_list.h"
#include "engine/scene/scene.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace luxdeck::obj {

/// The colours that vertices bring along (`v x y z r g b`), as reflectances of faces: each face has the mean of its
/// corners, in a picture of one texel for each colour.
class VertexColours {
public:
    /// A vertex's colour; `count` vertices had none before the first.
    void add(std::size_t vertex, const Vec3& colour);
    [[nodiscard]] bool any() const { return !colours_.empty(); }
    [[nodiscard]] bool has(std::size_t vertex) const { return vertex < known_.size() && known_[vertex]; }
    /// A number that stands for the colour of a face with these vertices, all of which have one.
    std::uint32_t face(const std::vector<std::uint32_t>& vertices);

    /// Makes the picture and the material that uses it; what is out of range is told.
    ///
    /// name  of the material; empty: "vertex colours"
    std::uint32_t addMaterial(Scene& scene, const std::string& name);
    /// Texture coordinates of a face's colour. After finish().
    [[nodiscard]] Vec2 uv(std::uint32_t face) const;
    /// Fills in the picture and the materials made by addMaterial().
    ///
    /// mayCountTo255  what goes beyond 1 does so; else it is out of range
    void finish(Scene& scene, WarningList& warnings, bool mayCountTo255 = true);

private:
    std::vector<Vec3> colours_;   // by vertex, as the file gives them
    std::vector<bool> known_;
    std::map<std::array<float, 3>, std::uint32_t> numbers_;
    std::vector<Vec3> faces_;     // by number
    std::vector<std::uint32_t> texels_;  // by number
    std::uint32_t width_ = 1, height_ = 1;
    std::int32_t texture_ = -1;
    std::vector<std::uint32_t> materials_;
};

}  // namespace luxdeck::obj

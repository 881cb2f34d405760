#include "engine/io/rad_generators.h"

#include "engine/core/vec.h"
#include "engine/io/rad_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace luxdeck::rad {

namespace {

constexpr double kMostCorners = 100'000;

/// A box as genbox numbers its corners: bit 0 of the index is x, bit 1 y, bit 2 z.
struct BoxShape {
    Vec3d size{0, 0, 0};
    double inset = 0;  ///< of faces from the edges: the bevel's or the rounding's size

    /// The point of corner i that belongs to a face across `axis`: inset along the two others.
    [[nodiscard]] Vec3d onFace(int corner, int axis) const {
        Vec3d p(0, 0, 0);
        for (int i = 0; i < 3; ++i) {
            const bool high = (corner >> i & 1) != 0;
            const double in = i == axis ? 0 : inset;
            p[i] = high ? size[i] - in : in;
        }
        return p;
    }
    [[nodiscard]] Vec3d inner(int corner) const { return onFace(corner, 3); }
};

struct Face {
    std::array<int, 4> corners;
    int axis;
};
constexpr std::array<Face, 6> kFaces = {{{{1, 5, 4, 0}, 1}, {{4, 6, 2, 0}, 0}, {{2, 3, 1, 0}, 2},
                                         {{3, 2, 6, 7}, 1}, {{5, 1, 3, 7}, 0}, {{6, 4, 5, 7}, 2}}};

std::string faceName(const Face& f) { return fmt::format("{}{}{}{}", f.corners[0], f.corners[1], f.corners[2], f.corners[3]); }

/// Turns the corners about when they do not run counter-clockwise as seen from where `outward` points to.
void orient(std::vector<Vec3d>& corners, const Vec3d& outward) {
    const Vec3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.dot(outward) < 0) std::reverse(corners.begin(), corners.end());
}

/// The strips along the twelve edges and the triangles at the eight corners of a bevelled box.
void addBevels(Made& out, const BoxShape& box) {
    const Vec3d middle = box.size * 0.5;
    const auto add = [&](const std::string& name, std::vector<Vec3d> corners) {
        Vec3d centre(0, 0, 0);
        for (const auto& c : corners) centre += c / static_cast<double>(corners.size());
        orient(corners, centre - middle);
        out.polygon(name, corners);
    };
    for (int a = 0; a < 8; ++a)
        for (int axis = 0; axis < 3; ++axis) {
            const int b = a | 1 << axis;
            if (b == a) continue;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            add(fmt::format("{}{}", a, b), {box.onFace(a, u), box.onFace(b, u), box.onFace(b, v), box.onFace(a, v)});
        }
    for (int c = 0; c < 8; ++c) add(std::to_string(c), {box.onFace(c, 0), box.onFace(c, 1), box.onFace(c, 2)});
}

void addRounding(Made& out, const BoxShape& box) {
    for (int a = 0; a < 8; ++a)
        for (int axis = 0; axis < 3; ++axis)
            if (const int b = a | 1 << axis; b != a) out.cylinder(fmt::format("{}{}", a, b), box.inner(a), box.inner(b), box.inset);
    for (int c = 0; c < 8; ++c) out.sphere(std::to_string(c), box.inner(c), box.inset);
}

/// A prism as genprism has it: corners of the plane z = 0 and the way they are moved.
struct PrismShape {
    std::vector<Vec3d> corners;
    Vec3d length{0, 0, 1};
    bool ends = true;      ///< not -e
    bool complete = false; ///< -c: no side from the last corner to the first
    double radius = 0;
};

Result<PrismShape> readPrism(Arguments& arguments) {
    PrismShape prism;
    const auto count = arguments.number("the number of corners: corners in a file are not read");
    if (!count) return count.error();
    if (!(*count >= 3 && *count <= kMostCorners && *count == std::floor(*count)))
        return arguments.wrong(fmt::format("has {} corners, expected a whole number from 3 to {}", *count, kMostCorners));
    for (int i = 0; i < static_cast<int>(*count); ++i) {
        const auto xy = arguments.numbers(2, fmt::format("x and y of corner {} of {}", i + 1, *count));
        if (!xy) return xy.error();
        prism.corners.emplace_back((*xy)[0], (*xy)[1], 0);
    }
    while (!arguments.atEnd()) {
        const auto option = *arguments.word("");
        if (option == "-e") prism.ends = !prism.ends;
        else if (option == "-c") prism.complete = !prism.complete;
        else if (option == "-l") {
            const auto v = arguments.numbers(3, "x, y and z of -l");
            if (!v) return v.error();
            prism.length = {(*v)[0], (*v)[1], (*v)[2]};
        } else if (option == "-r") {
            const auto radius = arguments.number("the radius of -r");
            if (!radius) return radius.error();
            prism.radius = *radius;
        } else {
            return arguments.wrong(fmt::format("has '{}', expected -l -r -c -e", option));
        }
    }
    if (!(prism.length.length() > 0)) return arguments.wrong("has -l 0 0 0, expected a length");
    if (prism.radius != 0) return Error{ErrorCode::Unsupported, arguments.wrong("has -r: rounded prisms are not made; expected none").message, arguments.wrong("").where};
    return prism;
}

}  // namespace

Result<Primitives> genbox(std::span<const std::string> words, const Place& place) {
    Arguments arguments("genbox", words, place);
    const auto material = arguments.word("a material");
    const auto name = material ? arguments.word("a name") : material;
    if (!name) return name.error();
    const auto size = arguments.numbers(3, "the size in x, y and z");
    if (!size) return size.error();
    BoxShape box{{(*size)[0], (*size)[1], (*size)[2]}};
    bool inwards = false, round = false;
    while (!arguments.atEnd()) {
        const auto option = *arguments.word("");
        if (option == "-i") {
            inwards = true;
            continue;
        }
        if (option != "-b" && option != "-r" && option != "-n") return arguments.wrong(fmt::format("has '{}', expected -i -b -r -n", option));
        const auto value = arguments.number("a number after " + option);
        if (!value) return value.error();
        if (option == "-n") continue;  // into how many pieces a rounded edge is cut: ours stays round
        round = option == "-r";
        box.inset = *value;
    }
    const double smallest = std::min({box.size.x, box.size.y, box.size.z});
    if (!(smallest > 0)) return arguments.wrong(fmt::format("has a side of {}, expected more than 0", smallest));
    if (!(box.inset >= 0 && 2 * box.inset < smallest)) return arguments.wrong(fmt::format("has -b or -r {}, expected 0 to half of the smallest side, {}", box.inset, smallest / 2));
    if (inwards && box.inset > 0) return arguments.wrong("has -i with -b or -r, expected one of them");
    Made out(*material, *name, place);
    for (const auto& face : kFaces) {
        std::vector<Vec3d> corners;
        for (const int c : face.corners) corners.push_back(box.onFace(c, face.axis));
        if (inwards) std::reverse(corners.begin(), corners.end());
        out.polygon(faceName(face), corners);
    }
    if (box.inset > 0) round ? addRounding(out, box) : addBevels(out, box);
    return out.take();
}

Result<Primitives> genprism(std::span<const std::string> words, const Place& place) {
    Arguments arguments("genprism", words, place);
    const auto material = arguments.word("a material");
    const auto name = material ? arguments.word("a name") : material;
    if (!name) return name.error();
    const auto prism = readPrism(arguments);
    if (!prism) return prism.error();
    Made out(*material, *name, place);
    const auto& c = prism->corners;
    if (prism->ends) {
        out.polygon("b", c);
        std::vector<Vec3d> top;
        for (auto i = c.rbegin(); i != c.rend(); ++i) top.push_back(*i + prism->length);
        out.polygon("t", top);
    }
    for (std::size_t i = 0; i < c.size() - (prism->complete ? 1 : 0); ++i) {
        const auto& next = c[(i + 1) % c.size()];
        out.polygon(std::to_string(i + 1), {c[i], c[i] + prism->length, next + prism->length, next});
    }
    return out.take();
}

}  // namespace luxdeck::rad

#include "engine/io/rad_curves.h"

#include "engine/core/vec.h"
#include "engine/io/cal_program.h"
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

constexpr double kMostSegments = 1'000'000;  // of gensurf: in both directions together
constexpr double kTiny = 1e-9;               // genrev's: below it a step stands still

/// A generator's functions, material, name and options, read.
struct Curve {
    Arguments arguments;
    CurveContext context;
    std::string material, name;
    CalProgram program{};
    std::vector<std::string> functions{};  ///< by the names that they are defined under
    bool smooth = false;

    Result<double> value(std::size_t function, std::span<const double> at) {
        auto result = program.evaluate(functions[function], at);
        if (!result) return context.place.error(result.error().code, result.error().text());
        if (!std::isfinite(*result)) return arguments.wrong(fmt::format("has a function without a value at {}", at[0]));
        return result;
    }
};

Result<int> readSegments(Arguments& arguments, double most) {
    const auto count = arguments.number("a number of segments");
    if (!count) return count.error();
    if (!(*count >= 1 && *count <= most && *count == std::floor(*count)))
        return arguments.wrong(fmt::format("has {} segments, expected a whole number from 1 to {}", *count, most));
    return static_cast<int>(*count);
}

/// -s, -e and -f up to the end.
Result<void> readOptions(Curve& curve) {
    auto& in = curve.arguments;
    const auto where = curve.context.place.text();
    while (!in.atEnd()) {
        const auto option = *in.word("");
        if (option == "-s") {
            curve.smooth = true;
            continue;
        }
        if (option != "-e" && option != "-f") return in.wrong(fmt::format("has '{}', expected -s -e -f", option));
        const auto text = in.word(option == "-e" ? "definitions after -e" : "a file after -f");
        if (!text) return text.error();
        const auto added = option == "-e" ? curve.program.addText(*text, where)
                                          : curve.program.addFile(*text, curve.context.folder, curve.context.library);
        if (!added) return curve.context.place.error(added.error().code, added.error().text());
    }
    return {};
}

struct CurveText {
    std::vector<std::string> expressions;
    std::vector<int> segments;
};

/// material name, the functions of `parameters`, the numbers of segments, options.
Result<CurveText> readCurve(Curve& curve, std::size_t functions, std::size_t counts, const std::vector<std::string>& parameters) {
    auto& in = curve.arguments;
    CurveText text;
    for (auto* out : {&curve.material, &curve.name}) {
        auto word = in.word("a material and a name");
        if (!word) return word.error();
        *out = *std::move(word);
    }
    for (std::size_t i = 0; i < functions; ++i) {
        auto word = in.word(fmt::format("{} functions", functions));
        if (!word) return word.error();
        text.expressions.push_back(*std::move(word));
    }
    double most = kMostSegments;
    for (std::size_t i = 0; i < counts; ++i) {
        const auto segments = readSegments(in, most);
        if (!segments) return segments.error();
        text.segments.push_back(*segments);
        most = std::floor(most / *segments);
    }
    if (auto read = readOptions(curve); !read) return read.error();
    for (std::size_t i = 0; i < functions; ++i) {
        curve.functions.push_back(fmt::format("luxdeck_curve_{}", i));
        if (auto defined = curve.program.define(curve.functions.back(), parameters, text.expressions[i], curve.context.place.text()); !defined)
            return curve.context.place.error(defined.error().code, defined.error().text());
    }
    return text;
}

/// A vertex of gensurf.
struct Vertex {
    bool valid = false;
    Vec3d position{0, 0, 0};
    Vec3d normal{0, 0, 0};  ///< zero: not known
};

/// The vertices of gensurf, with one row and column more on each side: smoothing looks there.
class SurfaceGrid {
public:
    SurfaceGrid(int m, int n) : m_(m), n_(n), vertices_(static_cast<std::size_t>(m + 3) * static_cast<std::size_t>(n + 3)) {}

    Vertex& at(int i, int j) { return vertices_[static_cast<std::size_t>(i + 1) * static_cast<std::size_t>(n_ + 3) + static_cast<std::size_t>(j + 1)]; }

    Result<void> evaluate(Curve& curve) {
        const int border = curve.smooth ? 1 : 0;
        const bool conditional = curve.program.defines("valid");
        for (int i = -border; i <= m_ + border; ++i)
            for (int j = -border; j <= n_ + border; ++j) {
                const std::array<double, 2> st = {static_cast<double>(i) / m_, static_cast<double>(j) / n_};
                if (conditional) {
                    const auto valid = curve.program.evaluate("valid", st);
                    if (!valid) return curve.context.place.error(valid.error().code, valid.error().text());
                    if (!(*valid > 0)) continue;
                }
                auto& vertex = at(i, j);
                for (int axis = 0; axis < 3; ++axis) {
                    const auto x = curve.value(static_cast<std::size_t>(axis), st);
                    if (!x) return x.error();
                    vertex.position[axis] = *x;
                }
                vertex.valid = true;
            }
        return {};
    }

    /// Normals of the vertices from their neighbours in both directions: the cross of d/ds and d/dt.
    void smooth() {
        for (int i = 0; i <= m_; ++i)
            for (int j = 0; j <= n_; ++j)
                if (at(i, j).valid) {
                    const auto along = difference(at(i - 1, j), at(i, j), at(i + 1, j));
                    const auto across = difference(at(i, j - 1), at(i, j), at(i, j + 1));
                    at(i, j).normal = along.cross(across).normalized();
                }
    }

private:
    static Vec3d difference(const Vertex& before, const Vertex& here, const Vertex& after) {
        return (after.valid ? after : here).position - (before.valid ? before : here).position;
    }

    int m_, n_;
    std::vector<Vertex> vertices_;
};

/// A triangle or quadrilateral of gensurf; those with an invalid vertex or without area are passed over.
bool addFace(Made& out, std::span<const Vertex* const> corners) {
    std::vector<Vec3d> positions, normals;
    for (const auto* v : corners) {
        if (!v->valid) return false;
        positions.push_back(v->position);
        if (v->normal.length() > 0) normals.push_back(v->normal);
    }
    if (!((positions[1] - positions[0]).cross(positions[2] - positions[0]).length() > 0)) return false;
    if (normals.size() != positions.size()) normals.clear();
    out.polygon(std::to_string(out.count() + 1), positions, std::move(normals));
    return true;
}

/// The corners of a cell: a and d face each other, as b and c do; the cut goes from b to c.
void addCell(Made& out, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
    if (a.valid && b.valid && c.valid && d.valid) {
        const Vec3d first = (b.position - a.position).cross(c.position - a.position).normalized();
        const Vec3d second = (c.position - d.position).cross(b.position - d.position).normalized();
        if (first.length() > 0 && second.length() > 0 && first.dot(second) >= 1 - 1e-12) {
            addFace(out, std::array{&a, &b, &d, &c});
            return;
        }
    }
    addFace(out, std::array{&a, &b, &c});
    addFace(out, std::array{&c, &b, &d});
}

}  // namespace

Result<Primitives> gensurf(std::span<const std::string> words, const CurveContext& context) {
    Curve curve{Arguments("gensurf", words, context.place), context, {}, {}};
    const auto text = readCurve(curve, 3, 2, {"s", "t"});
    if (!text) return text.error();
    const int m = text->segments[0], n = text->segments[1];
    SurfaceGrid grid(m, n);
    if (auto evaluated = grid.evaluate(curve); !evaluated) return evaluated.error();
    if (curve.smooth) grid.smooth();
    Made out(curve.material, curve.name, context.place);
    for (int i = 0; i < m; ++i)
        for (int j = 0; j < n; ++j) {
            const auto &v00 = grid.at(i, j), &v10 = grid.at(i + 1, j), &v01 = grid.at(i, j + 1), &v11 = grid.at(i + 1, j + 1);
            bool odd = j % 2 != 0;
            if (!(v00.valid && v11.valid)) odd = true;
            else if (!(v10.valid && v01.valid)) odd = false;
            if (odd) addCell(out, v00, v10, v01, v11);
            else addCell(out, v10, v11, v00, v01);
        }
    return out.take();
}

Result<Primitives> genrev(std::span<const std::string> words, const CurveContext& context) {
    Curve curve{Arguments("genrev", words, context.place), context, {}, {}};
    const auto text = readCurve(curve, 2, 1, {"t"});
    if (!text) return text.error();
    Made out(curve.material, curve.name, context.place);
    double lastZ = 0, lastR = 0;
    for (int i = 0; i <= text->segments[0]; ++i) {
        const std::array<double, 1> t = {static_cast<double>(i) / text->segments[0]};
        const auto z = curve.value(0, t), r = curve.value(1, t);
        if (!z) return z.error();
        if (!r) return r.error();
        const bool rises = *z > lastZ + kTiny, falls = *z < lastZ - kTiny;
        const bool widens = *r > lastR + kTiny, narrows = *r < lastR - kTiny;
        const auto suffix = std::to_string(i);
        if (i == 0) {
        } else if ((rises || falls) && (widens || narrows)) {
            out.round(falls ? "cup" : "cone", suffix, {0, 0, lastZ, 0, 0, *z, lastR, *r});
        } else if (rises || falls) {
            out.round(falls ? "tube" : "cylinder", suffix, {0, 0, lastZ, 0, 0, *z, *r});
        } else if (widens || narrows) {
            out.round("ring", suffix, {0, 0, *z, 0, 0, narrows ? 1.0 : -1.0, lastR, *r});
        }
        lastZ = *z, lastR = *r;
    }
    return out.take();
}

Result<Primitives> genworm(std::span<const std::string> words, const CurveContext& context) {
    Curve curve{Arguments("genworm", words, context.place), context, {}, {}};
    const auto text = readCurve(curve, 4, 1, {"t"});
    if (!text) return text.error();
    Made out(curve.material, curve.name, context.place);
    Vec3d last(0, 0, 0);
    double lastRadius = 0;
    for (int i = 0; i <= text->segments[0]; ++i) {
        const std::array<double, 1> t = {static_cast<double>(i) / text->segments[0]};
        std::array<double, 4> v{};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto x = curve.value(k, t);
            if (!x) return x.error();
            v[k] = *x;
        }
        const Vec3d p(v[0], v[1], v[2]);
        const double radius = v[3];
        if (!(radius >= 0)) return curve.arguments.wrong(fmt::format("has the radius {}, expected 0 or more", radius));
        const Vec3d step = p - last;
        if (i > 0 && std::abs(radius - lastRadius) <= kTiny) {
            out.cylinder(fmt::format("c{}", i), last, p, radius);
        } else if (i > 0 && step.length() > std::abs(radius - lastRadius)) {
            // The cone that touches both spheres: its rims lie on them, towards the smaller one.
            const double slope = (lastRadius - radius) / step.length2();
            const Vec3d a = last + step * (slope * lastRadius), b = p + step * (slope * radius);
            const double shrink = std::sqrt(std::max(0.0, 1 - (lastRadius - radius) * slope));
            out.round("cone", fmt::format("c{}", i), {a.x, a.y, a.z, b.x, b.y, b.z, shrink * lastRadius, shrink * radius});
        }
        if (radius > 0) out.sphere(fmt::format("s{}", i), p, radius);
        last = p, lastRadius = radius;
    }
    return out.take();
}

}  // namespace luxdeck::rad

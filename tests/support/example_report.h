#pragma once

#include "analysis/report/report_contents.h"
#include "engine/core/rng.h"
#include "tonemap/colour_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

/// A made-up but believable report: an office of 9 x 6 x 3 m with twelve luminaires and three surfaces, one of
/// which is met, one not met and one undecided. Its numbers come from point sources and a constant, not from a solve.
namespace luxdeck::example {

inline constexpr double kLength = 9, kDepth = 6, kHeight = 3;

inline std::vector<Vec3d> luminairePositions() {
    std::vector<Vec3d> out;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i) out.push_back({1.125 + 2.25 * i, 1 + 2.0 * j, 2.8});
    return out;
}

/// Direct illuminance of all luminaires, cosine emitters of 1250 cd straight down [lx].
inline double directLux(const Vec3d& p, const Vec3d& n) {
    double sum = 0;
    for (const auto& l : luminairePositions()) {
        const Vec3d d = l - p;
        const double r = d.length();
        sum += 1130 * std::max(d.z / r, 0.0) * std::max(d.dot(n) / r, 0.0) / (r * r);
    }
    return sum;
}

inline JudgedInterval judged(double value, double ci, std::optional<double> required) {
    const auto verdict = !required ? Verdict::None
                         : value - ci >= *required ? Verdict::Met : value + ci < *required ? Verdict::NotMet : Verdict::Undecided;
    return {{value, ci}, required, verdict};
}

/// Fills in a surface's points and statistics.
inline GridResult surface(std::string name, Vec3d origin, Vec3d u, Vec3d v, int columns, int rows, Requirement requirement,
                          double relativeCi = 0.012) {
    GridResult grid;
    grid.name = std::move(name);
    grid.columns = columns;
    grid.rows = rows;
    grid.spacingU = u.length() / columns;
    grid.spacingV = v.length() / rows;
    grid.origin = origin;
    grid.u = u;
    grid.v = v;
    const Vec3d n = u.cross(v).normalized();
    RandomStream noise(columns * 1000 + rows);
    double sum = 0, least = 1e300;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const Vec3d p = origin + u * ((i + 0.5) / columns) + v * ((j + 0.5) / rows);
            const double direct = directLux(p, n), indirect = 96 + 14 * std::sin(p.x) + 8 * p.y / kDepth;
            const double total = (direct + indirect) * (1 + relativeCi / 2 * noise.normal());
            grid.points.push_back({p, n, {total, relativeCi * total}, {direct, 0.004 * direct},
                                   {total - direct, relativeCi * total}, 65536, false});
            sum += total;
            least = std::min(least, total);
            grid.maximumLux = std::max(grid.maximumLux, total);
        }
    const double mean = sum / std::max<std::size_t>(1, grid.points.size());
    grid.mean = judged(mean, mean * relativeCi * 0.35, requirement.meanLux);
    grid.minimum = judged(least, least * relativeCi, requirement.minimumLux);
    grid.uniformity = judged(least / mean, least / mean * relativeCi * 1.2, requirement.uniformity);
    grid.requirements = {std::move(requirement)};
    return grid;
}

inline Requirement requirement(std::string name, double mean, double uniformity) {
    Requirement r;
    r.name = std::move(name);
    r.source = "EN 12464-1:2021, as agreed with the client";
    r.meanLux = mean;
    r.uniformity = uniformity;
    return r;
}

inline std::vector<GridResult> officeGrids() {
    auto desks = surface("Desks by the window", {0.5, 0.5, 0.75}, {8, 0, 0}, {0, 2.2, 0}, 16, 6, requirement("Writing, reading, data processing", 500, 0.6));
    desks.borderM = 0.25;
    auto& mean = desks.mean;  // the limit is set into the interval: undecided by construction
    mean = judged(mean.interval.value, mean.interval.ci95, std::floor(mean.interval.value + 0.3 * mean.interval.ci95));
    auto floor = surface("Whole room, floor", {0.5, 0.5, 0}, {8, 0, 0}, {0, 5, 0}, 13, 8, requirement("Background area", 200, 0.4));
    floor.borderM = 0.5;
    auto board = surface("Whiteboard", {8.99, 4.6, 0.9}, {0, -3.2, 0}, {0, 0, 1.2}, 11, 4, requirement("Presentation board", 500, 0.7), 0.02);
    return {desks, floor, board};
}

inline RoomPlan officePlan() {
    RoomPlan plan;
    plan.cutHeightM = 1.2;
    const auto wall = [&](PlanLine kind, double x0, double y0, double x1, double y1) { plan.segments.push_back({kind, x0, y0, x1, y1}); };
    const auto box = [&](PlanLine kind, double x, double y, double w, double h) {
        wall(kind, x, y, x + w, y), wall(kind, x + w, y, x + w, y + h);
        wall(kind, x + w, y + h, x, y + h), wall(kind, x, y + h, x, y);
    };
    wall(PlanLine::Solid, 0, 0, 0, kDepth), wall(PlanLine::Solid, kLength, 0, kLength, kDepth);
    wall(PlanLine::Solid, 0, kDepth, 6.6, kDepth), wall(PlanLine::Solid, 7.6, kDepth, kLength, kDepth);
    box(PlanLine::Solid, -0.2, -0.2, kLength + 0.4, kDepth + 0.4);
    for (int i = 0; i < 3; ++i) {
        wall(PlanLine::Solid, 3.0 * i, 0, 3.0 * i + 0.4, 0), wall(PlanLine::Solid, 3.0 * i + 2.6, 0, 3.0 * i + 3, 0);
        wall(PlanLine::Glass, 3.0 * i + 0.4, -0.1, 3.0 * i + 2.6, -0.1);
    }
    for (int i = 0; i < 4; ++i) box(PlanLine::Furniture, 0.7 + 2 * i, 0.8, 1.6, 0.8);
    box(PlanLine::Furniture, 2.5, 3.6, 3, 1.2);
    int index = 0;
    for (const auto& p : luminairePositions()) plan.luminaires.push_back({index++ < 8 ? "A" : "B", p, 1.2, 0.12, 0, false});
    return plan;
}

/// Luminance of the empty office, a box seen from a corner and lit as the grids are [cd/m^2], rows from the top.
inline std::vector<double> officeLuminance(int width, int height) {
    std::vector<double> out;
    const Vec3d eye(0.6, 5.5, 1.6), forward = Vec3d(0.8, -0.58, -0.06).normalized(), right = forward.cross(Vec3d(0, 0, 1)).normalized(),
                up = right.cross(forward), size(kLength, kDepth, kHeight);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const Vec3d d = forward + right * ((i + 0.5 - width / 2.0) / width * 1.9) + up * ((height / 2.0 - j - 0.5) / width * 1.9);
            int axis = 0;
            double t = 1e300;
            for (int k = 0; k < 3; ++k)
                if (const double to = ((d[k] > 0 ? size[k] : 0) - eye[k]) / d[k]; d[k] != 0 && to < t) t = to, axis = k;
            const Vec3d p = eye + d * t;
            Vec3d n(0, 0, 0);
            n[axis] = d[axis] > 0 ? -1 : 1;
            double luminance = (directLux(p, n) + 110) * (axis != 2 ? 0.6 : d.z > 0 ? 0.8 : 0.3) / kPiD;
            if (axis == 1 && d.y < 0 && p.z > 0.9 && p.z < 2.5 && std::abs(std::fmod(p.x, 3) - 1.5) < 1.1) luminance = 12;
            for (const auto& l : luminairePositions())
                if (axis == 2 && d.z > 0 && std::abs(p.x - l.x) < 0.6 && std::abs(p.y - l.y) < 0.08) luminance = 9000;
            out.push_back(luminance);
        }
    return out;
}

/// The office through a plain power curve; white: in cd/m^2; blue: of white's, less is warmer.
inline std::string officePicture(int width, int height, double white, double blue) {
    DisplayImage image{width, height, {}, {}};
    for (const double l : officeLuminance(width, height)) {
        const double v = std::pow(std::min(1.0, l / white), 1 / 2.2) * 255;
        for (const double tint : {1.0, (1 + blue) / 2, blue}) image.rgb.push_back(static_cast<std::uint8_t>(v * tint));
    }
    return pngBytes(image).value();
}

/// The office's luminance in false colours, 1 to 10 000 cd/m^2.
inline std::string officeFalseColour(int width, int height) {
    DisplayImage image{width, height, {}, {}};
    for (const double l : officeLuminance(width, height))
        for (const auto channel : tonemap::colourAt(tonemap::ColourMap::Dusk, std::log10(std::max(l, 1.0)) / 4)) image.rgb.push_back(channel);
    return pngBytes(image).value();
}

inline SolveResult officeSolve() {
    SolveResult solve;
    solve.project = "Office Seven";
    solve.grids = officeGrids();
    solve.targetError = 0.01;
    solve.targetReached = true;
    solve.seconds = 42.3;
    solve.setupSeconds = 0.84;
    solve.predictedSeconds = 39;
    solve.samples = 17825792;
    solve.rays = 96123456;
    solve.algorithm = "path";
    solve.seed = 1;
    solve.threads = 2;
    for (int i = 0; i <= 8; ++i) {
        const double t = 42.3 / std::pow(2.0, 8 - i), wobble = 1 + 0.06 * std::sin(4.0 * i);
        solve.trace.push_back({t, 0.0096 * std::sqrt(42.3 / t) * wobble, 0.014 * std::sqrt(42.3 / t), static_cast<std::uint64_t>(17825792 / std::pow(2.0, 8 - i))});
    }
    solve.leftOut = {{"sky", "the project has none: nothing is looked up where there is no surface"},
                     {"textures", "no material uses one"},
                     {"choosing among many luminaires", "12 luminaires: each is weighed at every point"}};
    solve.warnings = {"geometry/office.glb: 2 degenerate triangles of \"Chair 3\" dropped"};
    solve.truncatedFraction = 0.00004;
    solve.sceneHash = "5f0c9d2ab8e17734";
    solve.projectHash = "a31be09c44d21f60";
    solve.version = "0.1.0";
    solve.kernel = "Embree 3.13.5";
    return solve;
}

inline ReportContents office() {
    ReportContents c;
    c.info = {"Office Seven", "Meridian Assurance, Basel", "Studio Halbschatten", "Elisabethenstrasse 7, 4051 Basel", "22 November 2026",
              "Refurbishment of an open-plan office: twelve pendant luminaires, desks along the windows, a presentation wall.",
              {"Reflectances were measured on site on 3 November."}};
    c.created = "2026-11-22T18:40:00Z";
    c.schedule = {{"A", "Linea 120 direct, microprismatic", "Beispiel Leuchten AG", 8, 4300, 31.5, 0.8, 1, 4000, "luminaires/linea-120.ldt", "9b1f22c07d5a43e8"},
                  {"B", "Linea 120 direct, microprismatic", "Beispiel Leuchten AG", 4, 4300, 31.5, 0.8, 0.85, 4000, "luminaires/linea-120.ldt", "9b1f22c07d5a43e8"}};
    c.floorAreaM2 = 54;
    c.floorAreaSource = "level faces of objects named “floor”";
    c.materials = {{"Ceiling", "matte", 0.8, "manufacturer's sheet"}, {"Walls", "matte", 0.6, "measured on site"},
                   {"Carpet", "matte", 0.3, "measured on site"}, {"Window pane", "glass", 0.72, "manufacturer's sheet, double glazing"}};
    c.plan = officePlan();
    c.solve = officeSolve();
    c.views = {{"From the door", "human", "Adaptation of a normal eye: what is visible in the room is visible in the picture.", "world adaptation 118 cd/m²", 12.4, 0.021, officePicture(720, 450, 330, 0.88), {}},
               {"From the door, as a camera sees it", "camera", "One exposure for the whole picture, film curve in the highlights.", "1/30 s at f/5.6, ISO 200", 12.4, 0.021, officePicture(720, 450, 620, 1), {}},
               {"Luminance from the door", "false colour", "Luminance, not passed through any tone curve.", "", 12.4, 0.021, officeFalseColour(720, 450), ColourScale{"cd/m²", 1, 10000, true, "dusk"}}};
    c.methodText = "Light is followed backwards from each point of a calculation surface along random paths until it meets a luminaire. "
                   "The mean over many paths tends to the exact solution of the model; their spread gives the interval.";
    c.facts = {{"Machine", "Example CPU, 2 logical cores"}, {"Operating system", "Linux 6.1.0 x86_64"}, {"Project file", "project.toml"}};
    return c;
}

}  // namespace luxdeck::example

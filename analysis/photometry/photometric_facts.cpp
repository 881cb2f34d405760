#include "analysis/photometry/photometric_facts.h"

#include "engine/core/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// A turn about the nadir-zenith circle of one C plane, in steps fine enough for spots of a degree.
constexpr int kStepsPerDegree = 10;
constexpr int kTurn = 360 * kStepsPerDegree;

std::vector<double> turnOf(const CandelaTable& table, double planeDegrees) {
    std::vector<double> candela(kTurn);
    for (int i = 0; i < kTurn; ++i)
        candela[static_cast<std::size_t>(i)] = intensityAt(table, planeDegrees, static_cast<double>(i) / kStepsPerDegree - 180);
    return candela;
}

/// Steps from `at`, towards `step`, to where the curve falls below `level`; none after a whole turn.
std::optional<double> crossing(const std::vector<double>& turn, int at, int step, double level) {
    const auto value = [&](int i) { return turn[static_cast<std::size_t>(((i % kTurn) + kTurn) % kTurn)]; };
    for (int walked = 0; walked < kTurn; ++walked, at += step) {
        const double here = value(at), next = value(at + step);
        if (here >= level && next < level) return at + step * (here - level) / (here - next);
    }
    return std::nullopt;
}

/// Width of the lobe at `share` of its maximum.
std::optional<double> widthAt(const std::vector<double>& turn, double share) {
    const auto top = std::max_element(turn.begin(), turn.end());
    if (!(*top > 0)) return std::nullopt;
    // The lobe's hemisphere: below the horizontal or above it; index 0 is the zenith, the middle the nadir.
    const int peak = static_cast<int>(top - turn.begin());
    const bool down = peak >= kTurn / 4 && peak <= 3 * kTurn / 4;
    const int first = down ? kTurn / 4 : 3 * kTurn / 4, last = first + kTurn / 2;
    const double level = share * *top;
    const auto value = [&](int i) { return turn[static_cast<std::size_t>(i % kTurn)]; };
    int left = first, right = last;
    while (left < last && value(left) < level) ++left;
    while (right > first && value(right) < level) --right;
    const auto from = crossing(turn, left, -1, level), to = crossing(turn, right, 1, level);
    if (!from || !to || *to - *from >= kTurn) return std::nullopt;
    return (*to - *from) / kStepsPerDegree;
}

LobeWidth lobeOf(const CandelaTable& table, double planeDegrees) {
    const auto turn = turnOf(table, planeDegrees);
    return {widthAt(turn, 0.5), widthAt(turn, 0.1)};
}

/// Gammas at which symmetry is looked at: the file's own where they are gammas, for nothing happens in between.
std::vector<double> gammasOf(const CandelaTable& table) {
    if (table.type() == PhotometryType::C) return table.vertical();
    std::vector<double> gammas;
    for (int i = 0; i <= 180; ++i) gammas.push_back(i);
    return gammas;
}

SymmetryDeviation deviationOf(const CandelaTable& table) {
    constexpr int kPlanes = 72;  // every 5 degrees: what goniometers step at most
    SymmetryDeviation out;
    if (!(table.maxIntensity() > 0)) return out;
    std::vector<double> ring(kPlanes);
    const auto at = [&](int plane) { return ring[static_cast<std::size_t>((plane + kPlanes) % kPlanes)]; };
    for (const double gamma : gammasOf(table)) {
        double mean = 0;
        for (int i = 0; i < kPlanes; ++i) mean += ring[static_cast<std::size_t>(i)] = intensityAt(table, 360.0 / kPlanes * i, gamma);
        mean /= kPlanes;
        for (int i = 0; i < kPlanes; ++i) {
            out.axial = std::max(out.axial, std::abs(at(i) - mean));
            out.about0 = std::max(out.about0, std::abs(at(i) - at(-i)));
            out.about90 = std::max(out.about90, std::abs(at(i) - at(kPlanes / 2 - i)));
        }
    }
    const double peak = table.maxIntensity();
    return {out.axial / peak, out.about0 / peak, out.about90 / peak};
}

PhotometrySymmetry symmetryOf(const SymmetryDeviation& d) {
    const bool about0 = d.about0 <= kSymmetric, about90 = d.about90 <= kSymmetric;
    if (d.axial <= kSymmetric) return PhotometrySymmetry::Axial;
    if (about0 && about90) return PhotometrySymmetry::Quadrant;
    return about0 ? PhotometrySymmetry::Bilateral0to180 : about90 ? PhotometrySymmetry::Bilateral90to270 : PhotometrySymmetry::None;
}

/// The direction of a table's angles, as candela_table.h defines them.
Vec3d directionOf(PhotometryType type, double vertical, double horizontal) {
    const double sv = std::sin(vertical * kDegree), cv = std::cos(vertical * kDegree);
    const double sh = std::sin(horizontal * kDegree), ch = std::cos(horizontal * kDegree);
    switch (type) {
        case PhotometryType::C: return {sv * ch, sv * sh, -cv};
        case PhotometryType::B: return {ch * sv, -sh, -ch * cv};
        case PhotometryType::A: return {sv, -cv * sh, -cv * ch};
    }
    return {0, 0, -1};
}

/// The reader has judged already; it says nothing where the two agree.
std::string fluxJudgement(const Photometry& p, const std::optional<double>& ratio) {
    constexpr std::string_view kMark = "flux: ";
    for (const auto& warning : p.warnings)
        if (warning.starts_with(kMark)) return warning.substr(kMark.size());
    if (!ratio) return "the header states none";
    return fmt::format("agrees with the header to {:.2f} %", 100 * std::abs(*ratio - 1));
}

}  // namespace

double intensityAt(const CandelaTable& table, double planeDegrees, double gammaDegrees) {
    const double g = gammaDegrees * kDegree, c = planeDegrees * kDegree;
    return table.intensity(Vec3(Vec3d(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g))));
}

PeakDirection peakDirection(const CandelaTable& table) {
    const auto& values = table.candela();
    const auto top = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    const auto rows = table.vertical().size();
    const Vec3d d = directionOf(table.type(), table.vertical()[top % rows], table.horizontal()[top / rows]);
    PeakDirection peak{values[top], std::acos(std::clamp(-d.z, -1.0, 1.0)) / kDegree, 0};
    // Half a thousandth from the axis every plane is the same direction.
    if (std::hypot(d.x, d.y) > 5e-4) peak.planeDegrees = std::fmod(std::atan2(d.y, d.x) / kDegree + 360, 360.0);
    if (peak.planeDegrees > 359.9995) peak.planeDegrees = 0;
    return peak;
}

PolarCurve polarCurve(const CandelaTable& table) {
    PolarCurve curve;
    for (int i = -PolarCurve::kStepsPerTurn / 2; i <= PolarCurve::kStepsPerTurn / 2; ++i) {
        curve.c0.push_back(intensityAt(table, 0, i));
        curve.c90.push_back(intensityAt(table, 90, i));
    }
    return curve;
}

PhotometricFacts measure(const Photometry& p) {
    const auto& table = p.table;
    PhotometricFacts facts;
    facts.lumens = table.lumens();
    facts.lumensDown = table.lumensDown();
    facts.lumensUp = std::max(0.0, facts.lumens - facts.lumensDown);
    if (p.lumensDeclared > 0) facts.declaredRatio = facts.lumens / p.lumensDeclared;
    facts.fluxJudgement = fluxJudgement(p, facts.declaredRatio);
    if (!table.candela().empty()) facts.peak = peakDirection(table);
    facts.c0 = lobeOf(table, 0);
    facts.c90 = lobeOf(table, 90);
    facts.deviation = deviationOf(table);
    facts.measured = symmetryOf(facts.deviation);
    if (p.watts > 0) facts.efficacy = facts.lumens / p.watts;
    return facts;
}

const char* symmetryText(PhotometrySymmetry s) {
    switch (s) {
        case PhotometrySymmetry::None: return "none";
        case PhotometrySymmetry::Axial: return "axial";
        case PhotometrySymmetry::Bilateral0to180: return "about C0-C180";
        case PhotometrySymmetry::Bilateral90to270: return "about C90-C270";
        case PhotometrySymmetry::Quadrant: return "about both planes";
    }
    return "";
}

const char* openingText(OpeningShape s) {
    switch (s) {
        case OpeningShape::Point: return "point";
        case OpeningShape::Rectangle: return "rectangle";
        case OpeningShape::Disc: return "disc";
        case OpeningShape::Box: return "box";
        case OpeningShape::Cylinder: return "cylinder";
        case OpeningShape::Sphere: return "sphere";
    }
    return "";
}

const char* typeText(PhotometryType t) { return t == PhotometryType::C ? "C" : t == PhotometryType::B ? "B" : "A"; }

}  // namespace luxdeck

#include "engine/io/photometry.h"

#include "engine/core/file.h"
#include "engine/io/eulumdat_fields.h"
#include "engine/io/photometry_flux.h"
#include "engine/io/photometry_opening.h"
#include "engine/io/photometry_planes.h"
#include "engine/io/photometry_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {
namespace {

using namespace photometry;

constexpr std::size_t kMostPlanes = 100'000;
constexpr std::size_t kMostLampSets = 20;  // the format's own limit

/// What the fields before the angles say. Lengths in mm, percentages as in the file.
struct Header {
    std::size_t symmetry = 0;       // Isym
    std::size_t planeCount = 0;     // Mc
    double planeStep = 0;           // Dc [degree]; 0: not equidistant
    std::size_t gammaCount = 0;     // Ng
    double gammaStep = 0;           // Dg [degree]; 0: not equidistant
    double luminousLength = 0;      // along C90-C270 [mm]; the diameter if the width is 0
    double luminousWidth = 0;       // along C0-C180 [mm]
    double luminousHeight[4] = {};  // seen from C0, C90, C180, C270 [mm]
    double downwardPercent = 0;     // DFF
    double outputPercent = 0;       // LORL
    double conversion = 1;
    double tilt = 0;                // of the luminaire during the measurement [degree]
    double lampCount = 1;           // negative: absolute photometry
    double lampLumens = 0;          // total of the set [lm]
};

Result<void> readShape(FieldReader& in, Header& h, Photometry& p) {
    auto text = in.text("company identification");
    if (!text) return text.error();
    p.manufacturer = *text;
    if (auto type = in.lenientNumber("luminaire type", 3); !type) return type.error();
    const auto symmetry = in.count("the symmetry indicator", 0, 4);
    if (!symmetry) return symmetry.error();
    h.symmetry = *symmetry;
    const auto planes = in.count("the number of C planes", 1, kMostPlanes);
    if (!planes) return planes.error();
    h.planeCount = *planes;
    const auto planeStep = in.lenientNumber("the step between C planes", 0);
    if (!planeStep) return planeStep.error();
    h.planeStep = *planeStep;
    const auto gammas = in.count("the number of intensities in each plane", 2, kMostPlanes);
    if (!gammas) return gammas.error();
    h.gammaCount = *gammas;
    const auto gammaStep = in.lenientNumber("the step between gamma angles", 0);
    if (!gammaStep) return gammaStep.error();
    h.gammaStep = *gammaStep;

    if (auto report = in.text("the report number"); !report) return report.error();
    text = in.text("the luminaire's name");
    if (!text) return text.error();
    p.name = *text;
    const auto number = in.text("the luminaire's number");
    if (!number) return number.error();
    if (p.name.empty()) p.name = *number;
    return in.skip(2, "the file name and date");
}

Result<void> readBody(FieldReader& in, Header& h) {
    struct Field {
        const char* what;
        double* value;
        double otherwise;
    };
    double unused = 0;
    const Field fields[] = {{"the luminaire's length", &unused, 0},
                            {"the luminaire's width", &unused, 0},
                            {"the luminaire's height", &unused, 0},
                            {"the luminous length", &h.luminousLength, 0},
                            {"the luminous width", &h.luminousWidth, 0},
                            {"the luminous height at C0", &h.luminousHeight[0], 0},
                            {"the luminous height at C90", &h.luminousHeight[1], 0},
                            {"the luminous height at C180", &h.luminousHeight[2], 0},
                            {"the luminous height at C270", &h.luminousHeight[3], 0},
                            {"the downward flux fraction", &h.downwardPercent, -1},
                            {"the light output ratio", &h.outputPercent, 0},
                            {"the conversion factor", &h.conversion, 1},
                            {"the tilt", &h.tilt, 0}};
    for (const auto& [what, value, otherwise] : fields) {
        const auto number = in.lenientNumber(what, otherwise);
        if (!number) return number.error();
        *value = *number;
    }
    return {};
}

/// The lamp sets are alternatives; the first is taken.
Result<void> readLamps(FieldReader& in, Header& h, Photometry& p) {
    const auto sets = in.count("the number of lamp sets", 1, kMostLampSets);
    if (!sets) return sets.error();
    std::string others;
    for (std::size_t i = 0; i < *sets; ++i) {
        const auto lampCount = in.lenientNumber("the number of lamps", 1);
        if (!lampCount) return lampCount.error();
        const auto lamp = in.text("the type of the lamps");
        if (!lamp) return lamp.error();
        const auto lumens = in.number("the total flux of the lamps");
        if (!lumens) return lumens.error();
        if (auto ok = in.skip(2, "colour temperature and rendering"); !ok) return ok.error();
        const auto watts = in.lenientNumber("the power of the lamps", 0);
        if (!watts) return watts.error();
        if (i > 0) {
            others += fmt::format("{}{} ({:.6g} lm)", i > 1 ? ", " : "", inQuotes(*lamp), *lumens);
            continue;
        }
        if (*lumens < 0) return in.error(fmt::format("the total flux of the lamps is {}, expected >= 0", *lumens));
        h.lampCount = *lampCount;
        h.lampLumens = *lumens;
        p.lamp = *lamp;
        p.watts = std::max(*watts, 0.0);
    }
    if (*sets > 1) {
        p.repairs.push_back(
            fmt::format("{} lamp sets, which are alternatives: the first, {} ({:.6g} lm), is used; not used: {}", *sets,
                        inQuotes(p.lamp), h.lampLumens, others));
    }
    return {};
}

/// Angles as listed; where a tool listed nothing but zeros, from the step.
Result<std::vector<double>> readAngles(FieldReader& in, std::size_t count, double step, const char* what,
                                       Photometry& p) {
    const bool mayRepeat = std::string_view(what) == "gamma angle";  // a step of the intensities
    std::vector<double> angles(count);
    std::size_t firstWrong = 0;
    const std::size_t firstLine = in.line();
    for (std::size_t i = 0; i < count; ++i) {
        const auto angle = in.number(what);
        if (!angle) return angle.error();
        angles[i] = *angle;
        if (i > 0 && firstWrong == 0 && !(angles[i] > angles[i - 1])) firstWrong = i;
    }
    if (firstWrong == 0) return angles;
    const bool stepped = std::is_sorted(angles.begin(), angles.end()) && angles.front() < angles.back();
    if (stepped && mayRepeat) return angles;
    const bool allZero = std::all_of(angles.begin(), angles.end(), [](double a) { return a == 0; });
    if (allZero && step > 0) {
        for (std::size_t i = 0; i < count; ++i) angles[i] = step * static_cast<double>(i);
        p.repairs.push_back(fmt::format("{}s are all 0: taken in steps of {:.4g} degrees", what, step));
        return angles;
    }
    Error error = in.error(fmt::format("{} {} is {:.6g}, expected more than the one before, {:.6g}", what,
                                       firstWrong + 1, angles[firstWrong], angles[firstWrong - 1]));
    const std::string where = error.where.substr(0, error.where.rfind(':'));
    error.where = fmt::format("{}:{}", where, firstLine + firstWrong + 1);
    return error;
}

/// Index of a C plane in the list.
Result<std::size_t> planeAt(const std::vector<double>& planes, double angle, const FieldReader& in,
                            std::size_t symmetry) {
    const auto found = std::find_if(planes.begin(), planes.end(), [&](double c) { return std::abs(c - angle) < 0.01; });
    if (found == planes.end()) {
        return in.error(fmt::format("no C plane at {} degrees among those listed above, where symmetry {} needs one",
                                    angle, symmetry));
    }
    return static_cast<std::size_t>(found - planes.begin());
}

/// The planes whose intensities are stored, in the file's order. All Mc planes are listed in every file, but
/// symmetry 2 stores C0..C180, symmetry 4 C0..C90, and symmetry 3 starts at C270 and goes over C0 to C90.
Result<std::vector<double>> storedPlanes(const std::vector<double>& planes, const Header& h, const FieldReader& in) {
    const auto slice = [&](double from, double to) -> Result<std::vector<double>> {
        const auto first = planeAt(planes, from, in, h.symmetry);
        if (!first) return first.error();
        const auto last = planeAt(planes, to, in, h.symmetry);
        if (!last) return last.error();
        std::vector<double> stored;
        for (std::size_t i = *first; i != *last; i = (i + 1) % planes.size()) stored.push_back(planes[i]);
        stored.push_back(planes[*last]);
        return stored;
    };
    switch (h.symmetry) {
        case 1: return std::vector<double>{0.0};
        case 2: return slice(0, 180);
        case 3: return slice(270, 90);
        case 4: return slice(0, 90);
        default: return planes;
    }
}

PhotometrySymmetry symmetryOf(std::size_t indicator) {
    constexpr PhotometrySymmetry kSymmetries[] = {PhotometrySymmetry::None, PhotometrySymmetry::Axial,
                                                  PhotometrySymmetry::Bilateral0to180,
                                                  PhotometrySymmetry::Bilateral90to270, PhotometrySymmetry::Quadrant};
    return kSymmetries[indicator];
}

Result<StoredPlanes> readPlanes(FieldReader& in, const Header& h, double scale, Photometry& p) {
    const std::size_t angleCount = h.planeCount + h.gammaCount;
    if (angleCount > in.remaining()) {
        return in.error(fmt::format("the file states {} C planes and {} gamma angles; only {} lines follow this one",
                                    h.planeCount, h.gammaCount, in.remaining()));
    }
    const auto planes = readAngles(in, h.planeCount, h.planeStep, "C angle", p);
    if (!planes) return planes.error();
    auto gammas = readAngles(in, h.gammaCount, h.gammaStep, "gamma angle", p);
    if (!gammas) return gammas.error();
    auto symmetry = symmetryOf(h.symmetry);
    auto stored = storedPlanes(*planes, h, in);
    if (!stored) return stored.error();
    if (stored->size() < planes->size() && in.remaining() == planes->size() * gammas->size()) {
        p.repairs.push_back(
            fmt::format("all {} C planes are stored although symmetry {} needs {}: read without symmetry",
                        planes->size(), h.symmetry, stored->size()));
        stored = *planes;
        symmetry = PhotometrySymmetry::None;
    }

    const std::size_t wanted = stored->size() * gammas->size();
    if (wanted > in.remaining()) {
        return in.error(fmt::format("{} planes of {} intensities take {} lines after this one; seen {}", stored->size(),
                                    gammas->size(), wanted, in.remaining()));
    }
    StoredPlanes out{PhotometryType::C, symmetry, std::move(*gammas), std::move(*stored), {}};
    out.candela.resize(wanted);
    for (double& candela : out.candela) {
        const auto value = in.number("an intensity");
        if (!value) return value.error();
        candela = *value * scale;
    }
    separateEqualAngles(out, p.repairs, p.warnings);
    if (in.remaining() > 0)
        p.repairs.push_back(fmt::format("{} line(s) after the last intensity ignored", in.remaining()));
    return out;
}

/// The opening in our frame. EULUMDAT's length runs along C90-C270, which is our y and thus our width (LM-63 has
/// it the other way round).
void readOpening(const Header& h, Photometry& p) {
    const double length = std::abs(h.luminousLength) * 1e-3;
    const double width = std::abs(h.luminousWidth) * 1e-3;
    const auto [least, most] = std::minmax_element(std::begin(h.luminousHeight), std::end(h.luminousHeight));
    // The mean keeps the projected area of the sides right on average.
    const double height = std::max(
        0.0, 0.25e-3 * (h.luminousHeight[0] + h.luminousHeight[1] + h.luminousHeight[2] + h.luminousHeight[3]));
    if (length == 0 && width == 0) {
        p.warnings.emplace_back("no luminous area stated: taken as a point");
        return;
    }
    if (*most - *least > 0.5) {
        p.repairs.push_back(fmt::format("luminous heights from {:.4g} to {:.4g} mm taken as their mean, {:.4g} mm",
                                        *least, *most, 1e3 * height));
    }
    if (width == 0) {
        p.opening = height > 0 ? uprightCylinder(length, height) : disc(length);
    } else {
        p.opening = boxOrRectangle(width, length, height);
    }
    warnIfHuge(p);
}

void noteOddities(const Header& h, const StoredPlanes& stored, Photometry& p) {
    if (h.planeStep > 0 && h.planeCount > 1 && std::abs(h.planeStep * static_cast<double>(h.planeCount) - 360) > 0.5) {
        p.warnings.push_back(
            fmt::format("{} C planes in steps of {:.4g} degrees are no full turn; the listed angles are used",
                        h.planeCount, h.planeStep));
    }
    if (h.symmetry == 0 && stored.horizontal.size() == 1) {
        p.warnings.emplace_back("a single C plane without symmetry: taken as axial");
    }
    if (h.tilt != 0) {
        p.warnings.push_back(fmt::format(
            "measured with the luminaire tilted {:.4g} degrees: the intensities are used as they are", h.tilt));
    }
}

/// Candela for each unit in the table, which is per 1000 lm of the lamps. The light output ratio is in the table
/// already.
double scaleOf(Header& h, Photometry& p) {
    if (!(h.conversion > 0)) {
        p.repairs.push_back(fmt::format("conversion factor {:.4g} taken as 1", h.conversion));
        h.conversion = 1;
    }
    if (h.lampLumens == 0) {
        p.repairs.emplace_back("lamp flux 0: the intensities are taken for 1000 lm");
        return h.conversion;
    }
    return h.conversion * h.lampLumens / 1000;
}

FluxClaim claimOf(const Header& h) {
    FluxClaim claim;
    claim.of = FluxClaim::Of::Luminaire;
    claim.lampLumens = h.lampLumens;
    claim.lumens = h.lampLumens * h.outputPercent / 100;
    claim.downwardPercent = h.downwardPercent;
    claim.statedAs = fmt::format("{:.6g} lm x light output ratio {:.4g} %", h.lampLumens, h.outputPercent);
    return claim;
}

}  // namespace

Result<Photometry> readEulumdat(std::string_view bytes, const std::filesystem::path& name) {
    Photometry p;
    p.format = "EULUMDAT";
    p.fileHash = contentHash(bytes);
    const auto text = decodeText(bytes, name, p.repairs);
    if (!text) return text.error();

    FieldReader in(name, splitLines(*text), p);
    Header header;
    if (auto ok = readShape(in, header, p); !ok) return ok.error();
    if (auto ok = readBody(in, header); !ok) return ok.error();
    if (auto ok = readLamps(in, header, p); !ok) return ok.error();
    if (auto ok = in.skip(10, "the ten direct ratios"); !ok) return ok.error();
    const std::size_t anglesLine = in.line() + 1;
    const double scale = scaleOf(header, p);
    auto stored = readPlanes(in, header, scale, p);
    if (!stored) return stored.error();

    clampNegative(stored->candela, p.warnings);
    noteOddities(header, *stored, p);
    auto full = expanded(*stored);
    auto table =
        CandelaTable::create(full.type, std::move(full.vertical), std::move(full.horizontal), std::move(full.candela));
    if (!table) return errorAt(name, anglesLine, table.error().message);

    p.table = std::move(*table);
    p.symmetry = stored->symmetry;
    p.absolute = header.lampCount < 0;
    readOpening(header, p);
    const FluxClaim claim = claimOf(header);
    p.lumensDeclared = claim.lumens;
    judgeFlux(p, claim, *stored);
    return p;
}

}  // namespace luxdeck

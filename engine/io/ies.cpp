#include "engine/io/photometry.h"

#include "engine/core/file.h"
#include "engine/core/units.h"
#include "engine/io/ies_angles.h"
#include "engine/io/ies_labels.h"
#include "engine/io/ies_opening.h"
#include "engine/io/ies_tilt.h"
#include "engine/io/photometry_flux.h"
#include "engine/io/photometry_planes.h"
#include "engine/io/photometry_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {
namespace {

using namespace photometry;

/// No instrument measures more directions; what a file claims beyond is refused before memory is asked for.
constexpr std::size_t kMostAngles = 100'000;

/// The thirteen numbers after TILT, in the file's order.
struct Numbers {
    double lampCount = 1;
    double lumensPerLamp = -1;  // [lm]; negative: absolute photometry
    double multiplier = 1;
    std::size_t verticalCount = 0;
    std::size_t horizontalCount = 0;
    PhotometryType type = PhotometryType::C;
    double metresPerUnit = 1;
    double width = 0;
    double length = 0;
    double height = 0;
    double ballastFactor = 1;
    double twelfth = 1;  // 1986, 1991: ballast-lamp photometric factor; later: unused; 2019: file generation type
    double watts = 0;
};

Result<PhotometryType> readType(TokenReader& tokens) {
    const auto code = tokens.count("the photometric type (1 = C, 2 = B, 3 = A)", 3);
    if (!code) return code.error();
    constexpr PhotometryType kTypes[] = {PhotometryType::C, PhotometryType::B, PhotometryType::A};
    return kTypes[*code - 1];
}

Result<Numbers> readNumbers(TokenReader& tokens) {
    Numbers n;
    const auto read = [&](std::initializer_list<std::pair<const char*, double*>> fields) -> Result<void> {
        for (const auto& [what, field] : fields) {
            const auto value = tokens.number(what);
            if (!value) return value.error();
            *field = *value;
        }
        return {};
    };
    auto ok = read({{"the number of lamps", &n.lampCount},
                    {"the lumens per lamp", &n.lumensPerLamp},
                    {"the candela multiplier", &n.multiplier}});
    if (!ok) return ok.error();
    const auto verticalCount = tokens.count("the number of vertical angles", kMostAngles);
    if (!verticalCount) return verticalCount.error();
    const auto horizontalCount = tokens.count("the number of horizontal angles", kMostAngles);
    if (!horizontalCount) return horizontalCount.error();
    const auto type = readType(tokens);
    if (!type) return type.error();
    const auto units = tokens.count("the unit of lengths (1 = feet, 2 = metres)", 2);
    if (!units) return units.error();
    ok = read({{"the width of the opening", &n.width},
               {"the length of the opening", &n.length},
               {"the height of the opening", &n.height},
               {"the ballast factor", &n.ballastFactor},
               {"the ballast-lamp factor (or its successor)", &n.twelfth},
               {"the input watts", &n.watts}});
    if (!ok) return ok.error();
    n.verticalCount = *verticalCount;
    n.horizontalCount = *horizontalCount;
    n.type = *type;
    n.metresPerUnit = *units == 1 ? kMetresPerFoot : 1;
    return n;
}

/// What every candela value is multiplied by, beside the candela multiplier.
/// The twelfth number is a factor in 1986 and 1991 only; LM-63-2019 puts its generation type there, 1.1 for an
/// accredited laboratory, and multiplying by it would be 10 % wrong.
Result<double> lampFactor(Numbers& n, int year, const TokenReader& tokens, Photometry& p) {
    const auto settle = [&](double& factor, const char* what) -> Result<void> {
        if (factor < 0) return tokens.error(fmt::format("{} is {}, expected > 0", what, factor));
        if (factor == 0) {
            factor = 1;
            p.repairs.push_back(fmt::format("{} 0 taken as 1", what));
        }
        return {};
    };
    if (auto ok = settle(n.multiplier, "candela multiplier"); !ok) return ok.error();
    if (auto ok = settle(n.ballastFactor, "ballast factor"); !ok) return ok.error();
    if (year <= 1991) {
        if (auto ok = settle(n.twelfth, "ballast-lamp photometric factor"); !ok) return ok.error();
        return n.ballastFactor * n.twelfth;
    }
    if (year < 2019 && n.twelfth != 1 && n.twelfth != 0) {
        p.warnings.push_back(fmt::format(
            "the number after the ballast factor is {:.6g}, unused since 1995: not multiplied in", n.twelfth));
    }
    return n.ballastFactor;
}

/// Angles and candela, absolute; refused before any allocation if the file cannot hold what it claims.
Result<StoredPlanes> readPlanes(TokenReader& tokens, const Numbers& n, double scale) {
    const std::size_t wanted = n.verticalCount + n.horizontalCount + n.verticalCount * n.horizontalCount;
    if (wanted > tokens.remaining()) {
        return tokens.error(
            fmt::format("the file states {} vertical and {} horizontal angles, which take {} numbers after "
                        "this line; seen {}",
                        n.verticalCount, n.horizontalCount, wanted, tokens.remaining()));
    }
    StoredPlanes stored;
    stored.type = n.type;
    const auto read = [&](std::vector<double>& values, std::size_t count, const char* what,
                          double factor) -> Result<void> {
        values.resize(count);
        for (double& value : values) {
            const auto number = tokens.number(what);
            if (!number) return number.error();
            value = *number * factor;
        }
        return {};
    };
    if (auto ok = read(stored.vertical, n.verticalCount, "a vertical angle", 1); !ok) return ok.error();
    if (auto ok = read(stored.horizontal, n.horizontalCount, "a horizontal angle", 1); !ok) return ok.error();
    if (auto ok = read(stored.candela, n.verticalCount * n.horizontalCount, "a candela value", scale); !ok)
        return ok.error();
    return stored;
}

void noteTrailing(const TokenReader& tokens, Photometry& p) {
    if (tokens.remaining() == 0) return;
    if (parseNumber(tokens.peek())) {
        p.repairs.push_back(fmt::format("{} number(s) after the last candela value ignored", tokens.remaining()));
    } else {
        p.warnings.push_back(
            fmt::format("text after the last candela value ({}): a second luminaire? Only the first is read",
                        inQuotes(tokens.peek())));
    }
}

FluxClaim claimOf(const Numbers& n, double factor) {
    if (n.lumensPerLamp < 0) return {};
    FluxClaim claim;
    claim.of = FluxClaim::Of::Lamps;
    claim.lampLumens = std::abs(n.lampCount) * n.lumensPerLamp;
    claim.lumens = claim.lampLumens * factor;
    claim.statedAs = fmt::format("{:.6g} x {:.6g} lm", std::abs(n.lampCount), n.lumensPerLamp);
    if (factor != 1) claim.statedAs += fmt::format(" x ballast factor {:.4g}", factor);
    return claim;
}

void describe(const Labels& labels, const Numbers& n, Photometry& p) {
    p.format = labels.format;
    p.name = firstOf(labels, {"LUMINAIRE", "LUMCAT"});
    if (p.name.empty()) p.name = labels.freeText;
    p.manufacturer = firstOf(labels, {"MANUFAC"});
    p.lamp = firstOf(labels, {"LAMP", "LAMPCAT"});
    p.watts = std::max(n.watts, 0.0);
    p.absolute = n.lumensPerLamp < 0;
}

/// In the numbering of 1986, 1 meant both C and A; the vertical angles tell.
void settleType1986(StoredPlanes& stored, int year, Photometry& p) {
    const bool negative = std::any_of(stored.vertical.begin(), stored.vertical.end(), [](double v) { return v < 0; });
    if (year > 1986 || stored.type != PhotometryType::C || !negative) return;
    stored.type = PhotometryType::A;
    p.repairs.emplace_back(
        "photometric type 1 with negative vertical angles taken as type A (1986 used 1 for C and A)");
}

}  // namespace

Result<Photometry> readIes(std::string_view bytes, const std::filesystem::path& name) {
    Photometry p;
    p.fileHash = contentHash(bytes);
    const auto text = decodeText(bytes, name, p.repairs);
    if (!text) return text.error();
    const auto lines = splitLines(*text);
    const auto labels = readLabels(lines, name, p);
    if (!labels) return labels.error();

    TokenReader tokens(name, lines, labels->tiltLine + 1, p.repairs);
    if (const auto tilt = readTilt(*labels, name, tokens, p); !tilt) return tilt.error();
    auto numbers = readNumbers(tokens);
    if (!numbers) return numbers.error();
    const auto factor = lampFactor(*numbers, labels->year, tokens, p);
    if (!factor) return factor.error();
    const std::size_t anglesLine = tokens.line() + 1;
    auto stored = readPlanes(tokens, *numbers, numbers->multiplier * *factor);
    if (!stored) return stored.error();
    noteTrailing(tokens, p);

    settleType1986(*stored, labels->year, p);
    clampNegative(stored->candela, p.warnings);
    bool mirrorsVertical = false;
    if (auto ok = settleAngles(*stored, mirrorsVertical, p); !ok) return errorAt(name, anglesLine, ok.error().message);
    auto full = expanded(*stored, mirrorsVertical);
    warnIfSeamDiffers(full, p.warnings);
    auto table =
        CandelaTable::create(full.type, std::move(full.vertical), std::move(full.horizontal), std::move(full.candela));
    if (!table) return errorAt(name, anglesLine, table.error().message);

    p.table = std::move(*table);
    p.symmetry = stored->symmetry;
    describe(*labels, *numbers, p);
    readOpening({labels->year, numbers->width, numbers->length, numbers->height, numbers->metresPerUnit}, p);
    const FluxClaim claim = claimOf(*numbers, *factor);
    p.lumensDeclared = claim.lumens;
    judgeFlux(p, claim, *stored);
    return p;
}

}  // namespace luxdeck

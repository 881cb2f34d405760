#pragma once

#include "engine/scene/candela_table.h"

#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

/// Intensity towards a C plane's angle gamma (0 nadir, 180 zenith), whatever the type of photometry [cd].
/// Negative gammas are on the other side of the nadir: those of the plane C + 180.
double intensityAt(const CandelaTable& table, double planeDegrees, double gammaDegrees);

/// The two planes that catalogues print: all the way round at every degree, from -180 (zenith) over 0 (nadir) to
/// 180; negative angles are C180 and C270.
struct PolarCurve {
    static constexpr int kStepsPerTurn = 360;
    std::vector<double> c0;   // #361  C180 | C0 [cd]
    std::vector<double> c90;  // #361  C270 | C90 [cd]
};

PolarCurve polarCurve(const CandelaTable& table);

/// How wide the lobe of one plane is. Measured in both half-planes together, between the outermost directions of
/// the lobe's hemisphere that have the share of the plane's own maximum, so a batwing's dip does not end it.
struct LobeWidth {
    std::optional<double> beamDegrees;   // at half the maximum; none: it never falls that low, or the plane is dark
    std::optional<double> fieldDegrees;  // at a tenth
};

/// How far a distribution is from being its own mirror image: the largest difference of intensities over the
/// distribution's maximum [-], 0 for perfect symmetry.
struct SymmetryDeviation {
    double axial = 0;     // from the mean over all planes
    double about0 = 0;    // mirrored at C0-C180
    double about90 = 0;   // mirrored at C90-C270
};

struct PeakDirection {
    double candela = 0;
    double gammaDegrees = 0;
    double planeDegrees = 0;  // of C, 0 where the peak is on the axis
};

/// Where the largest intensity of the table is. The table is not empty.
PeakDirection peakDirection(const CandelaTable& table);

/// What can be measured on a photometric file that has been read.
struct PhotometricFacts {
    double lumens = 0;                     // integral of the interpolated intensities
    double lumensDown = 0, lumensUp = 0;   // below and above the horizontal
    std::optional<double> declaredRatio;   // integrated over declared flux; none: nothing is declared
    std::string fluxJudgement;             // why they differ, or that they agree
    PeakDirection peak;
    LobeWidth c0, c90;
    SymmetryDeviation deviation;
    PhotometrySymmetry measured = PhotometrySymmetry::None;  // the highest that holds within kSymmetric
    std::optional<double> efficacy;        // [lm/W]; none: no power stated
};

/// A mirror image that differs by less than this of the maximum counts as the same: what goniometers repeat to.
constexpr double kSymmetric = 0.02;

PhotometricFacts measure(const Photometry& photometry);

/// Words of the command line, the JSON and the sheet.
const char* symmetryText(PhotometrySymmetry symmetry);
const char* openingText(OpeningShape shape);
const char* typeText(PhotometryType type);

}  // namespace luxdeck

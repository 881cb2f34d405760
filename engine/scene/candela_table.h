#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace luxdeck {

/// The goniometer's axes. C: polar axis is the nadir-zenith line (architectural). B: planes turn about a
/// horizontal axis (floodlights). A: about the vertical axis (car headlamps).
enum class PhotometryType { C, B, A };

/// The mirror symmetry a file was stored with (the table itself is always expanded).
enum class PhotometrySymmetry { None, Axial, Bilateral0to180, Bilateral90to270, Quadrant };

/// Luminous intensity by direction: bilinear in the file's own two angles, zero outside their range.
///
/// Local frame of a luminaire: it hangs with its nadir (C: vertical angle 0; A, B: direction 0, 0)
/// along -z, the plane C = 0 towards +x and C = 90 towards +y. Unit direction d of the angles (V, H):
///
///     C: d = ( sin V cos H,  sin V sin H, -cos V)      solid angle  sin V dV dH
///     B: d = ( cos H sin V, -sin H, -cos H cos V)      solid angle  cos H dH dV  (H: true latitude)
///     A: d = ( sin V, -cos V sin H, -cos V cos H)      solid angle  cos V dV dH  (V: true latitude)
///
/// A and B aim along a = -z with their "up" along u = +x, so a viewer behind the luminaire has his right
/// hand along a x u = -y, towards which H grows (clockwise seen from above, as LM-63 has it; C turns the
/// other way). Radiance's source.cal sets B up the same way, but its H is no true latitude off axis.
/// Constant after create(): safe to share between threads.
class CandelaTable {
public:
    CandelaTable() = default;

    /// vertical    #V, degrees, strictly increasing. Type C: 0 nadir .. 180 zenith; A, B: -90 .. 90
    /// horizontal  #H, degrees, strictly increasing. Type C: expanded, first 0, last 360 (or the single 0)
    ///             A, B: -90 .. 90 (expanded if the file gave half)
    /// candela     #H x #V, vertical fastest, finite, >= 0 [cd]
    /// errors      InvalidArgument naming the offending index, value and bound
    static Result<CandelaTable> create(PhotometryType type, std::vector<double> vertical,
                                       std::vector<double> horizontal, std::vector<double> candela);

    /// Intensity towards a unit direction in the luminaire's frame [cd].
    [[nodiscard]] float intensity(const Vec3& direction) const;

    /// Total flux of the interpolated distribution, integrated in closed form over each cell [lm].
    [[nodiscard]] double lumens() const { return lumens_; }
    /// The part of lumens() that goes below the horizontal (type C) [lm].
    [[nodiscard]] double lumensDown() const { return lumensDown_; }
    [[nodiscard]] float maxIntensity() const { return maxIntensity_; }
    [[nodiscard]] PhotometryType type() const { return type_; }
    [[nodiscard]] const std::vector<double>& vertical() const { return vertical_; }
    [[nodiscard]] const std::vector<double>& horizontal() const { return horizontal_; }
    [[nodiscard]] const std::vector<double>& candela() const { return candela_; }

private:
    /// One angular axis as the inner loop wants it.
    struct Axis {
        std::vector<float> degrees;
        float inverseStep = 0;  ///< 1/step [1/degree] where equidistant, else 0
    };

    [[nodiscard]] float interpolate(float verticalDegrees, float horizontalDegrees) const;
    void prepareLookup();
    void integrate();

    PhotometryType type_ = PhotometryType::C;
    std::vector<double> vertical_;
    std::vector<double> horizontal_;
    std::vector<double> candela_;
    Axis verticalAxis_;
    Axis horizontalAxis_;
    std::vector<float> cells_;  ///< candela_ as the inner loop reads it, vertical fastest [cd]
    double lumens_ = 0;
    double lumensDown_ = 0;
    float maxIntensity_ = 0;
};

/// The shape of a luminaire's luminous opening, centred on its photometric centre, in its own frame:
/// length along x (C0-C180), width along y (C90-C270), height along z.
enum class OpeningShape { Point, Rectangle, Disc, Box, Cylinder, Sphere };

struct LuminousOpening {
    OpeningShape shape = OpeningShape::Point;
    double lengthM = 0;  ///< along x; the diameter of a disc, vertical cylinder or sphere
    double widthM = 0;   ///< along y; equals lengthM where round
    double heightM = 0;  ///< along z; 0 for flat openings
};

/// One photometric file, read and understood.
struct Photometry {
    std::string name;           ///< luminaire name or number
    std::string manufacturer;
    std::string lamp;
    std::string format;         ///< "LM-63-2002", "EULUMDAT" ...
    std::string fileHash;       ///< contentHash of the bytes
    CandelaTable table;         ///< absolute candela [cd]
    PhotometrySymmetry symmetry = PhotometrySymmetry::None;  ///< as stored
    LuminousOpening opening;
    double lumensDeclared = 0;  ///< luminaire flux that the header implies [lm]; 0: absolute file that states none
    bool absolute = false;      ///< absolute photometry (no lamp flux given)
    double watts = 0;           ///< input power [W]; 0: not given
    std::vector<std::string> repairs;   ///< what was repaired and why
    std::vector<std::string> warnings;  ///< what looks wrong but was left
};

}  // namespace luxdeck

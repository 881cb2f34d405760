#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/io/cal_library.h"
#include "engine/scene/pattern.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// Radiance's primitives that make a factor, or the fraction of a mixture.
enum class PatternKind { BrightFunc, ColorFunc, BrightData, ColorData, ColorPict, MixFunc, MixData, MixPict };

/// "brightfunc" ... "mixpict"; none for another type.
std::optional<PatternKind> patternKind(std::string_view type);

/// Where a primitive's transform arguments ("-rz 90 -t 0 0 1") begin among its string arguments; their number
/// when it has none. For PatternKind, and for texfunc, BRTDfunc and the like by where their function file is.
std::size_t firstTransformArgument(PatternKind kind, std::span<const std::string> strings);
std::size_t firstTransformArgument(std::size_t functionFile, std::span<const std::string> strings);

/// A primitive's arguments, as its file gives them.
struct PatternSource {
    std::vector<std::string> strings;  ///< without the transform's; mixtures: with both modifiers in front
    std::vector<double> reals;         ///< A1 ... An
    std::filesystem::path folder;      ///< of the file that the primitive is in
    /// From the primitive's own coordinates to the user's, in row vectors: its transform arguments, then
    /// every xform about it. Invertible; its scale is taken to be the same in all directions.
    Matrix4d toWorld;
    std::string where;                 ///< "file:line", for messages
};

/// The factor of a pattern (a grey one of bright...), or the fraction of a mixture's first material, 0..1, as a
/// grey. Colours are in Radiance's primaries; pictures come raw, without their exposure, as Radiance takes them.
/// `PatternPoint::normal` faces the ray, so Rdot is never negative.
///
/// errors   InvalidArgument (too few arguments, a number of variables other than the data's dimensions, a
///          singular transform), FileNotFound, Parse, Unsupported; `where` is the primitive's or the file's line
/// threads  value() from any number; the same bits from all. It allocates nothing.
/// fails    value() is NaN where an expression has none: a division by zero, the logarithm of a negative
///          number, a missing real argument, recursion deeper or longer than cal::kMostDepth, cal::kMostSteps
Result<std::shared_ptr<const Pattern>> makePattern(PatternKind kind, const PatternSource& source, CalLibrary& library);

/// Expressions of one function file together: the dx dy dz of a texfunc, the reflectances of a BRTDfunc.
class RayExpressions {
public:
    virtual ~RayExpressions() = default;
    /// Values in the primitive's own coordinates, #E; NaN where an expression has none.
    /// materialColour  what CrP, CgP, CbP are
    virtual void evaluate(const PatternPoint& at, const Rgb& materialColour, std::span<double> values) const = 0;
    /// A vector of the primitive's own coordinates as the user's coordinates have it, its length kept.
    [[nodiscard]] virtual Vec3d toWorld(const Vec3d& local) const = 0;
};

/// expressions   text, in the order that evaluate() gives their values
/// functionFile  "." for none
/// errors        as makePattern()
Result<std::shared_ptr<const RayExpressions>> makeRayExpressions(std::span<const std::string> expressions,
                                                                 const std::string& functionFile,
                                                                 const PatternSource& source, CalLibrary& library);

}  // namespace luxdeck

#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/io/rad_primitive.h"
#include "engine/io/warning_list.h"
#include "engine/io/xform.h"
#include "engine/scene/scene.h"

#include <memory>
#include <span>
#include <string>

namespace luxdeck::rad {

/// What gensky and gendaylit stand for: a sky, and how xform turned it since.
struct GeneratedSky {
    Sky sky;
    Matrix4d turn;  ///< rotation alone
};

std::shared_ptr<const GeneratedSky> turned(const GeneratedSky& sky, const Xform& xform);

/// The sky as the pattern that its skyfunc is, in the scene's axes.
///
/// toScene  from the file's axes; its scale and shift do not matter
std::shared_ptr<const Pattern> patternOf(const GeneratedSky& sky, const Matrix4d& toScene);

/// What `gensky ...` or `gendaylit ...` writes: the pattern skyfunc, and the sun as the light solar and the source sun
/// where there is one.
///
/// words   the arguments without the program's name
/// errors  InvalidArgument, Unsupported: file:line, seen, expected
Result<Primitives> generateSky(const std::string& program, std::span<const std::string> words, const Place& place, WarningList& warnings);

/// A source with what it sends.
struct SourceLight {
    const Primitive& source;
    Rgb radiance;                            ///< of its material [cd/m^2]
    std::shared_ptr<const Pattern> pattern;  ///< null: none
    const Matrix4d& toScene;
};

/// Adds a source to the scene's sky: a sun when it is small and even, else a dome.
///
/// errors  Parse: no direction, an angle out of 0..360; file:line
Result<void> placeSource(const SourceLight& light, Sky& sky);

}  // namespace luxdeck::rad

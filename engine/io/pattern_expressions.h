#pragma once

#include "engine/io/cal_evaluate.h"
#include "engine/io/pattern_frame.h"
#include "engine/io/pattern_radiance.h"

#include <memory>
#include <span>
#include <string>

namespace luxdeck {

/// Expressions of a function file, compiled in the frame of the primitive that asks for them.
struct CompiledExpressions {
    PatternFrame frame;
    cal::Code code;
    std::string functionHash;  ///< of the file's text
};

/// entries    definitions of "", see cal::compile()
/// material   CrP, CgP, CbP are known
/// errors     those of CalLibrary::functions(), cal::compile() and PatternFrame::create()
Result<CompiledExpressions> compileExpressions(const std::string& functionFile,
                                               std::span<const std::shared_ptr<const cal::Module>> entries,
                                               const PatternSource& source, CalLibrary& library, bool material);

/// An error of a file, with the primitive that asked for it.
Error askedFor(Error error, const PatternSource& source);

/// A ray from nowhere special, to try expressions with once they are made.
PatternPoint trialPoint();

/// What never ends, or asks for what is not given, is an error of the file; having no value for some ray is not.
Result<void> checkTrial(cal::Failure worst, const PatternSource& source);

}  // namespace luxdeck

#pragma once

#include "engine/core/result.h"
#include "engine/io/cal_module.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace luxdeck::cal {

/// What changes from ray to ray, by the place of its value in what evaluate() is given.
enum class Input : std::uint8_t { Dx, Dy, Dz, Nx, Ny, Nz, Px, Py, Pz, T, Ts, Rdot, Lu, Lv, CrP, CgP, CbP };
inline constexpr std::size_t kInputCount = 17;
using Inputs = std::array<double, kInputCount>;

enum class Op : std::uint8_t {
    Number,
    Input,
    Argument,
    Variable,
    Call,
    CallArgument,
    CallNative,
    FunctionName,
    NativeName,
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power
};

/// A step of compiled expressions. Operands are other steps, before it in the same definition.
struct Step {
    Op op = Op::Number;
    std::uint32_t index = 0;  ///< Input; Argument, CallArgument: which one; Variable, Call, CallNative, names: of what
    std::uint32_t first = 0;  ///< operands begin here in Code::operands
    std::uint32_t count = 0;
    double number = 0;
};

struct CompiledFunction {
    std::string name;
    std::uint32_t root = 0;
    std::uint32_t parameterCount = 0;
};
struct CompiledVariable {
    std::string name;
    std::uint32_t root = 0;
};

/// At most so many variables may depend on the ray, since their values live on the stack.
inline constexpr std::size_t kMostVariables = 512;

/// Expressions with all that they refer to, in flat tables. Constant once it is compiled.
struct Code {
    std::vector<Step> steps;
    std::vector<std::uint32_t> operands;
    std::vector<CompiledFunction> functions;
    std::vector<CompiledVariable> variables;
    std::vector<std::uint32_t> entries;  ///< roots, in the order that was asked for
    std::vector<double> realArguments;  ///< A1 ...
};

/// What names mean besides the definitions.
struct Bindings {
    std::vector<double> realArguments;
    std::map<std::string, double, std::less<>> constants;  ///< S, Tx ... of a pattern
    bool ray = true;  ///< Dx, Px ... are known
    bool material = false;  ///< CrP, CgP, CbP are known
};

/// Definitions by the order in which they are looked for.
using Scope = std::vector<std::shared_ptr<const Module>>;

/// Compiles the definitions of "" in `entries`, each in view of the scope; what no entry leads to is left alone,
/// as undefined names there are. Parts without inputs are computed once, here.
///
/// errors  Parse: a name that is not defined, a variable defined by itself (named), too few arguments, a
///         function where a value is expected, more than kMostVariables
Result<Code> compile(const Scope& scope, std::span<const std::shared_ptr<const Module>> entries,
                     const Bindings& bindings);

/// Replaces what does not depend on inputs by its value, and choices that are known by what they choose.
void foldConstants(Code& code);

}  // namespace luxdeck::cal

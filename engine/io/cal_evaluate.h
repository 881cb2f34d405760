#pragma once

#include "engine/io/cal_code.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace luxdeck::cal {

inline constexpr std::uint32_t kMostDepth = 4000;     ///< of steps within steps: some hundred calls of a function
inline constexpr std::uint32_t kMostSteps = 1000000;  ///< of one evaluation; a pattern takes some hundred

/// Why an expression has no value, the worst last.
enum class Failure : std::uint8_t { None, NoValue, MissingArgument, NotAFunction, TooFewArguments, TooDeep, TooLong };

struct Value {
    double number = 0;  ///< NaN when it failed
    Failure failure = Failure::None;
};

/// Values of several entries for the same inputs: each variable is computed once at most. As in Radiance,
/// arguments are computed when they are used first, `if` and `select` look at what they choose alone, and one
/// failure anywhere leaves no value. Allocates nothing; some 10 kB of stack, and 1 MB at kMostDepth.
class Evaluation {
public:
    Evaluation(const Code& code, const Inputs& inputs) : code_(code), inputs_(inputs) {}

    /// arguments   values of the entry's parameters, at most kMostEntryArguments
    Value value(std::uint32_t entry, std::span<const double> arguments = {});
    /// Of any step without arguments, in at most `steps`.
    Value stepValue(std::uint32_t step, std::uint32_t steps);
    [[nodiscard]] std::uint32_t stepsTaken() const { return steps_; }

private:
    struct Frame;
    double at(std::uint32_t step, Frame* frame);
    double argument(std::uint32_t index, Frame* frame);
    double variable(std::uint32_t index);
    double callArgument(const Step& step, Frame* frame);
    double callFunction(const CompiledFunction& function, const Step& call, Frame* frame);
    double callNative(std::uint32_t function, const Step& call, Frame* frame);
    double special(std::uint32_t function, const Step& call, Frame* frame);
    double realArgument(double number);
    [[nodiscard]] std::uint32_t operand(const Step& step, std::uint32_t i) const {
        return code_.operands[step.first + i];
    }
    double checked(double value) { return value - value == 0 ? value : fail(Failure::NoValue); }
    double fail(Failure failure);

    const Code& code_;
    const Inputs& inputs_;
    std::array<double, kMostVariables> values_;  // those of known_ only
    std::array<std::uint64_t, kMostVariables / 64> known_{};
    std::uint32_t depth_ = 0;
    std::uint32_t steps_ = 0;
    std::uint32_t mostSteps_ = kMostSteps;
    Failure failure_ = Failure::None;
};

inline constexpr std::size_t kMostEntryArguments = 8;

}  // namespace luxdeck::cal

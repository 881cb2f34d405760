#include "engine/io/cal_evaluate.h"

#include "engine/io/cal_functions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck::cal {

namespace {

constexpr std::uint32_t kKept = kMostEntryArguments;  // arguments of a call whose values are kept

}  // namespace

/// A call that is being evaluated: where its arguments are, and their values as far as they were asked for.
struct Evaluation::Frame {
    const Step* call = nullptr;  ///< none: an entry, whose arguments are all known
    Frame* caller = nullptr;     ///< whose parameters the arguments may name
    std::uint32_t count = 0;     ///< of arguments
    std::uint32_t known = 0;     ///< bits
    double values[kKept];
};

double Evaluation::fail(Failure failure) {
    if (failure_ == Failure::None) failure_ = failure;
    return std::numeric_limits<double>::quiet_NaN();
}

Value Evaluation::value(std::uint32_t entry, std::span<const double> arguments) {
    failure_ = Failure::None;
    steps_ = 0;
    Frame frame;
    frame.count = static_cast<std::uint32_t>(std::min<std::size_t>(arguments.size(), kKept));
    frame.known = (1U << frame.count) - 1;
    std::copy_n(arguments.begin(), frame.count, frame.values);
    const double number = at(code_.entries[entry], &frame);
    return {failure_ == Failure::None ? number : fail(failure_), failure_};
}

Value Evaluation::stepValue(std::uint32_t step, std::uint32_t steps) {
    failure_ = Failure::None;
    steps_ = 0;
    mostSteps_ = steps;
    const double number = at(step, nullptr);
    return {failure_ == Failure::None ? number : fail(failure_), failure_};
}

double Evaluation::at(std::uint32_t index, Frame* frame) {
    if (failure_ != Failure::None) return 0;  // nothing more matters
    if (++steps_ > mostSteps_) return fail(Failure::TooLong);
    if (depth_ >= kMostDepth) return fail(Failure::TooDeep);
    ++depth_;
    const Step& step = code_.steps[index];
    double result = 0;
    switch (step.op) {
        case Op::Number: result = step.number; break;
        case Op::Input: result = inputs_[step.index]; break;
        case Op::Argument: result = argument(step.index, frame); break;
        case Op::Variable: result = variable(step.index); break;
        case Op::Call: result = callFunction(code_.functions[step.index], step, frame); break;
        case Op::CallArgument: result = callArgument(step, frame); break;
        case Op::CallNative: result = callNative(step.index, step, frame); break;
        case Op::FunctionName:
        case Op::NativeName: result = fail(Failure::NoValue); break;
        case Op::Negate: result = -at(operand(step, 0), frame); break;
        case Op::Add: result = at(operand(step, 0), frame) + at(operand(step, 1), frame); break;
        case Op::Subtract: result = at(operand(step, 0), frame) - at(operand(step, 1), frame); break;
        case Op::Multiply: result = at(operand(step, 0), frame) * at(operand(step, 1), frame); break;
        case Op::Divide: result = checked(at(operand(step, 0), frame) / at(operand(step, 1), frame)); break;
        case Op::Power: result = checked(std::pow(at(operand(step, 0), frame), at(operand(step, 1), frame))); break;
    }
    --depth_;
    return result;
}

double Evaluation::argument(std::uint32_t index, Frame* frame) {
    if (frame == nullptr || index >= frame->count) return fail(Failure::TooFewArguments);
    if (index < kKept && (frame->known >> index & 1U) != 0) return frame->values[index];
    const double value = at(operand(*frame->call, index), frame->caller);
    if (index < kKept) {
        frame->values[index] = value;
        frame->known |= 1U << index;
    }
    return value;
}

double Evaluation::variable(std::uint32_t index) {
    const std::uint64_t bit = std::uint64_t{1} << (index % 64);
    if ((known_[index / 64] & bit) != 0) return values_[index];
    const double value = at(code_.variables[index].root, nullptr);
    if (failure_ == Failure::None) {
        values_[index] = value;
        known_[index / 64] |= bit;
    }
    return value;
}

double Evaluation::callFunction(const CompiledFunction& function, const Step& call, Frame* caller) {
    if (call.count < function.parameterCount) return fail(Failure::TooFewArguments);
    Frame frame;
    frame.call = &call;
    frame.caller = caller;
    frame.count = call.count;
    return at(function.root, &frame);
}

/// The function that a parameter stands for is named by the call, or by a parameter of the caller, and so on.
double Evaluation::callArgument(const Step& step, Frame* frame) {
    std::uint32_t index = step.index;
    for (const Frame* f = frame; f != nullptr && f->call != nullptr; f = f->caller) {
        if (++steps_ > mostSteps_) return fail(Failure::TooLong);
        if (index >= f->count) return fail(Failure::TooFewArguments);
        const Step& given = code_.steps[operand(*f->call, index)];
        if (given.op == Op::FunctionName) return callFunction(code_.functions[given.index], step, frame);
        if (given.op == Op::NativeName) return callNative(given.index, step, frame);
        if (given.op != Op::Argument) break;
        index = given.index;
    }
    return fail(Failure::NotAFunction);
}

double Evaluation::callNative(std::uint32_t index, const Step& call, Frame* frame) {
    const NativeFunction& function = nativeFunctions()[index];
    if (call.count < function.leastArguments) return fail(Failure::TooFewArguments);
    if (function.special != Special::None) return special(index, call, frame);
    double arguments[kMostNativeArguments];
    const auto count = static_cast<std::uint32_t>(function.anyNumber ? call.count : function.leastArguments);
    if (count <= kMostNativeArguments) {
        for (std::uint32_t i = 0; i < count; ++i) arguments[i] = at(operand(call, i), frame);
        return checked(function.evaluate(arguments, count));
    }
    // min and max of more: two at a time.
    arguments[0] = at(operand(call, 0), frame);
    for (std::uint32_t i = 1; i < count; ++i) {
        arguments[1] = at(operand(call, i), frame);
        arguments[0] = function.evaluate(arguments, 2);
    }
    return checked(arguments[0]);
}

double Evaluation::special(std::uint32_t index, const Step& call, Frame* frame) {
    const double first = at(operand(call, 0), frame);
    if (std::isnan(first)) return fail(Failure::NoValue);
    switch (nativeFunctions()[index].special) {
        case Special::If: return at(operand(call, first > 0 ? 1 : 2), frame);
        case Special::RealArgument: return realArgument(first);
        case Special::Select: break;
        case Special::None: break;
    }
    const double number = std::floor(first + 0.5);
    if (number == 0) return call.count - 1;
    if (!(number >= 1 && number < call.count)) return fail(Failure::NoValue);
    return at(operand(call, static_cast<std::uint32_t>(number)), frame);
}

double Evaluation::realArgument(double number) {
    const double whole = std::floor(number + 0.5);
    if (whole < 1) return double(code_.realArguments.size());
    if (!(whole <= double(code_.realArguments.size()))) return fail(Failure::MissingArgument);
    return code_.realArguments[static_cast<std::size_t>(whole) - 1];
}

}  // namespace luxdeck::cal

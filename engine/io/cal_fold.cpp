#include "engine/io/cal_code.h"
#include "engine/io/cal_evaluate.h"
#include "engine/io/cal_functions.h"

#include <algorithm>

namespace luxdeck::cal {

namespace {

/// What each step needs to be known: the ray, or the arguments of the function that it is in.
struct Needs {
    std::vector<bool> ray;       // by step
    std::vector<bool> argument;  // by step
};

Needs needs(const Code& code) {
    Needs result{std::vector<bool>(code.steps.size()), std::vector<bool>(code.steps.size())};
    // Definitions come after what refers to them, as a rule: backwards few rounds do. Flags are only ever set,
    // so this ends.
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = code.steps.size(); i-- > 0;) {
            const Step& step = code.steps[i];
            bool ray = step.op == Op::Input;
            bool argument = step.op == Op::Argument || step.op == Op::CallArgument;
            if (step.op == Op::Variable) ray = result.ray[code.variables[step.index].root];
            if (step.op == Op::Call || step.op == Op::FunctionName) ray = result.ray[code.functions[step.index].root];
            for (std::uint32_t k = 0; k < step.count; ++k) {
                const auto operand = code.operands[step.first + k];
                ray = ray || result.ray[operand];
                argument = argument || result.argument[operand];
            }
            if (ray == result.ray[i] && argument == result.argument[i]) continue;
            result.ray[i] = ray, result.argument[i] = argument;
            changed = true;
        }
    }
    return result;
}

bool isName(Op op) { return op == Op::FunctionName || op == Op::NativeName; }

bool isChoice(const Step& step) {
    return step.op == Op::CallNative && nativeFunctions()[step.index].special == Special::If;
}

}  // namespace

void foldConstants(Code& code) {
    const Needs need = needs(code);
    const Inputs unused{};
    Evaluation evaluation(code, unused);
    std::uint32_t left = kMostSteps;  // for all of it: a file must not keep the reader busy
    for (std::uint32_t i = 0; i < code.steps.size() && left > 0; ++i) {
        Step& step = code.steps[i];
        if (step.op == Op::Number || isName(step.op)) continue;
        if (!need.ray[i] && !need.argument[i]) {
            const Value value = evaluation.stepValue(i, left);
            left -= std::min(left, evaluation.stepsTaken());
            if (value.failure == Failure::None) step = {Op::Number, 0, 0, 0, value.number};
        } else if (isChoice(step)) {
            const Step& condition = code.steps[code.operands[step.first]];
            if (condition.op == Op::Number)
                step = Step(code.steps[code.operands[step.first + (condition.number > 0 ? 1 : 2)]]);
        }
    }
}

}  // namespace luxdeck::cal

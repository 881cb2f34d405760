#include "engine/io/cal_code.h"
#include "engine/io/cal_evaluate.h"
#include "engine/io/cal_module.h"
#include "tests/fuzz/fuzz_input.h"

/// A file's "x" is evaluated for a ray: parsing, compiling, folding and running all see the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    namespace cal = luxdeck::cal;
    const auto module = cal::Module::parse(luxdeck::fuzz::text(bytes, size), "input.cal");
    luxdeck::fuzz::expectValueOrMessage(module);
    if (!module) return 0;
    static const auto entry = *cal::Module::expression("", {}, "x", "entry");
    const auto code = cal::compile({*module}, {&entry, 1}, {{1, 2, 3}, {{"S", 1.0}}, true, true});
    luxdeck::fuzz::expectValueOrMessage(code);
    if (!code) return 0;
    const cal::Inputs inputs{0.48, 0.6, -0.64, 0, 0, 1, 1, 2, 3, 4, 4, 0.64, 0.5, 0.5, 1, 1, 1};
    const auto value = cal::Evaluation(*code, inputs).value(0);
    if (value.failure != cal::Failure::None && value.number == value.number) std::abort();
    return 0;
}

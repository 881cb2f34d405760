#include "analysis/compare/compare_output.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string text(luxdeck::fuzz::text(bytes, size));
    auto comparison = luxdeck::readCompareJson(text, "input.json");
    luxdeck::fuzz::expectValueOrMessage(comparison);
    // What is read can be summed up and written, and reads as the same.
    if (!comparison) return 0;
    luxdeck::summarize(*comparison);
    static_cast<void>(luxdeck::compareText(*comparison));
    static_cast<void>(luxdeck::runsCsv(*comparison));
    static_cast<void>(luxdeck::errorsCsv(*comparison));
    if (!luxdeck::readCompareJson(luxdeck::compareJson(*comparison), "written.json")) std::abort();
    return 0;
}

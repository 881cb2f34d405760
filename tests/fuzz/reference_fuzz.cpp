#include "analysis/compare/reference.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string text(luxdeck::fuzz::text(bytes, size));
    const auto file = luxdeck::readReferenceJson(text, "input.json");
    luxdeck::fuzz::expectValueOrMessage(file);
    if (file && !luxdeck::readReferenceJson(luxdeck::referenceJson(*file), "written.json")) std::abort();
    return 0;
}

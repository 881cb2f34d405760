#include "analysis/report/report_json.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    luxdeck::fuzz::expectValueOrMessage(luxdeck::fromJson(luxdeck::fuzz::text(bytes, size)));
    return 0;
}

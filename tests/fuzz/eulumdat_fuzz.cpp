#include "engine/io/photometry.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    luxdeck::fuzz::expectValueOrMessage(luxdeck::readEulumdat(luxdeck::fuzz::text(bytes, size), "input.ldt"));
    return 0;
}

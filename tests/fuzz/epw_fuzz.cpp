#include "engine/io/epw.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto weather = luxdeck::readEpw(luxdeck::fuzz::text(bytes, size), "input.epw");
    luxdeck::fuzz::expectValueOrMessage(weather);
    if (weather) (void)weather->at(6, 21, 14);
    return 0;
}

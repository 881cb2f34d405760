#include "engine/io/wea.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto weather = luxdeck::readWea(luxdeck::fuzz::text(bytes, size), "input.wea");
    luxdeck::fuzz::expectValueOrMessage(weather);
    if (weather) (void)weather->at(6, 21, 14);
    return 0;
}

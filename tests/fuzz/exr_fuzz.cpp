#include "engine/io/image_files.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    luxdeck::fuzz::expectValueOrMessage(luxdeck::parseExr(luxdeck::fuzz::text(bytes, size), "input.exr"));
    return 0;
}

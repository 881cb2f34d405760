#include "engine/io/texture_image.h"
#include "tests/fuzz/fuzz_input.h"

/// PNG or JPEG, as its first bytes say.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    luxdeck::fuzz::expectValueOrMessage(luxdeck::decodeTexture(luxdeck::fuzz::text(bytes, size), "input"));
    return 0;
}

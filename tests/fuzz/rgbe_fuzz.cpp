#include "engine/io/image_files.h"
#include "engine/io/pattern_picture.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto input = luxdeck::fuzz::text(bytes, size);
    luxdeck::fuzz::expectValueOrMessage(luxdeck::parseRgbe(input, "input.hdr"));
    luxdeck::fuzz::expectValueOrMessage(luxdeck::PatternPicture::parse(input, "input.hdr"));
    return 0;
}

#include "engine/io/panorama_nodes.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    luxdeck::fuzz::expectValueOrMessage(luxdeck::parsePanoramaNodes(luxdeck::fuzz::text(bytes, size), "nodes.toml"));
    return 0;
}

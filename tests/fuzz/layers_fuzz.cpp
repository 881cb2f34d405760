#include "analysis/grids/layers.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string text(luxdeck::fuzz::text(bytes, size));
    const auto layers = luxdeck::readLayersJson(text, "input.json");
    luxdeck::fuzz::expectValueOrMessage(layers);
    // What is read can be used and written, and reads as the same.
    if (!layers) return 0;
    static_cast<void>(layers->combined(std::vector<double>(layers->layers.size(), 0.5)));
    if (!luxdeck::readLayersJson(luxdeck::layersJson(*layers), "written.json")) std::abort();
    return 0;
}

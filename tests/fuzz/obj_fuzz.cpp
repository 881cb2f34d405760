#include "engine/io/scene_files.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static luxdeck::fuzz::InputFolder folder;
    const auto input = luxdeck::fuzz::text(bytes, size);
    // The same bytes serve as the material file: "mtllib input.mtl" in an input reads itself.
    folder.write("input.mtl", input);
    luxdeck::fuzz::expectValueOrMessage(luxdeck::readObj(folder.write("input.obj", input), {}));
    return 0;
}

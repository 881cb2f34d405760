#include "engine/io/scene_files.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static luxdeck::fuzz::InputFolder folder;
    const auto input = luxdeck::fuzz::text(bytes, size);
    const auto path = folder.write(input.starts_with("glTF") ? "input.glb" : "input.gltf", input);
    luxdeck::fuzz::expectValueOrMessage(luxdeck::readGltf(path, {}));
    return 0;
}

#include "engine/io/rad_reader.h"
#include "engine/io/rad_view.h"
#include "tests/fuzz/fuzz_input.h"

// Arrays and generators make much of little: a scene may ask for what it likes within these bounds.
constexpr luxdeck::rad::Limits kSmall{.primitives = 2000, .triangles = 200'000, .depth = 6};

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static luxdeck::fuzz::InputFolder folder;
    const auto input = luxdeck::fuzz::text(bytes, size);
    // "input.rad" in an input reads itself, "part.rad" a part that is in order.
    folder.write("part.rad", "void plastic part 0 0 5 .5 .5 .5 0 0\npart sphere s 0 0 4 0 0 0 .1\n");
    luxdeck::fuzz::expectValueOrMessage(luxdeck::readRad({folder.write("input.rad", input)}, {}, kSmall));
    luxdeck::fuzz::expectValueOrMessage(luxdeck::parseView(input, "input.vf"));
    return 0;
}

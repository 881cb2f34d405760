#include "analysis/furniture/triangle_stream.h"
#include "tests/fuzz/fuzz_input.h"

#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static luxdeck::fuzz::InputFolder folder;
    for (const char* name : {"a.obj", "a.stl"}) {
        const auto stream = luxdeck::TriangleStream::open(folder.write(name, luxdeck::fuzz::text(bytes, size)));
        luxdeck::fuzz::expectValueOrMessage(stream);
        std::vector<luxdeck::TriangleStream::Triangle> triangles;
        do {
            if (!stream) break;
            const auto read = (*stream)->next(triangles, 16);
            luxdeck::fuzz::expectValueOrMessage(read);
            if (!read) break;
        } while (!triangles.empty());
    }
    return 0;
}

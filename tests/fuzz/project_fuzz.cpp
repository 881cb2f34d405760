#include "engine/io/project.h"
#include "tests/fuzz/fuzz_input.h"

namespace {

/// What an input may name, so that reading goes on behind the project file itself.
struct ProjectFolder : luxdeck::fuzz::InputFolder {
    ProjectFolder() {
        write("room.obj", "o floor\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3 4\n");
        write("spot.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n300 200 0\n");
        write("requirements.toml", "schema = 1\n[[requirement]]\nid = \"desk\"\nname = \"Desk\"\nmean_lux = 500\n");
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static ProjectFolder folder;
    const auto path = folder.write("project.toml", luxdeck::fuzz::text(bytes, size));
    luxdeck::fuzz::expectValueOrMessage(luxdeck::loadProject(path));
    return 0;
}

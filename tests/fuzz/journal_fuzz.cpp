#include "engine/volume/vertex_journal.h"
#include "tests/fuzz/fuzz_input.h"

#include <algorithm>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static luxdeck::fuzz::InputFolder folder;
    const auto text = luxdeck::fuzz::text(bytes, size);
    const auto& file = folder.write("input.part", text);
    // Of whatever build the first line names, so that what comes after it is read.
    constexpr std::size_t kMark = sizeof("luxdeck-volume-part/1 ") - 1;
    const auto end = std::min(text.find('\n'), text.size());
    const auto journal = luxdeck::VertexJournal::open(file, std::string(end > kMark ? text.substr(kMark, end - kMark) : text.substr(0, 0)));
    luxdeck::fuzz::expectValueOrMessage(journal);
    if (journal) static_cast<void>((*journal)->find({0, 0, 0}));
    return 0;
}

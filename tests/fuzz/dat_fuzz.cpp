#include "engine/io/pattern_data.h"
#include "tests/fuzz/fuzz_input.h"

#include <array>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto table = luxdeck::DataTable::parse(luxdeck::fuzz::text(bytes, size), "input.dat");
    luxdeck::fuzz::expectValueOrMessage(table);
    if (!table) return 0;
    for (const double x : {-1e300, -1.0, 0.0, 0.5, 45.0, 1e9}) (void)(*table)->value(std::array{x, 1.0, x, 0.3, x});
    return 0;
}

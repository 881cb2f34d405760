#include "engine/volume/field.h"
#include "engine/volume/volume_file.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    // Without the hash, which would refuse every mutation before anything is read.
    const auto volume = luxdeck::parseVolume(luxdeck::fuzz::text(bytes, size), "input.vtu", luxdeck::Checksum::Ignored);
    luxdeck::fuzz::expectValueOrMessage(volume);
    if (!volume || volume->binCount() > 200) return 0;  // moments of many bins take their time
    luxdeck::FieldSettings settings;
    settings.quadrature = luxdeck::Quadrature::Midpoint;
    const auto field = luxdeck::VolumeField::make(*volume, settings);
    if (field) static_cast<void>(field->at({0.3F, 0.2F, 1}, {0, 0, 1}));
    return 0;
}

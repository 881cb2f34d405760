#include "engine/io/project_keys.h"
#include "engine/io/project_sections.h"

namespace luxdeck::project {

namespace {

constexpr TomlChoice<SkyKind> kSkyKinds[] = {
    {"none", SkyKind::None}, {"uniform", SkyKind::Uniform}, {"cie-overcast", SkyKind::CieOvercast}};
constexpr NumberRange kZenith{.low = 0, .high = 1e6};
constexpr NumberRange kHorizontal{.low = 0, .high = 1e6};
constexpr NumberRange kGround{.low = 0, .high = 1, .highExcluded = true};

}  // namespace

Sky readSky(const TomlTable& root) {
    Sky sky;
    const auto table = root.table("sky", kSky);
    if (!table) return sky;
    if (!table->has("kind")) table->error(ErrorCode::Parse, "", "kind is missing");
    // A sky of another kind may well exist; it is not modelled here.
    sky.kind = table->choice<SkyKind>("kind", SkyKind::None, kSkyKinds, ErrorCode::Unsupported);
    sky.groundReflectance = table->number("ground_reflectance", kGround, sky.groundReflectance);
    const auto zenith = table->numberIf("zenith_cd_m2", kZenith);
    const auto horizontal = table->numberIf("horizontal_lux", kHorizontal);
    if (table->refuseBoth("zenith_cd_m2", "horizontal_lux") || sky.kind == SkyKind::None) return sky;
    if (!table->has("zenith_cd_m2") && !table->has("horizontal_lux"))
        table->error(ErrorCode::Parse, "", "zenith_cd_m2 or horizontal_lux is missing");
    sky.zenithCdM2 = 1;  // what a unit of zenith luminance gives says how much is needed
    sky.zenithCdM2 = horizontal ? *horizontal / sky.horizontalLux() : zenith.value_or(0.0);
    return sky;
}

}  // namespace luxdeck::project

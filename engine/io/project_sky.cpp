#include "engine/io/project_sky.h"

#include "engine/core/file.h"
#include "engine/io/project_keys.h"
#include "engine/io/wea.h"
#include "engine/scene/sky_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace luxdeck::project {

namespace {

constexpr TomlChoice<SkyModel> kModels[] = {
    {"none", SkyModel::None},           {"uniform", SkyModel::Uniform},
    {"cie-overcast", SkyModel::CieOvercast}, {"cie-clear", SkyModel::CieClear},
    {"cie-intermediate", SkyModel::CieIntermediate}, {"cie-general", SkyModel::CieGeneral},
    {"perez", SkyModel::Perez}};
constexpr NumberRange kZenith{.low = 0, .high = 1e6};
constexpr NumberRange kHorizontal{.low = 0, .high = 1e6};
constexpr NumberRange kGround{.low = 0, .high = 1, .highExcluded = true};
constexpr NumberRange kDirectNormal{.low = 0, .high = 1367};
constexpr NumberRange kDiffuse{.low = 0, .high = 1367, .lowExcluded = true};
constexpr std::uint64_t kMaxWeatherBytes = 256U << 20U;

/// "2024-06-21" or "06-21".
void readDate(const TomlTable& table, SkySpec& spec) {
    const auto text = table.text("date");
    if (text.empty()) return;
    std::array<int, 3> parts{spec.time.year, 0, 0};
    const bool withYear = std::count(text.begin(), text.end(), '-') == 2;
    const char* at = text.data();
    const char* const end = at + text.size();
    bool good = true;
    for (std::size_t i = withYear ? 0 : 1; i < 3 && good; ++i) {
        const auto [next, error] = std::from_chars(at, end, parts[i]);
        good = error == std::errc() && (i == 2 ? next == end : next != end && *next == '-');
        at = good && i < 2 ? next + 1 : next;
    }
    constexpr std::array<int, 12> kDays{31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    good = good && parts[0] >= 1950 && parts[0] <= 2050 && parts[1] >= 1 && parts[1] <= 12 && parts[2] >= 1 &&
           parts[2] <= kDays[static_cast<std::size_t>(parts[1] - 1)];
    if (!good)
        table.error(ErrorCode::InvalidArgument, "date", fmt::format("date is {}, expected \"YYYY-MM-DD\" with a year 1950 .. 2050, or \"MM-DD\"", inQuotes(text)));
    else
        spec.time.year = parts[0], spec.time.month = parts[1], spec.time.day = parts[2];
}

/// Where the sun stands: by angles, by place and time, or by a weather file's place and a time.
void readSunPlace(const TomlTable& table, const std::filesystem::path& folder, SkySpec& spec) {
    const bool angles = table.has("sun_altitude_deg"), weather = table.has("weather");
    table.refuseBoth("sun_altitude_deg", "weather");
    table.refuseBoth("sun_altitude_deg", "date");
    table.refuseBoth("latitude", "weather");
    if (angles) {
        spec.angles = SolarAngles{table.number("sun_altitude_deg", {.low = -90, .high = 90}) * kDegree,
                                  (table.number("sun_azimuth_deg", {.low = -360, .high = 360}) - 180) * kDegree};
        return;
    }
    if (weather) spec.weather = readFileReference(table, "weather", folder);
    if (!weather) {
        spec.site.latitudeDeg = table.number("latitude", {.low = -90, .high = 90});
        spec.site.longitudeDeg = table.number("longitude", {.low = -180, .high = 180});
        spec.site.timeZoneHours = table.number("time_zone", {.low = -14, .high = 14});
    }
    readDate(table, spec);
    spec.time.hour = table.number("hour", {.low = 0, .high = 24});
}

void readAmounts(const TomlTable& table, SkySpec& spec) {
    if (spec.model == SkyModel::Perez) {
        if (spec.weather) return;
        spec.directNormalWm2 = table.number("direct_normal_w_m2", kDirectNormal);
        spec.diffuseHorizontalWm2 = table.number("diffuse_horizontal_w_m2", kDiffuse);
        spec.dewPointC = table.numberIf("dew_point_c", {.low = -60, .high = 40});
        return;
    }
    spec.zenithCdM2 = table.numberIf("zenith_cd_m2", kZenith);
    spec.horizontalLux = table.numberIf("horizontal_lux", kHorizontal);
    spec.sunLux = table.numberIf("sun_normal_lux", {.low = 0, .high = 200'000});
    if (table.refuseBoth("zenith_cd_m2", "horizontal_lux")) return;
    if (!table.has("zenith_cd_m2") && !table.has("horizontal_lux"))
        table.error(ErrorCode::Parse, "", "zenith_cd_m2 or horizontal_lux is missing");
}

/// A key that means nothing beside the others would be a wish that is not heard.
void refuseStrayKeys(const TomlTable& table, const SkySpec& spec) {
    const bool plain = spec.model == SkyModel::Uniform || spec.model == SkyModel::CieOvercast, perez = spec.model == SkyModel::Perez;
    const auto refuse = [&](bool stray, std::initializer_list<Key> keys, const char* why) {
        for (const auto key : keys)
            if (stray && table.has(key)) table.error(ErrorCode::InvalidArgument, key, fmt::format("{} {}", key, why));
    };
    refuse(plain, {"sun_altitude_deg", "sun_azimuth_deg", "latitude", "longitude", "time_zone", "date", "hour", "weather", "sun_normal_lux"}, "is for a sky with a sun");
    refuse(!perez, {"direct_normal_w_m2", "diffuse_horizontal_w_m2", "dew_point_c"}, "is for kind = \"perez\"");
    refuse(perez, {"zenith_cd_m2", "horizontal_lux", "sun_normal_lux"}, "is not for kind = \"perez\", whose amounts are irradiances");
    refuse(perez && spec.weather, {"direct_normal_w_m2", "diffuse_horizontal_w_m2", "dew_point_c"}, "and weather exclude each other");
    refuse(spec.model != SkyModel::CieGeneral, {"type"}, "is for kind = \"cie-general\"");
}

Error atSky(const SkySpec& spec, const std::string& message) { return {ErrorCode::InvalidArgument, message, spec.where}; }

/// The chosen row of the weather file, put into the spec.
Result<void> readWeather(SkySpec& spec) {
    const auto bytes = readFile(spec.weather->path, kMaxWeatherBytes);
    if (!bytes) return inNamedFile(bytes.error(), "weather", *spec.weather);
    const auto weather = readWeatherFile(*bytes, spec.weather->shown);
    if (!weather) return inNamedFile(weather.error(), "weather", *spec.weather);
    const auto* row = weather->at(spec.time.month, spec.time.day, spec.time.hour);
    if (row == nullptr) {
        auto told = fmt::format("{} has no row for {:02}-{:02} {} h", spec.weather->shown, spec.time.month,
                                spec.time.day, spec.time.hour);
        if (const auto& undated = weather->undated; !undated.empty())
            told += fmt::format("; {} of its rows have no date that can be read, the first: {}", undated.size(),
                                undated.front().fault);
        return atSky(spec, told);
    }
    spec.site = weather->site, spec.time = row->middle;
    if (spec.model != SkyModel::Perez) return {};
    if (!row->fault.empty()) return atSky(spec, fmt::format("the hour is not known: {}", row->fault));
    if (!row->directNormalWm2 || !row->diffuseHorizontalWm2)
        return atSky(spec, fmt::format("{}:{}: the irradiances are marked as missing", spec.weather->shown, row->line));
    if (!(*row->diffuseHorizontalWm2 > 0))
        return atSky(spec, fmt::format("{}:{}: the diffuse irradiance is 0, expected an hour with daylight", spec.weather->shown, row->line));
    spec.directNormalWm2 = *row->directNormalWm2, spec.diffuseHorizontalWm2 = *row->diffuseHorizontalWm2;
    spec.dewPointC = row->dewPointC;
    return {};
}

Sky modelOf(const SkySpec& spec, const Vec3& sun) {
    switch (spec.model) {
        case SkyModel::CieClear: return cieClearSky(sun);
        case SkyModel::CieIntermediate: return cieIntermediateSky(sun);
        case SkyModel::CieGeneral: return cieGeneralSky(spec.type, sun);
        case SkyModel::Uniform: return Sky(SkyKind::Uniform, 1);
        case SkyModel::CieOvercast: return Sky(SkyKind::CieOvercast, 1);
        case SkyModel::None:
        case SkyModel::Perez: break;
    }
    return {};
}

/// Perez's sky and sun of the weather.
Sky perezOf(const SkySpec& spec, const SolarAngles& angles, const LuminanceWeights& weights) {
    PerezWeather weather;
    weather.sunZenithRad = kPiD / 2 - angles.altitudeRad;
    weather.dayOfYear = spec.angles ? 172 : dayOfYear(spec.time.month, spec.time.day);  // angles alone: the longest day
    weather.directNormalWm2 = spec.directNormalWm2, weather.diffuseHorizontalWm2 = spec.diffuseHorizontalWm2;
    weather.dewPointC = spec.dewPointC.value_or(weather.dewPointC);
    const auto parameters = perezParameters(weather);
    const auto efficacy = perezEfficacy(parameters, weather.sunZenithRad, weather.dewPointC);
    auto sky = perezSky(parameters, sunDirection(angles));
    sky.groundReflectance = spec.groundReflectance;
    const double sunLux = weather.directNormalWm2 * efficacy.direct;
    if (spec.sun && sunLux > 0) sky.suns.push_back(Sun::ofNormalLux(sunDirection(angles), sunLux));
    return scaledToHorizontal(std::move(sky), weather.diffuseHorizontalWm2 * efficacy.diffuse, weights);
}

}  // namespace

SkySpec readSky(const TomlTable& root, const std::filesystem::path& folder) {
    SkySpec spec;
    const auto table = root.table("sky", kSky);
    if (!table) return spec;
    spec.where = table->where();
    if (!table->has("kind")) table->error(ErrorCode::Parse, "", "kind is missing");
    spec.model = table->choice<SkyModel>("kind", SkyModel::None, kModels, ErrorCode::Unsupported);
    spec.groundReflectance = table->number("ground_reflectance", kGround, spec.groundReflectance);
    spec.sun = table->flag("sun", true);
    if (spec.model == SkyModel::None) return spec;
    if (spec.model == SkyModel::CieGeneral) {
        if (!table->has("type")) table->error(ErrorCode::Parse, "", "type is missing");
        spec.type = table->integer("type", 1, 15, 1);
    }
    if (spec.model != SkyModel::Uniform && spec.model != SkyModel::CieOvercast) readSunPlace(*table, folder, spec);
    readAmounts(*table, spec);
    refuseStrayKeys(*table, spec);
    return spec;
}

Result<Sky> makeSky(const SkySpec& given, const LuminanceWeights& weights) {
    SkySpec spec = given;
    if (spec.model == SkyModel::None) return Sky{};
    if (spec.weather)
        if (auto read = readWeather(spec); !read) return read.error();
    const bool plain = spec.model == SkyModel::Uniform || spec.model == SkyModel::CieOvercast;
    const auto angles = spec.angles ? *spec.angles : almanacSolarAngles(spec.time, spec.site);
    if (!plain && !(angles.altitudeRad > 0))
        return atSky(spec, fmt::format("the sun's altitude is {:.2f} degrees, expected it above the horizon", angles.altitudeRad / kDegree));
    if (spec.model == SkyModel::Perez) return perezOf(spec, angles, weights);

    auto sky = modelOf(spec, sunDirection(angles));
    sky.groundReflectance = spec.groundReflectance;
    const double lux = spec.horizontalLux ? *spec.horizontalLux : spec.zenithCdM2.value_or(0) * sky.horizontalLux();
    if (plain) {  // the ground's luminance follows from the sky's
        sky.zenithCdM2 = lux / sky.horizontalLux();
        return sky;
    }
    if (spec.sun && spec.sunLux && *spec.sunLux > 0) sky.suns.push_back(Sun::ofNormalLux(sunDirection(angles), *spec.sunLux));
    return scaledToHorizontal(std::move(sky), lux, weights);
}

Result<void> placeSky(Scene& scene, const SkySpec& spec) {
    auto sky = makeSky(spec, scene.weights);
    if (!sky) return sky.error();
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(sky->domes, scene.sky.domes);
    append(sky->suns, scene.sky.suns);
    scene.sky = *std::move(sky);
    return {};
}

}  // namespace luxdeck::project

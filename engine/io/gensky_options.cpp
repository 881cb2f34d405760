#include "engine/io/gensky_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace luxdeck::gensky {

namespace {

/// Time zones that gensky knows, by their meridian [degrees west]; of two of one name the first is meant.
constexpr std::pair<std::string_view, double> kZones[] = {
    {"YST", 135}, {"YDT", 120}, {"PST", 120},  {"PDT", 105},  {"MST", 105},   {"MDT", 90},   {"CST", 90},   {"CDT", 75},
    {"EST", 75},  {"EDT", 60},  {"AST", 60},   {"ADT", 45},   {"NST", 52.5},  {"NDT", 37.5}, {"GMT", 0},    {"BST", -15},
    {"CET", -15}, {"CEST", -30}, {"EET", -30}, {"EEST", -45}, {"GST", -60},   {"GDT", -75},  {"IST", -82.5}, {"IDT", -97.5},
    {"JST", -135}, {"NZST", -180}, {"NZDT", -195}};

/// Reads the words from left to right.
class Reader {
public:
    Reader(std::string program, std::span<const std::string> words) : program_(std::move(program)), words_(words) {}

    Result<Options> read() {
        if (words_.size() < 3) return wrong("has too few arguments, expected month, day and hour, or -ang, altitude and azimuth");
        if (auto ok = readMoment(); !ok) return ok.error();
        while (at_ < words_.size())
            if (auto ok = readOption(); !ok) return ok.error();
        const bool perez = program_ == "gendaylit";
        if (perez && options_.input == PerezInput::None) return wrong("has no weather, expected -P, -W, -L or -G with two values");
        return options_;
    }

private:
    [[nodiscard]] Error wrong(const std::string& message, ErrorCode code = ErrorCode::InvalidArgument) const {
        return {code, program_ + " " + message, ""};
    }

    Result<double> number(const std::string& option, double low, double high) {
        if (at_ >= words_.size()) return wrong(fmt::format("{} has no value, expected a number", option));
        const auto& text = words_[at_++];
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (text.empty() || *end != '\0' || !(value >= low && value <= high))
            return wrong(fmt::format("{} is '{}', expected a number {} .. {}", option, text, low, high));
        return value;
    }

    Result<void> assign(const std::string& option, double low, double high, double& to, double unit = 1) {
        const auto value = number(option, low, high);
        if (!value) return value.error();
        to = *value * unit;
        return {};
    }
    Result<void> assign(const std::string& option, double low, double high, std::optional<double>& to) {
        const auto value = number(option, low, high);
        if (!value) return value.error();
        to = *value;
        return {};
    }

    Result<void> readMoment() {
        if (words_[0] == "-ang") {
            ++at_;
            SolarAngles angles;
            if (auto ok = assign("altitude", -90, 90, angles.altitudeRad, kDegree); !ok) return ok;
            if (auto ok = assign("azimuth", -360, 360, angles.azimuthRad, kDegree); !ok) return ok;
            options_.angles = angles;
            return {};
        }
        double month = 0, day = 0;
        if (auto ok = assign("month", 1, 12, month); !ok) return ok;
        if (auto ok = assign("day", 1, 31, day); !ok) return ok;
        options_.month = static_cast<int>(month), options_.day = static_cast<int>(day);
        return readHour(words_[at_++]);
    }

    /// "14", "14.5", "14:30", "+14" (solar), "14EST", "14:30CET".
    Result<void> readHour(const std::string& text) {
        const auto bad = [&] { return wrong(fmt::format("hour is '{}', expected 0 .. 24 as 14, 14.5 or 14:30, with + before it or a time zone behind", text)); };
        options_.solarTime = text.starts_with('+');
        const auto start = options_.solarTime ? 1U : 0U;
        const auto end = std::find_if(text.begin() + start, text.end(), [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
        const std::string clock(text.begin() + start, end);
        std::string zone(end, text.end());
        if (clock.empty() || clock.find_first_not_of("0123456789.:") != std::string::npos) return bad();
        const auto colon = clock.find(':');
        char* rest = nullptr;
        options_.hour = std::strtod(clock.c_str(), &rest);
        if (colon != std::string::npos) {
            if (rest != clock.c_str() + colon) return bad();
            const char* minutes = rest + 1;
            options_.hour += std::strtod(minutes, &rest) / 60;
        }
        if (*rest != '\0' || !(options_.hour >= 0 && options_.hour <= 24)) return bad();
        if (zone.empty()) return {};
        if (options_.solarTime) return bad();
        std::transform(zone.begin(), zone.end(), zone.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        for (const auto& [name, meridian] : kZones)
            if (name == zone) {
                options_.meridianRad = meridian * kDegree;
                zoned_ = true;
                return {};
            }
        return wrong(fmt::format("hour is '{}' in an unknown time zone, expected one as EST, GMT or CET", text));
    }

    Result<void> readOption() {
        const auto option = words_[at_++];
        if (option.size() < 2 || (option[0] != '-' && option[0] != '+'))
            return wrong(fmt::format("has '{}', expected an option", option));
        if (option.size() == 2) {
            if (const auto ok = readPlace(option); !ok || known_) return ok;
            return program_ == "gendaylit" ? readPerez(option) : readSky(option);
        }
        return wrong(fmt::format("has the unknown option '{}'", option));
    }

    /// The options that both programs have.
    Result<void> readPlace(const std::string& option) {
        known_ = true;
        switch (option[1]) {
            case 'g': return assign(option, 0, 1, options_.groundReflectance);
            case 'a': return assign(option, -90, 90, options_.latitudeRad, kDegree);
            case 'o': return assign(option, -360, 360, options_.longitudeRad, kDegree);
            case 'm': {
                double meridian = 0;
                auto ok = assign(option, -360, 360, meridian, kDegree);
                if (ok && !zoned_) options_.meridianRad = meridian;  // a time zone behind the hour is the stronger
                return ok;
            }
            case 'y': {
                double year = 0;
                auto ok = assign(option, 1950, 2050, year);
                if (ok) options_.year = static_cast<int>(year);
                return ok;
            }
            case 's':
                options_.kind = Kind::Clear;
                options_.sun = option[0] == '+';
                return {};
            default: known_ = false; return {};
        }
    }

    Result<void> readSky(const std::string& option) {
        switch (option[1]) {
            case 'c': options_.kind = Kind::Overcast; return {};
            case 'u': options_.kind = Kind::Uniform; return {};
            case 'i':
                options_.kind = Kind::Intermediate;
                options_.sun = option[0] == '+';
                return {};
            case 't': return assign(option, 0, 100, options_.turbidity);
            case 'b': options_.horizontalIrradiance.reset(); return assign(option, 0, 1e9, options_.zenithRadiance);
            case 'B': options_.zenithRadiance.reset(); return assign(option, 0, 1e9, options_.horizontalIrradiance);
            case 'r': options_.solarIrradiance.reset(); return assign(option, 0, 1e12, options_.solarRadiance);
            case 'R': options_.solarRadiance.reset(); return assign(option, 0, 1e9, options_.solarIrradiance);
            default: return wrong(fmt::format("has the unknown option '{}'", option));
        }
    }

    Result<void> readPerez(const std::string& option) {
        const auto take = [&](PerezInput input, double lowFirst, double highFirst, double lowSecond, double highSecond) -> Result<void> {
            options_.input = input;
            if (auto ok = assign(option + "'s first value", lowFirst, highFirst, options_.direct); !ok) return ok;
            return assign(option + "'s second value", lowSecond, highSecond, options_.diffuse);
        };
        switch (option[1]) {
            case 'P': return take(PerezInput::Parameters, 1, 12.0099, 0.01, 0.6);
            case 'W': return take(PerezInput::Normal, 0, 1367, 0, 1367);
            case 'G': return take(PerezInput::Horizontal, 0, 1367, 0, 1367);
            case 'L': return take(PerezInput::Lux, 0, 127500, 0, 127500);
            case 'O': {
                double output = 0;
                auto ok = assign(option, 0, 2, output);
                options_.output = static_cast<int>(output);
                return ok;
            }
            case 'w': return {};  // about its warnings alone
            default: return wrong(fmt::format("has the option '{}', which is not read; expected -P -W -L -G -O -g -a -o -m -y -s -w", option), ErrorCode::Unsupported);
        }
    }

    std::string program_;
    std::span<const std::string> words_;
    std::size_t at_ = 0;
    Options options_;
    bool zoned_ = false;
    bool known_ = false;
};

}  // namespace

Result<Options> readOptions(const std::string& program, std::span<const std::string> words) { return Reader(program, words).read(); }

SolarAngles solarAngles(const Options& o) {
    if (o.year && !o.solarTime) {
        const Site site{o.latitudeRad / kDegree, -o.longitudeRad / kDegree, -o.meridianRad / kDegree / 15};
        return almanacSolarAngles({*o.year, o.month, o.day, o.hour}, site);
    }
    const int day = dayOfYear(o.month, o.day);
    const double hour = o.solarTime ? o.hour : o.hour + solarTimeAdjustment(day, o.longitudeRad, o.meridianRad);
    return simpleSolarAngles(day, hour, o.latitudeRad);
}

}  // namespace luxdeck::gensky

#include "engine/io/wea.h"

#include "engine/io/photometry_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace luxdeck {

namespace {

using photometry::inQuotes;
using photometry::parseNumber;
using photometry::trim;

constexpr std::size_t kMostRows = 527'040;  // a leap year by the minute

Error wrong(const std::string& name, std::size_t line, std::string message) {
    return {ErrorCode::Parse, std::move(message), fmt::format("{}:{}", name, line)};
}

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::string_view kBlanks = " \t";
    while (true) {
        const auto begin = line.find_first_not_of(kBlanks);
        if (begin == std::string_view::npos) return words;
        line.remove_prefix(begin);
        const auto end = std::min(line.find_first_of(kBlanks), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

struct HeaderKey {
    std::string_view name;
    double low, high;
};
constexpr std::array<HeaderKey, 5> kHeader{{{"latitude", -90, 90}, {"longitude", -180, 180}, {"time_zone", -210, 210},
                                            {"site_elevation", -1000, 10000}, {"weather_data_file_units", 1, 1}}};

/// The line "place NAME" and five of one number each; values[i] becomes kHeader[i]'s.
Result<Weather> readHeader(const std::vector<std::string_view>& lines, const std::string& name) {
    if (lines.size() < kHeader.size() + 1) return wrong(name, lines.size(), "ends within the header, expected six lines");
    Weather weather;
    if (!trim(lines[0]).starts_with("place")) return wrong(name, 1, fmt::format("is {}, expected place and its name", inQuotes(lines[0])));
    weather.place = std::string(trim(trim(lines[0]).substr(5)));
    std::array<double, kHeader.size()> values{};
    for (std::size_t i = 0; i < kHeader.size(); ++i) {
        const auto words = wordsOf(lines[i + 1]);
        const auto& key = kHeader[i];
        const auto value = words.size() == 2 && words[0] == key.name ? parseNumber(words[1]) : std::nullopt;
        if (!value || !(*value >= key.low && *value <= key.high))
            return wrong(name, i + 2, fmt::format("is {}, expected {} and a number {} .. {}", inQuotes(lines[i + 1]), key.name, key.low, key.high));
        values[i] = *value;
    }
    weather.site = {values[0], -values[1], -values[2] / 15};
    return weather;
}

Result<WeatherRow> readRow(std::string_view text, std::size_t line, const std::string& name) {
    constexpr std::array<std::pair<double, double>, 5> kRanges{{{1, 12}, {1, 31}, {0, 24}, {0, 9999}, {0, 9999}}};
    const auto words = wordsOf(text);
    std::array<double, 5> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = i < words.size() ? parseNumber(words[i]) : std::nullopt;
        if (!value || !(*value >= kRanges[i].first && *value <= kRanges[i].second) || words.size() != values.size())
            return wrong(name, line, fmt::format("is {}, expected month, day, hour, direct normal and diffuse horizontal irradiance", inQuotes(text)));
        values[i] = *value;
    }
    WeatherRow row;
    row.middle = {ClockTime{}.year, static_cast<int>(values[0]), static_cast<int>(values[1]), values[2]};
    row.directNormalWm2 = values[3], row.diffuseHorizontalWm2 = values[4];
    row.line = line;
    return row;
}

}  // namespace

Result<Weather> readWea(std::string_view bytes, const std::string& name) {
    const auto lines = photometry::splitLines(bytes);
    auto weather = readHeader(lines, name);
    if (!weather) return weather;
    for (std::size_t i = kHeader.size() + 1; i < lines.size(); ++i) {
        if (trim(lines[i]).empty()) continue;
        if (weather->rows.size() == kMostRows) return wrong(name, i + 1, fmt::format("has more than {} rows, expected a year", kMostRows));
        const auto row = readRow(lines[i], i + 1, name);
        if (!row) return row.error();
        weather->rows.push_back(*row);
    }
    if (weather->rows.empty()) return wrong(name, lines.size(), "ends, expected rows");
    auto& rows = weather->rows;
    if (rows.size() > 1) {  // the file does not say how long its intervals are
        const double step = std::abs(rows[1].middle.hour - rows[0].middle.hour);
        if (step > 0 && step < 1)
            for (auto& row : rows) row.intervalHours = step;
    }
    return weather;
}

}  // namespace luxdeck

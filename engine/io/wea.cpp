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

constexpr std::size_t kMostRows = 527'040;    // a leap year by the minute
constexpr std::size_t kUndatedAtFirst = 100;  // so many rows that are none, and the file is none
constexpr double kLatestHour = 24.5;          // the middle of the last interval, where hours count from 0.5

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

/// The day after; without leap years, which a WEA file knows nothing of.
void nextDay(ClockTime& time) {
    constexpr std::array<int, 12> kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (time.day < kDays[static_cast<std::size_t>(time.month - 1)]) {
        ++time.day;
        return;
    }
    time.day = 1;
    time.month = time.month % 12 + 1;
}

/// One number of a row, or what is wrong with it.
Result<double> field(const std::vector<std::string_view>& words, std::size_t i, const std::string& where) {
    struct Range {
        const char* what;
        double low, high;
    };
    constexpr std::array<Range, 5> kRanges{{{"the month", 1, 12}, {"the day", 1, 31}, {"the hour", 0, kLatestHour},
                                            {"the direct normal irradiance", 0, 9999},
                                            {"the diffuse horizontal irradiance", 0, 9999}}};
    const auto& range = kRanges[i];
    const auto text = i < words.size() ? words[i] : std::string_view{};
    const auto value = parseNumber(text);
    if (value && *value >= range.low && *value <= range.high) return *value;
    return Error{ErrorCode::Parse, fmt::format("field {} is {}, expected {}: {} .. {}", i + 1, inQuotes(text),
                                               range.what, range.low, range.high), where};
}

/// The date and time of a row; the irradiances, or why there are none. Daysim names the intervals of ten minutes that
/// end a day 24.083 .. 24.417: they are the first of the next one.
Result<WeatherRow> readRow(std::string_view text, std::size_t line, const std::string& name) {
    const auto words = wordsOf(text);
    const auto where = fmt::format("{}:{}", name, line);
    std::array<double, 5> values{};
    WeatherRow row;
    row.line = line;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = field(words, i, where);
        if (value) values[i] = *value;
        else if (i < 3) return value.error();
        else if (row.fault.empty()) row.fault = value.error().text();
    }
    if (words.size() > values.size() && row.fault.empty())
        row.fault = fmt::format("{}: has {} fields, expected month, day, hour, direct normal and diffuse horizontal "
                                "irradiance", where, words.size());
    row.middle = {ClockTime{}.year, static_cast<int>(values[0]), static_cast<int>(values[1]), values[2]};
    if (values[2] > 24) {
        row.middle.hour -= 24;
        nextDay(row.middle);
    }
    if (row.fault.empty()) row.directNormalWm2 = values[3], row.diffuseHorizontalWm2 = values[4];
    return row;
}

/// The file does not say how long its intervals are: the commonest step between rows of one day, in whole minutes.
double intervalOf(const std::vector<WeatherRow>& rows) {
    std::array<std::size_t, 61> counts{};
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double minutes = 60 * (rows[i].middle.hour - rows[i - 1].middle.hour);
        if (minutes > 0.5 && minutes < 60.5) ++counts[static_cast<std::size_t>(std::lround(minutes))];
    }
    const auto most = std::max_element(counts.begin(), counts.end());
    return *most == 0 ? 1.0 : static_cast<double>(most - counts.begin()) / 60;
}

}  // namespace

Result<Weather> readWeatherFile(std::string_view bytes, const std::string& name) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    auto start = bytes.substr(bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
    start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
    if (start.starts_with("LOCATION")) return readEpw(bytes, name);
    if (start.starts_with("place")) return readWea(bytes, name);
    return wrong(name, 1, fmt::format("begins with {}, expected LOCATION (an EPW file) or place (a WEA file)",
                                      inQuotes(start.substr(0, start.find_first_of("\r\n")))));
}

Result<Weather> readWea(std::string_view bytes, const std::string& name) {
    std::vector<std::string> repairs;
    if (trim(bytes).empty()) return wrong(name, 1, "the file is empty, expected weather");
    const auto text = photometry::decodeText(bytes, name, repairs);
    if (!text) return text.error();
    const auto lines = photometry::splitLines(*text);
    auto weather = readHeader(lines, name);
    if (!weather) return weather;
    for (std::size_t i = kHeader.size() + 1; i < lines.size(); ++i) {
        if (trim(lines[i]).empty()) continue;
        if (weather->rows.size() + weather->undated.size() == kMostRows)
            return wrong(name, i + 1, fmt::format("has more than {} rows, expected a year", kMostRows));
        auto row = readRow(lines[i], i + 1, name);
        if (row) weather->rows.push_back(*std::move(row));
        else if (weather->rows.empty() && weather->undated.size() == kUndatedAtFirst) return row.error();
        else weather->undated.push_back({i + 1, row.error().text()});
    }
    if (weather->rows.empty() && !weather->undated.empty())
        return Error{ErrorCode::Parse, "no row has a date and an hour: " + weather->undated.front().fault, name};
    if (weather->rows.empty()) return wrong(name, lines.size(), "ends, expected rows");
    const double interval = intervalOf(weather->rows);
    for (auto& row : weather->rows) row.intervalHours = interval;
    return weather;
}

}  // namespace luxdeck

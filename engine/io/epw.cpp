#include "engine/io/epw.h"

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

constexpr std::size_t kHeaderLines = 8;
constexpr std::size_t kMostRows = 527'040;  // a leap year by the minute
constexpr std::size_t kUndatedAtFirst = 100;  // so many rows that are none, and the file is none
constexpr double kMissing = 9999;           // how an irradiance that was not measured is written
/// Hours are written with two or three digits: ten minutes are 0.167 h, and intervals fail to meet by a few seconds.
constexpr double kRoundingHours = 0.006;

Error wrong(const std::string& name, std::size_t line, std::string message) {
    return {ErrorCode::Parse, std::move(message), fmt::format("{}:{}", name, line)};
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
    std::vector<std::string_view> fields;
    while (true) {
        const auto comma = line.find(',');
        fields.push_back(trim(line.substr(0, comma)));
        if (comma == std::string_view::npos) return fields;
        line.remove_prefix(comma + 1);
    }
}

/// The numbers of one line, by field from 1, as EPW's documentation counts them.
class Fields {
public:
    Fields(const std::string& name, std::size_t line, std::string_view text) : name_(name), line_(line), fields_(fieldsOf(text)) {}

    [[nodiscard]] std::size_t count() const { return fields_.size(); }
    [[nodiscard]] std::string_view text(std::size_t field) const { return field <= fields_.size() ? fields_[field - 1] : std::string_view{}; }
    Result<double> number(std::size_t field, const char* what, double low, double high) const {
        const auto value = parseNumber(text(field));
        if (!value || !(*value >= low && *value <= high))
            return wrong(name_, line_, fmt::format("field {} is {}, expected {}: {} .. {}", field, inQuotes(text(field)), what, low, high));
        return *value;
    }

private:
    const std::string& name_;
    std::size_t line_;
    std::vector<std::string_view> fields_;
};

Result<Weather> readLocation(const std::string& name, std::string_view line) {
    const Fields fields(name, 1, line);
    if (fields.text(1) != "LOCATION") return wrong(name, 1, fmt::format("begins with {}, expected LOCATION", inQuotes(fields.text(1))));
    const auto latitude = fields.number(7, "the latitude", -90, 90), longitude = fields.number(8, "the longitude, east positive", -180, 180);
    const auto zone = fields.number(9, "the time zone in hours", -14, 14);
    for (const auto* value : {&latitude, &longitude, &zone})
        if (!*value) return value->error();
    Weather weather;
    weather.place = std::string(fields.text(2));
    weather.site = {*latitude, *longitude, *zone};
    return weather;
}

/// How many rows there are to the hour.
Result<int> readPeriods(const std::string& name, std::string_view line) {
    const Fields fields(name, kHeaderLines, line);
    if (fields.text(1) != "DATA PERIODS") return wrong(name, kHeaderLines, fmt::format("begins with {}, expected DATA PERIODS", inQuotes(fields.text(1))));
    const auto perHour = fields.number(3, "the rows of an hour", 1, 60);
    if (!perHour) return perHour.error();
    return static_cast<int>(*perHour);
}

/// The date and time of a row; the irradiances, or why there are none.
Result<WeatherRow> readRow(const Fields& fields, std::size_t line, int perHour) {
    const auto year = fields.number(1, "the year", 0, 9999), month = fields.number(2, "the month", 1, 12);
    const auto day = fields.number(3, "the day", 1, 31), hour = fields.number(4, "the hour", 1, 24);
    for (const auto* value : {&month, &day, &hour})
        if (!*value) return value->error();
    const auto minute = fields.number(5, "the minute", 0, 60);
    if (!minute && perHour > 1) return minute.error();  // else it is 0 or 60, as the writing program liked it
    WeatherRow row;
    row.line = line;
    row.intervalHours = 1.0 / perHour;
    const double end = perHour == 1 ? *hour : *hour - 1 + (*minute == 0 ? 60 : *minute) / 60;
    const int clockYear = year ? std::clamp(static_cast<int>(*year), 1950, 2050) : ClockTime{}.year;
    row.middle = {clockYear, static_cast<int>(*month), static_cast<int>(*day), end - row.intervalHours / 2};
    const auto direct = fields.number(15, "the direct normal irradiance", 0, kMissing);
    const auto diffuse = fields.number(16, "the diffuse horizontal irradiance", 0, kMissing);
    for (const auto* value : {&direct, &diffuse})
        if (!*value && row.fault.empty()) row.fault = value->error().text();
    if (direct && *direct < kMissing) row.directNormalWm2 = *direct;
    if (diffuse && *diffuse < kMissing) row.diffuseHorizontalWm2 = *diffuse;
    if (const auto dew = parseNumber(fields.text(8)); dew && *dew < 99.9 && *dew > -90) row.dewPointC = *dew;
    return row;
}

}  // namespace

const WeatherRow* Weather::at(int month, int day, double hour) const {
    for (const double slack : {1e-9, kRoundingHours})
        for (const auto& row : rows) {
            if (row.middle.month != month || row.middle.day != day) continue;
            const double half = row.intervalHours / 2, from = row.middle.hour - half, to = row.middle.hour + half;
            const bool begun = slack > 1e-9 ? hour > from - slack : hour > from + 1e-9;
            if (hour <= to + slack && (begun || from <= 1e-9)) return &row;
        }
    return nullptr;
}

Result<Weather> readEpw(std::string_view bytes, const std::string& name) {
    std::vector<std::string> repairs;
    if (trim(bytes).empty()) return wrong(name, 1, "the file is empty, expected weather");
    const auto text = photometry::decodeText(bytes, name, repairs);
    if (!text) return text.error();
    const auto lines = photometry::splitLines(*text);
    if (lines.size() <= kHeaderLines)
        return wrong(name, lines.size(), fmt::format("ends, expected {} lines of header and then rows", kHeaderLines));
    auto weather = readLocation(name, lines[0]);
    if (!weather) return weather;
    const auto perHour = readPeriods(name, lines[kHeaderLines - 1]);
    if (!perHour) return perHour.error();
    for (std::size_t i = kHeaderLines; i < lines.size(); ++i) {
        if (trim(lines[i]).empty()) continue;
        if (weather->rows.size() + weather->undated.size() == kMostRows)
            return wrong(name, i + 1, fmt::format("has more than {} rows, expected a year", kMostRows));
        auto row = readRow(Fields(name, i + 1, lines[i]), i + 1, *perHour);
        if (row) weather->rows.push_back(*std::move(row));
        else if (weather->rows.empty() && weather->undated.size() == kUndatedAtFirst) return row.error();
        else weather->undated.push_back({i + 1, row.error().text()});
    }
    if (!weather->rows.empty()) return weather;
    if (weather->undated.empty()) return wrong(name, lines.size(), "ends, expected rows");
    return Error{ErrorCode::Parse, "no row has a date and an hour: " + weather->undated.front().fault, name};
}

}  // namespace luxdeck

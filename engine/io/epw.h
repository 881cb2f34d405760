#pragma once

#include "engine/core/result.h"
#include "engine/scene/sun_position.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// One interval of weather.
struct WeatherRow {
    ClockTime middle;                     ///< of the interval, by the site's clock
    double intervalHours = 1;
    std::optional<double> directNormalWm2;      ///< mean over the interval; none: marked as missing
    std::optional<double> diffuseHorizontalWm2;
    std::optional<double> dewPointC;
    std::size_t line = 0;                 ///< of the file, from 1
    std::string fault;                    ///< why its irradiances are not known, as an error says it; else empty
};

/// A row that does not say which interval it is of.
struct UndatedRow {
    std::size_t line = 0;
    std::string fault;
};

/// The weather of a place.
struct Weather {
    std::string place;
    Site site;
    std::vector<WeatherRow> rows;
    std::vector<UndatedRow> undated;

    /// The row whose interval holds a date and time; none where no row does. An hour that is the border of two
    /// belongs to the earlier: EPW calls an interval by its end.
    /// Hours in files are rounded: within seconds of a row's interval is in it, where no other row holds the time.
    [[nodiscard]] const WeatherRow* at(int month, int day, double hour) const;
};

/// Reads an EnergyPlus weather file. Its rows are named by the end of their interval, longitude and time zone count
/// eastwards. A field that cannot be read costs the hours of its row alone: WeatherRow::fault, Weather::undated.
///
/// name    of the file, for messages
/// errors  Parse: file:line, what was seen, what was expected: in the header, or in the first row where none has a date
Result<Weather> readEpw(std::string_view bytes, const std::string& name);

}  // namespace luxdeck

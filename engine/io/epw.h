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
};

/// The weather of a place.
struct Weather {
    std::string place;
    Site site;
    std::vector<WeatherRow> rows;

    /// The row whose interval holds a date and time; none where no row does. An hour that is the border of two
    /// belongs to the earlier: EPW calls an interval by its end.
    [[nodiscard]] const WeatherRow* at(int month, int day, double hour) const;
};

/// Reads an EnergyPlus weather file. Its rows are named by the end of their interval, longitude and time zone count
/// eastwards.
///
/// name    of the file, for messages
/// errors  Parse: file:line, what was seen, what was expected
Result<Weather> readEpw(std::string_view bytes, const std::string& name);

}  // namespace luxdeck

#pragma once

#include "engine/core/vec.h"

namespace luxdeck {

/// A place on Earth and its clock.
struct Site {
    double latitudeDeg = 0;       ///< north positive
    double longitudeDeg = 0;      ///< east positive, as EPW has it; Radiance and WEA are west positive
    double timeZoneHours = 0;     ///< of the clock, east of Greenwich positive
};

/// A moment by the clock of a site.
struct ClockTime {
    int year = 2023;              ///< 1950 .. 2050
    int month = 1;                ///< 1 .. 12
    int day = 1;                  ///< 1 .. 31
    double hour = 12;             ///< of standard time; may lie outside 0 .. 24
};

/// Day of the year without leap days, 1 .. 365.
int dayOfYear(int month, int day);

/// Solar altitude and azimuth as Radiance's sun.c has them: no year, half a degree at worst.
struct SolarAngles {
    double altitudeRad = 0;
    double azimuthRad = 0;        ///< from the south, west positive
};
SolarAngles simpleSolarAngles(int day, double solarHour, double latitudeRad);
/// What to add to the clock to have solar time [h]; longitude and meridian west positive [rad].
double solarTimeAdjustment(int day, double longitudeWestRad, double meridianWestRad);

/// Unit vector towards the sun: x east, y north, z up.
Vec3 sunDirection(const SolarAngles& angles);
Vec3d sunDirectionExact(const SolarAngles& angles);

/// The sun's place by the Astronomical Almanac's short formulas, good to 0.01 degrees from 1950 to 2050; refraction
/// left out. Source: Michalsky 1988.
SolarAngles almanacSolarAngles(const ClockTime& time, const Site& site);

}  // namespace luxdeck

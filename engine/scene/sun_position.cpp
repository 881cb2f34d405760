#include "engine/scene/sun_position.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck {

int dayOfYear(int month, int day) {
    constexpr std::array<int, 12> kBefore{0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};
    return kBefore.at(static_cast<std::size_t>(month - 1)) + day;
}

double solarTimeAdjustment(int day, double longitudeWestRad, double meridianWestRad) {
    return 0.170 * std::sin(4 * kPiD / 373 * (day - 80)) - 0.129 * std::sin(2 * kPiD / 355 * (day - 8)) +
           12 * (meridianWestRad - longitudeWestRad) / kPiD;
}

namespace {

SolarAngles anglesOf(double declination, double hourAngleFromMidnight, double latitude) {
    const double sd = std::sin(declination), cd = std::cos(declination);
    const double sl = std::sin(latitude), cl = std::cos(latitude), ct = std::cos(hourAngleFromMidnight);
    return {std::asin(std::clamp(sl * sd - cl * cd * ct, -1.0, 1.0)),
            -std::atan2(cd * std::sin(hourAngleFromMidnight), -cl * sd - sl * cd * ct)};
}

/// Days since noon of 1 January 2000, of midnight of a date of the Gregorian calendar.
double daysSince2000(int year, int month, int day) {
    const int shifted = (month + 9) % 12, y = year - (month <= 2 ? 1 : 0);  // years from March: the leap day is last
    const long days = 365L * y + y / 4 - y / 100 + y / 400 + (shifted * 306 + 5) / 10 + day - 1;
    return static_cast<double>(days - 730425) - 0.5;  // 730425: the same count of 1 January 2000
}

}  // namespace

SolarAngles simpleSolarAngles(int day, double solarHour, double latitudeRad) {
    const double declination = 0.4093 * std::sin(2 * kPiD / 365 * (day - 81));
    return anglesOf(declination, solarHour * kPiD / 12, latitudeRad);
}

SolarAngles almanacSolarAngles(const ClockTime& time, const Site& site) {
    const double utc = time.hour - site.timeZoneHours;
    const double n = daysSince2000(time.year, time.month, time.day) + utc / 24;
    const double meanLongitude = (280.460 + 0.9856474 * n) * kDegree, g = (357.528 + 0.9856003 * n) * kDegree;
    const double longitude = meanLongitude + (1.915 * std::sin(g) + 0.020 * std::sin(2 * g)) * kDegree;
    const double obliquity = (23.439 - 4e-7 * n) * kDegree;
    const double declination = std::asin(std::sin(obliquity) * std::sin(longitude));
    const double ascension = std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude));
    const double siderealHours = 6.697375 + 0.0657098242 * n + utc;
    const double hourAngle = (siderealHours * 15 + site.longitudeDeg) * kDegree - ascension;
    return anglesOf(declination, hourAngle + kPiD, site.latitudeDeg * kDegree);
}

Vec3d sunDirectionExact(const SolarAngles& a) {
    const double c = std::cos(a.altitudeRad);
    return {-std::sin(a.azimuthRad) * c, -std::cos(a.azimuthRad) * c, std::sin(a.altitudeRad)};
}

Vec3 sunDirection(const SolarAngles& angles) { return Vec3(sunDirectionExact(angles)); }

}  // namespace luxdeck

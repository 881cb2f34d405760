#include "engine/scene/sun_position.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luxdeck::test {
namespace {

double degrees(double rad) { return rad / kDegree; }

TEST(SunPosition, NoonAltitudesAreThoseOfTheDeclination) {
    // At solar noon the sun stands 90 - latitude + declination high, due south. The declination of the equinox's day
    // 81 is 0 and of the solstice 23.45 degrees, to the 0.4 degrees of the simple formula.
    for (const double latitude : {30.0, 50.0}) {
        const auto equinox = simpleSolarAngles(81, 12, latitude * kDegree), solstice = simpleSolarAngles(172, 12, latitude * kDegree);
        EXPECT_NEAR(degrees(equinox.altitudeRad), 90 - latitude, 1e-9);
        EXPECT_NEAR(degrees(solstice.altitudeRad), 90 - latitude + 23.45, 0.4);
        EXPECT_NEAR(degrees(equinox.azimuthRad), 0, 1e-9);
    }
}

TEST(SunPosition, EquinoxRisesInTheEastAndSetsInTheWest) {
    const auto morning = sunDirection(simpleSolarAngles(81, 6, 0.7)), evening = sunDirection(simpleSolarAngles(81, 18, 0.7));
    EXPECT_NEAR(morning.x, 1, 1e-6);
    EXPECT_NEAR(morning.z, 0, 1e-6);
    EXPECT_NEAR(evening.x, -1, 1e-6);
}

TEST(SunPosition, AlmanacOfDatesThatAreKnown) {
    // Solstice of 2024: 20 June 20:51 UT, declination 23.436; equinox: 20 March 03:06 UT, declination 0. The formulas
    // are good to 0.01 degrees. At the pole altitude is declination.
    const Site pole{90, 0, 0};
    EXPECT_NEAR(degrees(almanacSolarAngles({2024, 6, 20, 20.85}, pole).altitudeRad), 23.436, 0.01);
    EXPECT_NEAR(degrees(almanacSolarAngles({2024, 3, 20, 3.1}, pole).altitudeRad), 0, 0.01);
    EXPECT_NEAR(degrees(almanacSolarAngles({2024, 12, 21, 9.35}, pole).altitudeRad), -23.436, 0.01);
    // NREL's SPA report (Reda & Andreas 2004): 17 October 2003, 12:30:30 at UTC-7, 39.742476 N 105.1786 W: topocentric
    // zenith 50.11162 with refraction and parallax (0.014 together), azimuth 194.34024 from north.
    const auto a = almanacSolarAngles({2003, 10, 17, 12 + 30.5 / 60}, {39.742476, -105.1786, -7});
    EXPECT_NEAR(degrees(a.altitudeRad), 90 - 50.11162, 0.03);
    EXPECT_NEAR(degrees(a.azimuthRad), 14.34024, 0.02);
}

TEST(SunPosition, SimpleAgreesWithAlmanac) {
    for (const int month : {1, 4, 7, 10})
        for (const double hour : {9.0, 12.0, 15.0}) {
            const Site site{45, 10, 1};
            const int day = dayOfYear(month, 15);
            const auto simple = simpleSolarAngles(day, hour + solarTimeAdjustment(day, -10 * kDegree, -15 * kDegree), 45 * kDegree);
            const auto exact = almanacSolarAngles({2023, month, 15, hour}, site);
            const auto apart = std::acos(sunDirectionExact(simple).dot(sunDirectionExact(exact)));
            // The simple declination is a sine about day 81: in autumn, whose equinox comes 3 days later than that, it is off by
            // up to 3 times 0.4 degrees.
            EXPECT_LT(degrees(apart), 1.2) << month << " " << hour;
        }
}

TEST(SunPosition, EastIsEarlier) {
    const ClockTime noon{2023, 3, 21, 12};
    EXPECT_GT(almanacSolarAngles(noon, {40, 10, 0}).azimuthRad, almanacSolarAngles(noon, {40, 0, 0}).azimuthRad);  // further west
    EXPECT_NEAR(almanacSolarAngles(noon, {40, 15, 1}).azimuthRad, almanacSolarAngles(noon, {40, 0, 0}).azimuthRad, 0.001);  // an hour apart
}

}  // namespace
}  // namespace luxdeck::test

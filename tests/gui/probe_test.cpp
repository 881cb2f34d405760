// Light under the cursor.
#include "gui/session/probe.h"
#include "tests/gui/made_volume.h"
#include "tests/gui/open_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace luxdeck::gui {
namespace {

using test::madeVolume;
using test::OpenSession;
using test::OwnFolder;
using testing::HasSubstr;

/// The reading once the volume's light is there.
ProbeReading settled(OpenSession& open, const Vec3d& point, const Vec3d& normal, std::optional<double> reflectance = {}) {
    open.until([&] {
        static_cast<void>(probe(open.session, {}, point, normal));
        return open.session.place.jobs.idle();
    });
    return probe(open.session, {}, point, normal, reflectance);
}

TEST(Probe, SaysWhyNothingIsKnown) {
    OpenSession open;
    const auto reading = probe(open.session, {}, {0, 0, 0}, {0, 0, 1});
    EXPECT_FALSE(reading.fromVolume);
    EXPECT_THAT(reading.text({}), HasSubstr("no volume"));
    open.session.volumes.add(madeVolume("grey", [](const Vec3&) { return 100.0F; }));
    EXPECT_THAT(settled(open, {5, 0, 0}, {0, 0, 1}).text({}), HasSubstr("outside"));
}

TEST(Probe, UniformLightGivesPiLAndAMatteSurfaceItsShare) {
    OpenSession open;
    open.session.volumes.add(madeVolume("grey", [](const Vec3&) { return 100.0F; }));
    const auto reading = settled(open, {0.2, -0.3, 0.4}, {0, 0, 1}, 0.5);
    ASSERT_TRUE(reading.fromVolume) << reading.why;
    EXPECT_NEAR(reading.total.value, 100 * kPiD, 0.1);
    EXPECT_NEAR(reading.direct.value, 100 * kPiD, 0.1);
    EXPECT_EQ(reading.indirect.value, 0);
    ASSERT_TRUE(reading.luminance);
    EXPECT_NEAR(reading.luminance->value, 50, 0.05);
    Units feet;
    feet.light = LightUnit::Footcandle;
    EXPECT_THAT(reading.text(feet), HasSubstr("fc"));
}

TEST(Probe, ReadsWhatTheSolveAndTheVolumeSay) {
    const OwnFolder folder;
    OpenSession open;
    ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors();
    SolveSettings solve;
    solve.samples = 256;
    open.session.solving.start(solve);
    VolumeRequest request;
    request.settings = *volumeSettingsOf(open.session.project()->project, {});
    request.settings.side = 8;
    open.session.volumes.build(request);
    ASSERT_TRUE(open.untilIdle()) << open.errors();
    const auto& grid = open.session.solving.result()->grids.front();
    const auto& origin = open.session.project()->project.scene.origin;
    int agree = 0, known = 0;
    for (const auto& point : grid.points) {
        const auto reading = settled(open, point.position - origin, point.normal);
        ASSERT_TRUE(reading.nearest);
        EXPECT_EQ(reading.nearest->grid, grid.name);
        EXPECT_EQ(reading.nearest->lux.value, point.total.value);
        if (!reading.fromVolume) continue;
        ++known;
        EXPECT_GT(reading.total.ci95, 0);
        EXPECT_NEAR(reading.total.value, reading.direct.value + reading.indirect.value, 1e-6);
        agree += std::abs(reading.total.value - point.total.value) <= reading.total.ci95 + point.total.ci95 ? 1 : 0;
    }
    EXPECT_GT(known, 0);
    // 95 % intervals; edges of shadows between vertices may lie outside.
    EXPECT_GE(agree, known * 3 / 4) << known;
}

}  // namespace
}  // namespace luxdeck::gui

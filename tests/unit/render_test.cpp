#include "analysis/pictures/render.h"

#include "analysis/grids/solver.h"
#include "engine/core/parallel.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

/// A project made ready, with one view.
struct Studio {
    explicit Studio(Scene scene) {
        project.info.name = "Studio";
        project.scene = std::move(scene);
        project.scene.hash = sceneHash(project.scene);
        view.name = "corner";
        view.position = {0.5, 0.5, 1.5}, view.direction = Vec3d(1, 1, -0.2).normalized();
        view.width = 48, view.height = 32;
    }
    [[nodiscard]] RenderResult shoot(const RenderSettings& settings) const {
        const auto lit = LitScene::create(project.scene);
        EXPECT_TRUE(lit);
        auto result = render(project, *lit, view, settings, Progress{});
        EXPECT_TRUE(result) << result.error().text();
        return result ? *std::move(result) : RenderResult{};
    }
    Project project;
    View view;
};

RenderSettings samples(std::uint32_t count) {
    RenderSettings s;
    s.samples = count;
    return s;
}

TEST(Render, IsTheSameToTheBitAtAnyNumberOfThreads) {
    const Studio studio(furnishedRoom());
    std::optional<Image> first;
    for (const int threads : {1, 2, 7}) {
        const ThreadLimit limit(threads);
        const auto image = studio.shoot(samples(8)).image;
        if (!first) first = image;
        EXPECT_EQ(image.channels(), first->channels()) << threads << " threads";
    }
}

TEST(Render, FisheyesAreDarkOutsideTheirCircle) {
    Studio studio(cubeRoom(0.5F, 10000));
    studio.view.kind = ViewKind::Fisheye;
    const auto image = studio.shoot(samples(4)).image;
    for (const int x : {0, 47})
        for (const int y : {0, 31}) {
            EXPECT_EQ(image.channel("G")[image.index(x, y)], 0);
            EXPECT_EQ(image.channel("Z")[image.index(x, y)], kInfinity);
        }
    EXPECT_GT(image.channel("G")[image.index(24, 16)], 0);
    EXPECT_EQ(image.channel("Z")[image.index(1, 16)], kInfinity) << "the circle is as wide as the picture is high";
}

TEST(Render, TellsItsErrorAndItsOrigin) {
    const Studio studio(furnishedRoom());
    const auto result = studio.shoot(samples(8));
    const auto& image = result.image;
    std::size_t noisy = 0;
    for (const float e : image.channel("stderr.Y")) {
        EXPECT_TRUE(e >= 0 && std::isfinite(e));
        noisy += e > 0 ? 1 : 0;
    }
    EXPECT_EQ(noisy, image.pixelCount()) << "every pixel of this room sees indirect light";
    EXPECT_EQ(result.samplesPerPixel, 8U);
    EXPECT_TRUE(result.complete && result.targetReached);
    EXPECT_GT(result.relativeError, 0);
    for (const auto* key : {"luxdeck:quantity", "luxdeck:unit", "luxdeck:project", "luxdeck:view", "luxdeck:algorithm",
                            "luxdeck:sceneHash", "luxdeck:version", "luxdeck:kernel", "luxdeck:complete", "VIEW"})
        EXPECT_FALSE(image.text.contains(key) ? image.text.at(key).empty() : true) << key;
    EXPECT_EQ(image.text.at("luxdeck:unit"), "cd/m^2");
    EXPECT_EQ(image.text.at("luxdeck:sceneHash"), studio.project.scene.hash);
    EXPECT_THAT(image.text.at("VIEW"), HasSubstr("-vtv -vp 0.5 0.5 1.5"));
    for (const auto* key : {"whiteLuminance", "luxdeck:seed", "luxdeck:seconds", "luxdeck:samplesPerPixel", "luxdeck:relativeError"})
        EXPECT_TRUE(image.numbers.contains(key)) << key;
}

// The error a picture states against the spread of independent ones. 64 pictures' spread is known to
// sqrt(2 / 63) / 2 = 9 % a pixel, over 96 pixels to 1 %; the mean of the stated variances to as much. Quasi-random
// sets spread less than the statement, which takes samples for independent: only too small a statement is wrong.
TEST(Render, StatedErrorCoversTheSpreadOfSeeds) {
    Studio studio(furnishedRoom());
    studio.view.width = 12, studio.view.height = 8;
    std::vector<MeanVariance> pixels(96);
    double stated = 0;
    for (std::uint64_t seed = 0; seed < 64; ++seed) {
        auto settings = samples(16);
        settings.seed = seed;
        const auto image = studio.shoot(settings).image;
        for (std::size_t i = 0; i < 96; ++i) {
            const Rgb c{image.channel("R")[i], image.channel("G")[i], image.channel("B")[i]};
            pixels[i].add(luminance(c));
            stated += std::pow(image.channel("stderr.Y")[i], 2) / 64;
        }
    }
    double spread = 0;
    for (const auto& p : pixels) spread += p.variance();
    EXPECT_GT(stated, 0.9 * spread) << "ratio of the standard deviations " << std::sqrt(stated / spread);
    EXPECT_LT(stated, 9 * spread) << "more than three times the error is no statement either";
}

// A picture of illuminance and a calculation point say the same of the same spot.
TEST(Render, IlluminanceIsWhatSolveSays) {
    Studio studio(furnishedRoom());
    studio.view.position = {1, 3.3, 1.5}, studio.view.direction = {0, 0, -1}, studio.view.up = {0, 1, 0};
    studio.view.verticalFovDeg = 0.5;  // 13 mm of the floor: level to 1e-4
    studio.view.width = studio.view.height = 8;
    auto settings = samples(256);
    settings.quantity = Quantity::Illuminance;
    const auto image = studio.shoot(settings).image;
    EXPECT_EQ(image.text.at("luxdeck:unit"), "lx");
    double mean = 0, variance = 0;
    for (std::size_t i = 0; i < 64; ++i) {
        mean += luminance({image.channel("R")[i], image.channel("G")[i], image.channel("B")[i]}) / 64.0;
        variance += std::pow(image.channel("stderr.Y")[i] / 64.0, 2);
    }
    CalculationGrid grid;
    grid.name = "spot", grid.points = {{{{1, 3.3, 0}, {0, 0, 1}}}};
    studio.project.grids = {grid};
    const auto lit = LitScene::create(studio.project.scene);
    SolveSettings solving;
    solving.samples = 1 << 15;
    const auto solved = solve(studio.project, *lit, solving, Progress{});
    ASSERT_TRUE(solved);
    const auto& point = solved->grids[0].points[0].total;
    // 4 standard errors (false alarm 6e-5); 1e-3: the field's slope over 13 mm.
    EXPECT_NEAR(mean, point.value, 4 * std::hypot(std::sqrt(variance), point.ci95 / 2) + 1e-3 * point.value);
}

TEST(Render, RefusesWhatNeverEnds) {
    Studio studio(cubeRoom(0.5F, 1000));
    const auto lit = LitScene::create(studio.project.scene);
    RenderSettings settings;
    settings.targetError = 0;
    EXPECT_THAT(render(studio.project, *lit, studio.view, settings, Progress{}).error().message, HasSubstr("never end"));
    settings.algorithm = "magic";
    EXPECT_THAT(render(studio.project, *lit, studio.view, settings, Progress{}).error().message, HasSubstr("expected one of: path"));
    studio.view.width = 0;
    EXPECT_THAT(render(studio.project, *lit, studio.view, samples(1), Progress{}).error().message, HasSubstr("0 x 32 pixels"));
}

TEST(Render, StopsWhenItIsCancelled) {
    const Studio studio(cubeRoom(0.5F, 1000));
    const auto lit = LitScene::create(studio.project.scene);
    Progress progress;
    progress.cancel();
    const auto result = render(studio.project, *lit, studio.view, samples(1000), progress);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->complete);
    EXPECT_EQ(result->image.text.at("luxdeck:complete"), "false");
}

TEST(Render, AimsForItsTargetError) {
    const Studio studio(cubeRoom(0.5F, 1000));
    RenderSettings settings;
    settings.targetError = 0.2;
    const auto result = studio.shoot(settings);
    EXPECT_TRUE(result.targetReached);
    EXPECT_LE(result.relativeError, 0.2);
    EXPECT_GT(result.counters.rays, 0U);
}

}  // namespace
}  // namespace luxdeck::test

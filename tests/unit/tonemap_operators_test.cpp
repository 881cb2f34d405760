#include "engine/core/parallel.h"
#include "engine/core/primaries.h"
#include "engine/core/rng.h"
#include "tonemap/acuity.h"
#include "tonemap/operators.h"
#include "tonemap/veil.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

namespace luxdeck::tonemap {
namespace {

Picture uniform(int width, int height, const Rgb& colour) {
    return {width, height, std::vector<Rgb>(static_cast<std::size_t>(width * height), colour)};
}

/// A dark room with a bright window and a lamp, coloured.
Image room(int width, int height, double scale) {
    Image image(width, height, {"R", "G", "B"});
    RandomStream random(11);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool window = x > width / 8 && x < width / 3 && y > height / 6 && y < height / 2;
            const double level = scale * (window ? 3000 : 2) * (0.5 + random.uniform());
            image.channel("R")[image.index(x, y)] = static_cast<float>(level * 1.2);
            image.channel("G")[image.index(x, y)] = static_cast<float>(level);
            image.channel("B")[image.index(x, y)] = static_cast<float>(level * (window ? 1.5 : 0.5));
        }
    image.text["VIEW"] = "-vtv -vh 60 -vv 45";
    return image;
}

TEST(ViewGeometry, ReadsRadiancesOptions) {
    Image image;
    EXPECT_FALSE(viewGeometryOf(image).known());
    image.text["VIEW"] = "-vta -vp 1 2 3 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180";
    EXPECT_EQ(viewGeometryOf(image).projection, Projection::AngularFisheye);
    EXPECT_EQ(viewGeometryOf(image).verticalFovDeg, 180);
    image.text["VIEW"] = "-vtl -vh 5 -vv 5";
    EXPECT_FALSE(viewGeometryOf(image).known());
    image.text["VIEW"] = "-vtv -vv 1e9";
    EXPECT_FALSE(viewGeometryOf(image).known());
    image.text["VIEW"] = viewOptions({Projection::Perspective, 45}, 640, 480);
    EXPECT_NEAR(viewGeometryOf(image).verticalFovDeg, 45, 1e-9);
}

TEST(ViewGeometry, SolidAnglesOfTheFisheyesSumToTheHemisphere) {
    for (const auto projection : {Projection::AngularFisheye, Projection::HemisphericalFisheye}) {
        const PixelDirections pixels({projection, 180}, 400, 400);
        double sum = 0;
        for (int y = 0; y < 400; ++y)
            for (int x = 0; x < 400; ++x)
                if (std::hypot(x + 0.5 - 200, y + 0.5 - 200) < 200) sum += pixels.pixelSolidAngle(x + 0.5, y + 0.5);
        // Pixels cut by the rim, whose 1/cos grows there for the hemispherical one.
        EXPECT_NEAR(sum, 2 * kPiD, projection == Projection::AngularFisheye ? 0.02 : 0.2);
    }
}

TEST(FovealImage, OneSampleADegree) {
    const PixelDirections pixels({Projection::Perspective, 45}, 640, 480);
    const auto foveal = fovealImage(uniform(640, 480, Rgb(3.0F)), pixels);
    // 2 tan(22.5 deg) / 0.01745 = 47.5
    EXPECT_NEAR(foveal.picture.height, 47.5, 1);
    EXPECT_NEAR(foveal.picture.width, 63.3, 1);
    for (const Rgb& c : foveal.picture.pixels) EXPECT_NEAR(c.g, 3, 1e-5);  // float sums of 100 pixels
}

TEST(FovealImage, KeepsTheMean) {
    Picture picture = uniform(97, 61, Rgb());
    RandomStream random(3);
    double mean = 0;
    for (Rgb& c : picture.pixels) c = Rgb(static_cast<float>(random.uniform())), mean += c.g;
    const auto small = boxResampled(picture, 13, 7);
    double smallMean = 0;
    for (const Rgb& c : small.pixels) smallMean += c.g;
    EXPECT_NEAR(smallMean / (13 * 7), mean / (97 * 61), 1e-6);
}

TEST(Veil, AUniformFieldIsItself) {
    for (const auto& geometry :
         {ViewGeometry{Projection::Perspective, 60}, ViewGeometry{Projection::AngularFisheye, 180}}) {
        const PixelDirections pixels(geometry, 120, 120);
        const auto foveal = fovealImage(uniform(120, 120, Rgb(1, 2, 3)), pixels);
        auto picture = uniform(120, 120, Rgb(1, 2, 3));
        addVeil(picture, veil(foveal));
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 120; ++x) {
                if (pixels.pixelSolidAngle(x + 0.5, y + 0.5) == 0) continue;
                EXPECT_NEAR(picture.at(x, y).b, 3, 1e-5) << x << " " << y;  // floats
            }
    }
}

TEST(Veil, GroupsStandForTheirSamples) {
    Picture picture = uniform(90, 60, Rgb());
    RandomStream random(5);
    for (Rgb& c : picture.pixels) c = Rgb(static_cast<float>(random.uniform() < 0.01 ? 1e4 : random.uniform()));
    const PixelDirections pixels({Projection::Perspective, 50}, 90, 60);
    const auto foveal = fovealImage(picture, pixels);
    const auto exact = veil(foveal, 0), grouped = veil(foveal);
    double squares = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i)
        squares += std::pow(grouped.pixels[i].g / exact.pixels[i].g - 1, 2);
    // Measured 0.4 % rms at an opening of 0.2, growing with its square: 1 % leaves room for another field.
    EXPECT_LT(std::sqrt(squares / static_cast<double>(exact.pixels.size())), 0.01);
}

TEST(Veil, ALampVeilsItsSurroundingsByTheInverseSquareOfTheAngle) {
    Picture picture = uniform(81, 81, Rgb(1e-6F));
    picture.at(20, 40) = Rgb(1e6F);
    const PixelDirections pixels({Projection::AngularFisheye, 81}, 81, 81);
    const auto v = veil(fovealImage(picture, pixels), 0);
    const double near = v.at(30, 40).g, far = v.at(40, 40).g;  // 10 and 20 degrees away
    // 4 by the square, cos 10 / cos 20 = 1.048; the sums of weights of the two places are within 3 % of each other.
    EXPECT_NEAR(near / far, 4 * 1.048, 0.15);
}

TEST(Acuity, LeavesAUniformPictureAndBlursADarkOne) {
    const PixelDirections pixels({Projection::Perspective, 10}, 400, 400);  // 40 pixels a degree
    Picture stripes = uniform(400, 400, Rgb());
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x) stripes.at(x, y) = Rgb(x % 2 == 0 ? 0.0F : 0.002F);  // 20 cycles a degree
    const auto foveal = fovealImage(stripes, pixels);
    const auto sizes = visibleSampleSizes(foveal, pixels, 400, 400);
    EXPECT_NEAR(sizes[sizes.size() / 2], 0.5 * 40 / 3.01,
                0.2);  // 3.01 cycles a degree at 0.001 cd/m^2; 2 % for the pixel's place
    const auto blurred = blurredToAcuity(stripes, foveal, sizes);
    for (int x = 50; x < 350; ++x) EXPECT_NEAR(blurred.at(x, 200).g, 0.001, 1e-5);
    const auto flat = uniform(400, 400, Rgb(0.001F));
    for (const Rgb& c : blurredToAcuity(flat, foveal, sizes).pixels) EXPECT_NEAR(c.g, 0.001, 1e-9);
}

TEST(ToneMap, StaysOnTheDisplayForEveryOperatorAndRange) {
    for (const auto op : {Operator::Camera, Operator::Human})
        for (const double scale : {1e-9, 1e-5, 1e-2, 1.0, 1e4, 1e9}) {
            ToneMapSettings settings;
            settings.op = op;
            const auto mapped = toneMap(room(160, 120, scale), settings);
            ASSERT_TRUE(mapped) << mapped.error().text();
            for (const char* channel : {"R", "G", "B"})
                for (const float v : mapped->image.channel(channel))
                    ASSERT_TRUE(v >= 0 && v <= 1) << v << " at scale " << scale;
        }
}

TEST(ToneMap, TellsWhatItDid) {
    const auto mapped = toneMap(room(320, 240, 1), {});
    ASSERT_TRUE(mapped);
    const auto& r = mapped->record;
    EXPECT_EQ(r.mapping, "histogram, human ceiling");
    EXPECT_FALSE(r.viewAssumed);
    ASSERT_EQ(r.effects.size(), 3U);
    EXPECT_EQ(r.effects[0].effect, "veil");
    EXPECT_TRUE(r.effects[0].applied);
    for (const auto& e : r.effects) EXPECT_FALSE(e.why.empty());
    ASSERT_EQ(r.curve.size(), 64U);
    for (std::size_t i = 1; i < r.curve.size(); ++i) EXPECT_GE(r.curve[i].displayCdM2, r.curve[i - 1].displayCdM2);
    EXPECT_EQ(mapped->image.text.at("luxdeck:operator"), "human");
    EXPECT_EQ(mapped->image.numbers.at("whiteLuminance"), 100);
}

TEST(ToneMap, BrokenPixelsAreCountedAndHealed) {
    Image image = room(40, 30, 1);
    image.channel("R")[100] = std::numeric_limits<float>::quiet_NaN();
    image.channel("G")[200] = std::numeric_limits<float>::infinity();
    image.channel("B")[300] = -5;
    for (const auto op : {Operator::Linear, Operator::Camera, Operator::Human}) {
        ToneMapSettings settings;
        settings.op = op;
        const auto mapped = toneMap(image, settings);
        ASSERT_TRUE(mapped);
        EXPECT_EQ(mapped->record.nonFinitePixels, 2U);
        EXPECT_EQ(mapped->record.negativePixels, 1U);
        for (const auto& [name, values] : mapped->image.channels())
            for (const float v : values) ASSERT_TRUE(std::isfinite(v));
    }
}

TEST(ToneMap, DegeneratePicturesWork) {
    for (const auto op : {Operator::Linear, Operator::Camera, Operator::Human})
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 50), std::pair(7, 2)})
            for (const float level : {0.0F, 1e-7F, 1.0F, 1e7F, 1e30F}) {
                Image image(width, height, {"Y"});
                for (float& v : image.channel("Y")) v = level;
                ToneMapSettings settings;
                settings.op = op;
                const auto mapped = toneMap(image, settings);
                ASSERT_TRUE(mapped) << mapped.error().text();
                for (const float v : mapped->image.channel("G")) {
                    ASSERT_TRUE(std::isfinite(v)) << level;
                    EXPECT_EQ(v, mapped->image.channel("G")[0]);
                    EXPECT_TRUE(level > 0 || v == 0);
                }
            }
}

TEST(ToneMap, RefusesWhatItCannotMap) {
    EXPECT_EQ(toneMap(Image{}, {}).error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(toneMap(Image(2, 2, {"depth"}), {}).error().code, ErrorCode::InvalidArgument);
    ToneMapSettings settings;
    settings.display.minCdM2 = 0;
    EXPECT_EQ(toneMap(room(4, 4, 1), settings).error().code, ErrorCode::InvalidArgument);
    settings = {};
    settings.exposure = -1;
    EXPECT_EQ(toneMap(room(4, 4, 1), settings).error().code, ErrorCode::InvalidArgument);
    EXPECT_FALSE(operatorNamed("reinhard"));
    EXPECT_EQ(*operatorNamed("camera"), Operator::Camera);
}

TEST(ToneMap, LinearIsProportional) {
    ToneMapSettings settings;
    settings.op = Operator::Linear;
    settings.exposure = 0.5;
    Image image(2, 1, {"R", "G", "B"});
    for (const char* c : {"R", "G", "B"}) image.channel(c)[0] = 20, image.channel(c)[1] = 80;
    const auto mapped = toneMap(image, settings);
    ASSERT_TRUE(mapped);
    EXPECT_NEAR(mapped->image.channel("G")[0], 0.1, 1e-7);  // 20 * 0.5 / 100
    EXPECT_NEAR(mapped->image.channel("G")[1], 0.4, 1e-7);
    EXPECT_EQ(mapped->record.factor, 0.5);
}

TEST(ToneMap, EffectsCanBeSwitched) {
    ToneMapSettings settings;
    settings.effects = {false, false, false};
    const auto off = toneMap(room(160, 120, 1), settings);
    ASSERT_TRUE(off);
    for (const auto& e : off->record.effects) EXPECT_EQ(e.why, "switched off");
    settings.op = Operator::Camera;
    settings.effects = {true, {}, {}};
    const auto on = toneMap(room(160, 120, 1), settings);
    ASSERT_TRUE(on);
    EXPECT_TRUE(on->record.effects[0].applied);
}

TEST(ToneMap, LeavingAnEffectOutChangesNothing) {
    // Rule 3: what is left out automatically (a bright scene needs no night colours, coarse pixels no blur) gives
    // the picture that asking for it would.
    ToneMapSettings automatic, without;
    without.effects = {{}, false, false};
    const auto bright = room(100, 80, 100);
    const auto a = toneMap(bright, automatic), b = toneMap(bright, without);
    ASSERT_TRUE(a && b);
    EXPECT_FALSE(a->record.effects[1].applied) << a->record.effects[1].why;
    EXPECT_FALSE(a->record.effects[2].applied) << a->record.effects[2].why;
    EXPECT_EQ(a->image.channels(), b->image.channels());
}

TEST(ToneMap, SameBitsOnAnyNumberOfThreads) {
    std::optional<ToneMapped> first;
    for (const int threads : {1, 2, 7}) {
        const ThreadLimit limit(threads);
        auto mapped = toneMap(room(200, 150, 0.01), {});
        ASSERT_TRUE(mapped);
        if (!first) first = *mapped;
        EXPECT_EQ(first->image.channels(), mapped->image.channels());
    }
}

TEST(ToneMap, SpacesOfColourAgree) {
    // The same light in Radiance's primaries.
    const Image in709 = room(60, 40, 1);
    Image radiance = in709;
    radiance.weights = luminanceWeights(kRadianceChromaticities);
    const auto m = rgbToRgb(kRec709Chromaticities, kRadianceChromaticities);
    const auto pixels = colours(in709);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Rgb c = transformed(pixels[i], m);
        radiance.channel("R")[i] = c.r, radiance.channel("G")[i] = c.g, radiance.channel("B")[i] = c.b;
    }
    ToneMapSettings settings;
    settings.op = Operator::Linear;
    settings.exposure = 0.01;
    const auto a = toneMap(in709, settings), b = toneMap(radiance, settings);
    ASSERT_TRUE(a && b);
    for (std::size_t i = 0; i < pixels.size(); ++i)  // floats through two matrices
        EXPECT_NEAR(a->image.channel("G")[i], b->image.channel("G")[i], 1e-5);
}

TEST(Operators, AStopDoublesTheExposureGivenOrAutomatic) {
    const Image scene = room(60, 40, 1);
    for (const auto exposure : {std::optional<double>(), std::optional<double>(0.01)}) {
        ToneMapSettings settings;
        settings.op = Operator::Linear;
        settings.exposure = exposure;
        const auto plain = toneMap(scene, settings);
        settings.exposureEv = 1.5;
        const auto brighter = toneMap(scene, settings);
        ASSERT_TRUE(plain && brighter);
        EXPECT_NEAR(brighter->record.factor / plain->record.factor, std::exp2(1.5), 1e-12);
    }
    ToneMapSettings settings;
    settings.exposureEv = 65;
    EXPECT_FALSE(toneMap(scene, settings));
}

}  // namespace
}  // namespace luxdeck::tonemap

#include "tonemap/falsecolor.h"
#include "tonemap/stroke_font.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace luxdeck::tonemap {
namespace {

double lightness(const Colour8& c) {
    const auto linear = [](double v) { return std::pow(v / 255, 2.2); };
    return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

/// As a deuteranope sees it: red and green fall together. Source: Viénot, Brettel & Mollon 1999, linear matrix.
double deuteranLuminance(const Colour8& c) {
    const auto linear = [](double v) { return std::pow(v / 255, 2.2); };
    const double r = linear(c[0]), g = linear(c[1]), b = linear(c[2]);
    const double rg = 0.29275 * r + 0.70725 * g;
    return 0.9278 * rg + 0.0722 * b;
}

TEST(ColourMap, GetsLighterAllTheWay) {
    for (const auto map : {ColourMap::Dusk, ColourMap::Heat})
        for (int i = 4; i <= 255; i += 4) {
            const auto a = colourAt(map, (i - 4) / 255.0), b = colourAt(map, i / 255.0);
            EXPECT_GT(lightness(b), lightness(a)) << name(map) << " " << i;
            EXPECT_GT(deuteranLuminance(b), deuteranLuminance(a)) << name(map) << " " << i;
        }
}

TEST(ColourMap, NamesAndEnds) {
    EXPECT_EQ(*colourMapNamed("heat"), ColourMap::Heat);
    EXPECT_FALSE(colourMapNamed("jet"));
    EXPECT_EQ(colourAt(ColourMap::Dusk, -3), colourAt(ColourMap::Dusk, 0));
    EXPECT_EQ(colourAt(ColourMap::Dusk, 7), colourAt(ColourMap::Dusk, 1));
}

Field ramp(int width, int height, double low, double high) {
    Field field{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            field.values.push_back(low * std::pow(high / low, static_cast<double>(x) / (width - 1)));
    return field;
}

Colour8 pixel(const DisplayImage& image, int x, int y) {
    const auto i = 3 * static_cast<std::size_t>(y * image.width + x);
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

TEST(FalseColour, TheMiddleOfALogarithmicScaleIsTheGeometricMean) {
    FalseColourSettings settings;
    settings.range = ScaleRange{1, 10000};
    settings.legend = false;
    const auto image = falseColour(ramp(101, 4, 1, 10000), settings);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 101);
    EXPECT_EQ(pixel(*image, 50, 2), colourAt(ColourMap::Dusk, 0.5));
    EXPECT_EQ(pixel(*image, 0, 0), colourAt(ColourMap::Dusk, 0));
    EXPECT_EQ(pixel(*image, 100, 3), colourAt(ColourMap::Dusk, 1));
}

TEST(FalseColour, WhatIsNoNumberIsMarkedAndCounted) {
    auto field = ramp(50, 200, 1, 100);
    field.values[0] = std::numeric_limits<double>::quiet_NaN();
    field.values[1] = std::numeric_limits<double>::infinity();
    field.values[2] = 0;
    FalseColourSettings settings;
    const auto image = falseColour(field, settings);
    ASSERT_TRUE(image);
    EXPECT_EQ(pixel(*image, 0, 0), kNotANumber);
    EXPECT_EQ(pixel(*image, 1, 0), kNotANumber);
    EXPECT_EQ(pixel(*image, 2, 0), colourAt(ColourMap::Dusk, 0));
    EXPECT_NE(image->text.at("luxdeck:beyond").find("2 not finite"), std::string::npos);
}

TEST(FalseColour, TheLegendDoesNotTouchThePicture) {
    FalseColourSettings settings;
    const auto with = falseColour(ramp(60, 300, 1, 1000), settings);
    settings.legend = false;
    const auto without = falseColour(ramp(60, 300, 1, 1000), settings);
    ASSERT_TRUE(with && without);
    EXPECT_GT(with->width, without->width);
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 60; ++x) ASSERT_EQ(pixel(*with, x, y), pixel(*without, x, y));
    settings.legend = true;
    const auto tiny = falseColour(ramp(3, 2, 1, 1000), settings);
    ASSERT_TRUE(tiny);
    EXPECT_GT(tiny->height, 80);  // room for the numbers
}

TEST(FalseColour, RangesAreRound) {
    const auto logarithmic = roundedRange(ramp(500, 4, 0.13, 8300), true);
    // The 0.5th and 99.9th percentiles of eleven e-folds lie within 6 % of the ends.
    EXPECT_NEAR(logarithmic.low, 0.1, 1e-12);
    EXPECT_NEAR(logarithmic.high, 1e4, 1e-8);
    Field flat{10, 10, std::vector<double>(100, 612)};
    EXPECT_EQ(roundedRange(flat, false).low, 0);
    EXPECT_NEAR(roundedRange(flat, false).high, 700, 1e-9);
    const auto around = roundedRange(flat, true);
    EXPECT_LT(around.low, 612);
    EXPECT_GT(around.high, 612);
    EXPECT_EQ(roundedRange(Field{2, 1, {0, 0}}, true).high, 1);
    EXPECT_EQ(roundedRange(Field{}, false).high, 1);
    EXPECT_NEAR(roundedRange(Field{4, 1, {1e-12, 1, 10, 1e3}}, true).low, 1e-3, 1e-12);  // six decades at most
}

TEST(FalseColour, RefusesWhatIsNotARange) {
    FalseColourSettings settings;
    settings.range = ScaleRange{0, 10};
    EXPECT_EQ(falseColour(ramp(4, 4, 1, 2), settings).error().code, ErrorCode::InvalidArgument);
    settings.logarithmic = false;
    EXPECT_TRUE(falseColour(ramp(4, 4, 1, 2), settings));
    settings.range = ScaleRange{10, 10};
    EXPECT_FALSE(falseColour(ramp(4, 4, 1, 2), settings));
    EXPECT_FALSE(falseColour(Field{}, {}));
    EXPECT_FALSE(falseColour(Field{3, 3, {1, 2}}, {}));
    EXPECT_FALSE(luminanceField(Image(2, 2, {"depth"})));
}

TEST(FalseColour, IsolinesAreDrawnWhereTheLevelIs) {
    const auto field = ramp(200, 100, 1, 100);
    FalseColourSettings settings;
    settings.legend = false;
    settings.range = ScaleRange{1, 100};
    settings.isolines = IsolineStyle{};
    settings.isolines->levels = {10};
    settings.isolines->labels = false;
    const auto image = falseColour(field, settings);
    ASSERT_TRUE(image);
    EXPECT_GT(pixel(*image, 99, 50)[0], 100);  // the line lies at 100, on two pixels' border: each is half white
    EXPECT_GT(pixel(*image, 100, 50)[0], 100);
    EXPECT_EQ(pixel(*image, 50, 50), colourAt(ColourMap::Dusk, 50.0 / 199));
    DisplayImage small{10, 10, std::vector<std::uint8_t>(300), {}};
    EXPECT_FALSE(drawIsolines(small, field, {}, true));
}

TEST(Labels, AreShort) {
    EXPECT_EQ(labelOf(0), "0");
    EXPECT_EQ(labelOf(0.05), "0.05");
    EXPECT_EQ(labelOf(500), "500");
    EXPECT_EQ(labelOf(20000), "20 000");
    EXPECT_EQ(labelOf(3e6), "3e6");
    EXPECT_EQ(labelOf(1e12), "1e12");
    EXPECT_EQ(labelOf(1e-5), "1e-5");
}

TEST(StrokeFont, HasTheGlyphsThatLegendsNeed) {
    const auto missing = strokeText("\u2603");
    ASSERT_EQ(missing.strokes.size(), 4U);  // the box
    for (const std::string character : {"0", "9", "l", "x", "c", "d", "/", "m", "L", "I", "e", ".", "-", "%"})
        EXPECT_NE(strokeText(character).strokes.size(), 0U) << character;
    EXPECT_EQ(strokeText("m^2").width, strokeText("m\u00b2").width);
    EXPECT_EQ(strokeText("").width, 0);
    EXPECT_FALSE(strokeText("\xc2").strokes.empty());  // cut off in the middle of a character
}

}  // namespace
}  // namespace luxdeck::tonemap

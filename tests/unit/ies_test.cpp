// readIes: symmetries against the same distribution given in full, editions, openings, malformations, and the
// shared folder of manufacturers' files.
#include "engine/core/rng.h"
#include "engine/io/ies_tilt.h"
#include "engine/io/photometry.h"
#include "tests/support/photometry_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace luxdeck {
namespace {

using namespace test;
using testing::HasSubstr;

Photometry read(const std::string& text) {
    auto p = readIes(text, "test.ies");
    EXPECT_TRUE(p) << p.error().text();
    return p ? *p : Photometry{};
}

std::string refusal(const std::string& text) {
    const auto p = readIes(text, "test.ies");
    return p ? "accepted" : p.error().text();
}

// Both tables interpolate the same planes, so they agree to float rounding of values up to 1000.
void expectSameLight(const CandelaTable& a, const CandelaTable& b) {
    RandomStream random(5);
    for (int i = 0; i < 500; ++i) {
        const Vec3 d = Vec3(float(random.normal()), float(random.normal()), float(random.normal())).normalized();
        ASSERT_NEAR(a.intensity(d), b.intensity(d), 2e-3) << d.x << " " << d.y << " " << d.z;
    }
    EXPECT_NEAR(a.lumens(), b.lumens(), 1e-9 * a.lumens());
}

double cosine(double degrees) { return std::cos(degrees * kDegree); }
double sine(double degrees) { return std::sin(degrees * kDegree); }

struct SymmetryCase {
    std::vector<double> horizontal;
    PhotometrySymmetry symmetry;
    Distribution candela;  // has that symmetry over the whole turn
};

class IesSymmetry : public testing::TestWithParam<SymmetryCase> {};

TEST_P(IesSymmetry, IsTheSameAsTheFullFile) {
    IesFile file;
    file.vertical = steps(0, 180, 15);
    file.candela = GetParam().candela;
    file.horizontal = GetParam().horizontal;
    const Photometry part = read(file.text());
    file.horizontal = steps(0, 360, 15);
    const Photometry full = read(file.text());
    EXPECT_EQ(part.symmetry, GetParam().symmetry);
    expectSameLight(part.table, full.table);
    EXPECT_EQ(part.table.horizontal().front(), 0);
}

const Distribution kQuadrant = [](double c, double v) { return 500 + 200 * cosine(2 * c) + v * std::abs(sine(c)); };
const Distribution kAbout0to180 = [](double c, double v) { return 500 + 300 * cosine(c) + v; };
const Distribution kAbout90to270 = [](double c, double v) { return 500 + 300 * sine(c) + v; };
const Distribution kNone = [](double c, double v) {
    return 500 + 200 * sine(c) + 100 * cosine(c) + 50 * sine(2 * c) + v;
};

INSTANTIATE_TEST_SUITE_P(
    All, IesSymmetry,
    testing::Values(SymmetryCase{{0}, PhotometrySymmetry::Axial, [](double, double v) { return 100 + v; }},
                    SymmetryCase{{90}, PhotometrySymmetry::Axial, [](double, double v) { return 100 + v; }},
                    SymmetryCase{steps(0, 90, 15), PhotometrySymmetry::Quadrant, kQuadrant},
                    SymmetryCase{steps(180, 270, 15), PhotometrySymmetry::Quadrant, kQuadrant},
                    SymmetryCase{steps(0, 180, 15), PhotometrySymmetry::Bilateral0to180, kAbout0to180},
                    SymmetryCase{steps(180, 360, 15), PhotometrySymmetry::Bilateral0to180, kAbout0to180},
                    SymmetryCase{steps(90, 270, 15), PhotometrySymmetry::Bilateral90to270, kAbout90to270},
                    SymmetryCase{steps(-90, 90, 15), PhotometrySymmetry::Bilateral90to270, kAbout90to270},
                    SymmetryCase{steps(0, 345, 15), PhotometrySymmetry::None, kNone},
                    SymmetryCase{steps(-180, 180, 15), PhotometrySymmetry::None, kNone},
                    SymmetryCase{steps(15, 360, 15), PhotometrySymmetry::None, kNone}));

TEST(Ies, PlaneZeroPointsAlongXAndPlane90AlongY) {
    IesFile file;
    file.horizontal = steps(0, 360, 90);
    file.candela = [](double c, double v) { return v < 90 ? 0.0 : 100 + (c == 360 ? 0.0 : c); };
    const auto table = read(file.text()).table;
    EXPECT_NEAR(table.intensity({1, 0, 0}), 100, 1e-3);
    EXPECT_NEAR(table.intensity({0, 1, 0}), 190, 1e-3);
    EXPECT_NEAR(table.intensity({-1, 0, 0}), 280, 1e-3);
    EXPECT_NEAR(table.intensity({0, -1, 0}), 370, 1e-3);
}

TEST(Ies, SetThatStartsOffZeroIsInterpolatedAtTheSeam) {
    IesFile file;
    file.horizontal = steps(5, 355, 10);
    file.candela = [](double c, double v) { return v + (c < 180 ? c : 360 - c); };
    const Photometry p = read(file.text());
    EXPECT_EQ(p.symmetry, PhotometrySymmetry::None);
    EXPECT_NEAR(p.table.intensity({1, 0, 0}), 90 + 5, 1e-3);  // between 5 and 355, both 5
    EXPECT_TRUE(mentions(p.repairs, "closed to a full turn"));
}

TEST(Ies, GapInThePlanesIsTold) {
    IesFile file;
    file.horizontal = steps(0, 270, 15);
    EXPECT_TRUE(mentions(read(file.text()).warnings, "leave a gap of 90 degrees"));
    file.horizontal = steps(0, 60, 15);
    EXPECT_TRUE(mentions(read(file.text()).warnings, "leave a gap of 60 degrees"));
    file.horizontal = steps(0, 90, 15);
    EXPECT_FALSE(mentions(read(file.text()).warnings, "gap"));
}

TEST(Ies, TypesAAndBMirrorHalfSets) {
    for (const int type : {2, 3}) {
        IesFile file;
        file.type = type;
        file.vertical = steps(-90, 90, 15);
        file.horizontal = steps(-90, 90, 15);
        file.candela = [](double h, double v) { return 200 + v - std::abs(h); };
        const Photometry full = read(file.text());
        EXPECT_EQ(full.table.type(), type == 2 ? PhotometryType::B : PhotometryType::A);
        file.horizontal = steps(0, 90, 15);
        const Photometry half = read(file.text());
        EXPECT_EQ(half.symmetry, PhotometrySymmetry::Bilateral0to180);
        expectSameLight(half.table, full.table);

        file.candela = [](double h, double v) { return 200 - std::abs(v) - std::abs(h); };
        file.vertical = steps(0, 90, 15);
        const Photometry quarter = read(file.text());
        EXPECT_EQ(quarter.symmetry, PhotometrySymmetry::Quadrant);
        file.vertical = file.horizontal = steps(-90, 90, 15);
        expectSameLight(quarter.table, read(file.text()).table);
    }
}

TEST(Ies, BallastLampFactorMultipliesOnlyIn1986And1991) {
    IesFile file;
    file.multiplier = 2;
    file.ballast = 0.9;
    file.twelfth = 1.1;
    const auto nadir = [&](const char* firstLine) {
        file.firstLine = firstLine;
        return read(file.text()).table.intensity({0, 0, -1});
    };
    EXPECT_FLOAT_EQ(nadir("Some label of 1986"), 100 * 2 * 0.9F * 1.1F);
    EXPECT_FLOAT_EQ(nadir("IESNA91"), 100 * 2 * 0.9F * 1.1F);
    EXPECT_FLOAT_EQ(nadir("IESNA:LM-63-1995"), 100 * 2 * 0.9F);
    EXPECT_FLOAT_EQ(nadir("  iesna:lm-63-2002"), 100 * 2 * 0.9F);
    EXPECT_FLOAT_EQ(nadir("IES:LM-63-2019"), 100 * 2 * 0.9F);
    EXPECT_TRUE(
        mentions(read(replaced(file.text(), "IES:LM-63-2019", "IESNA:LM-63-2002")).warnings, "not multiplied in"));
}

TEST(Ies, DeclaredFluxAndItsReason) {
    IesFile file;  // 100 cd over the lower half: 200 pi = 628.3 lm
    file.lumens = 1000;
    Photometry p = read(file.text());
    EXPECT_DOUBLE_EQ(p.lumensDeclared, 1000);
    EXPECT_TRUE(
        mentions(p.warnings, "flux: light output ratio 0.628: lamps 1000 lm (1 x 1000 lm), luminaire 628.32 lm"));
    file.lamps = 2;
    file.lumens = 314.16;
    p = read(file.text());
    EXPECT_FALSE(mentions(p.warnings, "flux:"));
    file.lamps = 1;
    file.lumens = 300;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "2.094 times the lamp flux"));
    file.lumens = -1;
    p = read(file.text());
    EXPECT_TRUE(p.absolute);
    EXPECT_EQ(p.lumensDeclared, 0);
    EXPECT_TRUE(mentions(p.warnings, "flux: absolute photometry"));
    file.lumens = 0;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "flux: the header states a flux of 0"));
}

struct OpeningCase {
    const char* firstLine;
    double width, length, height;
    LuminousOpening opening;
    const char* note;
};

class IesOpenings : public testing::TestWithParam<OpeningCase> {};

TEST_P(IesOpenings, AreReadByTheirEdition) {
    const auto& c = GetParam();
    IesFile file;
    file.firstLine = c.firstLine;
    file.width = c.width;
    file.length = c.length;
    file.height = c.height;
    const Photometry p = read(file.text());
    EXPECT_EQ(p.opening.shape, c.opening.shape);
    EXPECT_NEAR(p.opening.lengthM, c.opening.lengthM, 1e-12);
    EXPECT_NEAR(p.opening.widthM, c.opening.widthM, 1e-12);
    EXPECT_NEAR(p.opening.heightM, c.opening.heightM, 1e-12);
    if (c.note) {
        EXPECT_TRUE(mentions(p.repairs, c.note));
    } else {
        EXPECT_TRUE(p.repairs.empty()) << p.repairs.front();
    }
}

constexpr auto k86 = "label";
constexpr auto k95 = "IESNA:LM-63-1995";
constexpr auto k02 = "IESNA:LM-63-2002";
INSTANTIATE_TEST_SUITE_P(
    All, IesOpenings,
    testing::Values(
        OpeningCase{k02, 0, 0, 0, {OpeningShape::Point, 0, 0, 0}, nullptr},
        OpeningCase{k02, 0.3, 1.2, 0, {OpeningShape::Rectangle, 1.2, 0.3, 0}, nullptr},
        OpeningCase{k02, 0.3, 1.2, 0.1, {OpeningShape::Box, 1.2, 0.3, 0.1}, nullptr},
        OpeningCase{k02, 0, 1.2, 0, {OpeningShape::Rectangle, 1.2, 0.001, 0}, "given 1 mm"},
        OpeningCase{k86, -0.4, 0, 0, {OpeningShape::Disc, 0.4, 0.4, 0}, nullptr},
        OpeningCase{k86, -0.4, 0.9, 0, {OpeningShape::Disc, 0.6, 0.6, 0}, "ellipse"},
        OpeningCase{k86, -0.4, 0, 0.2, {OpeningShape::Cylinder, 0.4, 0.4, 0.2}, nullptr},
        OpeningCase{k86, -0.1, 0.1, 0.8, {OpeningShape::Sphere, 0.2, 0.2, 0.2}, "ellipsoid"},
        OpeningCase{k95, -0.4, 0, -0.4, {OpeningShape::Sphere, 0.4, 0.4, 0.4}, nullptr},
        OpeningCase{k95, -0.4, 0.9, 0.2, {OpeningShape::Cylinder, 0.6, 0.6, 0.2}, "elliptical cylinder"},
        OpeningCase{k95, 0, 1.2, -0.1, {OpeningShape::Box, 1.2, 0.1, 0.1}, "horizontal cylinder along 0-180"},
        OpeningCase{k95, 1.2, 0, -0.1, {OpeningShape::Box, 0.1, 1.2, 0.1}, "horizontal cylinder along 90-270"},
        OpeningCase{k02, -0.4, -0.4, 0, {OpeningShape::Disc, 0.4, 0.4, 0}, nullptr},
        OpeningCase{k02, -0.4, -0.9, 0, {OpeningShape::Disc, 0.6, 0.6, 0}, "ellipse"},
        OpeningCase{k02, -0.4, -0.4, 0.2, {OpeningShape::Cylinder, 0.4, 0.4, 0.2}, nullptr},
        OpeningCase{k02, -0.4, -0.4, -0.4, {OpeningShape::Sphere, 0.4, 0.4, 0.4}, nullptr},
        OpeningCase{k02, -0.1, -0.1, -0.8, {OpeningShape::Sphere, 0.2, 0.2, 0.2}, "ellipsoid"},
        OpeningCase{k02, -0.1, 1.2, -0.1, {OpeningShape::Box, 1.2, 0.1, 0.1}, "horizontal cylinder along 0-180"},
        OpeningCase{k02, -0.4, 0, -0.4, {OpeningShape::Box, 0.001, 0.4, 0.4}, "upright disc"},
        OpeningCase{k02, -0.4, 0, 0, {OpeningShape::Disc, 0.4, 0.4, 0}, nullptr}));

TEST(Ies, FeetBecomeMetresAndHugeOpeningsAreTold) {
    IesFile file;
    file.units = 1;
    file.width = 1;
    file.length = 2;
    EXPECT_DOUBLE_EQ(read(file.text()).opening.lengthM, 0.6096);
    file.units = 2;
    file.width = 600;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "600 m long"));
}

TEST(Ies, TiltTablesAreReadAndTold) {
    IesFile file;
    file.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1.0 0.9 0.8";
    const Photometry p = read(file.text());
    EXPECT_TRUE(mentions(p.warnings, "factor 0.8..1"));
    EXPECT_FLOAT_EQ(p.table.intensity({0, 0, -1}), 100);
    const auto tilt = readLampTilt(file.text(), "test.ies");
    ASSERT_TRUE(tilt) << tilt.error().text();
    const auto factor = [&](const Vec3& aim) { return tilt->factor(Frame::about(-aim)); };
    EXPECT_NEAR(factor({0, 0, -1}), 1, 1e-9);
    // 67.5 degrees from straight down, half way from 45 to 90. Floats of the frame: 1e-7 of 0.2 a radian.
    const double angle = 67.5 * kDegree;
    EXPECT_NEAR(factor({static_cast<float>(std::sin(angle)), 0, static_cast<float>(-std::cos(angle))}), 0.85, 1e-6);
    EXPECT_NEAR(factor({0, 0, 1}), 0.8, 1e-9) << "beyond the last angle its factor stays";
    EXPECT_EQ(readLampTilt(IesFile{}.text(), "test.ies")->factor(Frame{}), 1);
    file.tilt = "TILT=INCLUDE\n1\n3\n0 45 45\n1.0 0.9 0.8";
    EXPECT_THAT(refusal(file.text()), HasSubstr("tilt angle 3 is 45, expected more than the one before, 45"));
    file.tilt = "TILT=..\\nowhere.tlt";
    EXPECT_TRUE(mentions(read(file.text()).warnings, "cannot be read"));
    file.tilt = "TILT=INCLUDE\n1\n900\n0 45 90\n1.0 0.9 0.8";
    EXPECT_THAT(refusal(file.text()), HasSubstr("900 tilt angles and their multipliers take 1800 numbers"));
}

/// The bug: of two rows at one vertical angle the second was dropped, so a step of the intensity became a ramp up to the
/// next angle.
TEST(Ies, EqualVerticalAnglesAreSteps) {
    IesFile file;
    file.vertical = {0, 30, 30, 90};
    int row = 0;
    file.candela = [&](double, double) { return row++ < 2 ? 1000.0 : 10.0; };
    const Photometry p = read(file.text());
    EXPECT_TRUE(mentions(p.warnings, "vertical angle(s) 30 stand twice"));
    const auto at = [&](double degrees) {
        const double a = degrees * kDegree;
        return p.table.intensity({static_cast<float>(std::sin(a)), 0, static_cast<float>(-std::cos(a))});
    };
    EXPECT_FLOAT_EQ(at(29.99), 1000);
    EXPECT_FLOAT_EQ(at(30.01), 10);
    // 2 pi of 1000 (1 - cos 30) + 10 cos 30, and half of 990 sin 30 on a ramp of 0.001 degrees.
    const double cosine = std::cos(30 * kDegree);
    EXPECT_NEAR(p.table.lumens(), 2 * kPiD * (1000 * (1 - cosine) + 10 * cosine), 2 * kPiD * 495 * 0.5 * 2e-3 * kDegree);
    // At the end of the range the step moves inwards; three rows of one angle are its first and its last.
    file.vertical = {0, 90, 90, 90};
    row = 0;
    EXPECT_EQ(read(file.text()).table.vertical().back(), 90);
    file.vertical = {45, 45, 45};
    EXPECT_THAT(refusal(file.text()), HasSubstr("one vertical angle"));
    file = {};
    file.horizontal = {0, 90, 90, 180, 270, 360};
    int plane = 0;
    file.candela = [&](double, double v) { return v == 0 ? 100.0 : 100.0 + plane++; };
    EXPECT_TRUE(mentions(read(file.text()).warnings, "1 horizontal angle(s) stand twice"));
}

TEST(Ies, ToleratesHowFilesAreWritten) {
    IesFile file;
    file.candela = [](double, double v) { return 100.5 - v; };
    const Photometry plain = read(file.text());
    const auto same = [&](const std::string& text, const char* repair) {
        const Photometry p = read(text);
        EXPECT_EQ(p.table.candela(), plain.table.candela()) << repair;
        EXPECT_TRUE(*repair == 0 || mentions(p.repairs, repair)) << repair;
        return p;
    };
    const std::string text = file.text();
    std::string crOnly = text;
    std::replace(crOnly.begin(), crOnly.end(), '\n', '\r');
    std::string spread = text;
    spread.replace(spread.find("\n1 1000 1 3"), 11, "\n1,1000,\t1\n\n3 ");
    std::string utf16 = "\xFF\xFE";
    for (const char c : text) utf16 += std::string{c, '\0'};
    same(crOnly, "");
    same(spread, "");
    same(utf16, "UTF-16");
    same("\xEF\xBB\xBF" + text, "byte-order mark");
    same(replaced(text, "TILT=NONE", "tilt = none  "), "");
    same(replaced(text, "\n0\n", "\n0.0\n"), "");
    same(replaced(text, "100.5", "1.005e2"), "");
    same(text + "7 8 9\n", "3 number(s) after the last candela value ignored");
    same(text + "\x1A", "");
    EXPECT_EQ(same(replaced(text, "] Test", "] Caf\xE9"), "").name, "Caf\xC3\xA9");
    EXPECT_TRUE(mentions(read(text + text).warnings, "a second luminaire"));
}

TEST(Ies, DecimalCommas) {
    IesFile file;
    file.candela = [](double, double v) { return 100.5 - v; };
    const Photometry plain = read(file.text());
    std::string text = file.text();
    std::replace(text.begin() + static_cast<long>(text.find("NONE")), text.end(), '.', ',');
    const Photometry p = read(text);
    EXPECT_EQ(p.table.candela(), plain.table.candela());
    EXPECT_TRUE(mentions(p.repairs, "decimal marks"));
}

TEST(Ies, RepairsValuesAndSaysSo) {
    IesFile file;
    file.candela = [](double, double v) { return v == 45 ? -5.0 : 100.0; };
    Photometry p = read(file.text());
    EXPECT_TRUE(mentions(p.warnings, "1 negative intensities (down to -5 cd) set to 0"));
    EXPECT_EQ(p.table.candela()[1], 0);

    file = {};
    file.vertical = {0, 45, 45, 90};
    EXPECT_TRUE(mentions(read(file.text()).repairs, "1 duplicate vertical angle(s) dropped"));
    file.candela = [](double, double v) { return 100 + v; };
    file.vertical = {90, 45, 0};
    p = read(file.text());
    EXPECT_TRUE(mentions(p.repairs, "vertical angles fall"));
    EXPECT_FLOAT_EQ(p.table.intensity({0, 0, -1}), 100);

    file = {};
    file.multiplier = 0;
    EXPECT_TRUE(mentions(read(file.text()).repairs, "candela multiplier 0 taken as 1"));
    file.multiplier = 1;
    file.horizontal = steps(0, 360, 90);
    file.candela = [](double c, double) { return c == 360 ? 90.0 : 100.0; };
    EXPECT_TRUE(mentions(read(file.text()).warnings, "differ by up to 10 cd (10.0 % of the maximum)"));
    file = {};
    file.watts = 1;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "628 lm/W is more than any lamp gives"));
    file = {};
    file.firstLine = "label";
    file.vertical = {-90, 0, 90};
    file.horizontal = {-90, 0, 90};
    EXPECT_EQ(read(file.text()).table.type(), PhotometryType::A);
}

TEST(Ies, RefusesWithPlaceSeenAndExpected) {
    const std::string text = IesFile{}.text();
    EXPECT_EQ(refusal(""), "test.ies: the file is empty, expected photometric data");
    EXPECT_EQ(refusal(" \n\n"), "test.ies: the file is empty, expected photometric data");
    EXPECT_THAT(refusal("IESNA91\n\x01\x02"), HasSubstr("test.ies:2: seen the byte 0x01 at offset 8, expected text"));
    EXPECT_THAT(refusal(std::string("\0\0\0\0", 4)), HasSubstr("seen the byte 0x00"));
    EXPECT_THAT(refusal("IESNA91\nhello\n"), HasSubstr("test.ies:2: the file ends here, expected a line TILT="));
    EXPECT_THAT(refusal("IESNA91\nTILT=NONE\n"), HasSubstr("expected the number of lamps"));
    EXPECT_EQ(refusal(replaced(text, "1 1000 1 3 1 1 2", "1 NaN 1 3 1 1 2")),
              "test.ies:6: seen \"NaN\", expected the lumens per lamp (a finite number)");
    EXPECT_EQ(refusal(replaced(text, "100 100 100", "100 x 100")),
              "test.ies:10: seen \"x\", expected a candela value (a finite number)");
    EXPECT_EQ(refusal(replaced(text, "1 1000 1 3 1 1 2", "1 1000 1 3 1 7 2")),
              "test.ies:6: the photometric type (1 = C, 2 = B, 3 = A) is 7, expected a whole number from 1 to 3");
    EXPECT_EQ(refusal(replaced(text, "1 1000 1 3 1 1 2", "1 1000 1 3.5 1 1 2")),
              "test.ies:6: the number of vertical angles is 3.5, expected a whole number from 1 to 100000");
    EXPECT_EQ(
        refusal(replaced(text, "100 100 100", "100 100")),
        "test.ies:7: the file states 3 vertical and 1 horizontal angles, which take 7 numbers after this line; seen 6");
    EXPECT_THAT(refusal(replaced(text, "1 1000 1 3 1 1 2", "1 1000 1 100000 10000 1 2")),
                HasSubstr("which take 1000110000 numbers after this line; seen 7"));
    EXPECT_THAT(refusal(replaced(text, "1 1000 1 3 1 1 2", "1 1000 -1 3 1 1 2")),
                HasSubstr("candela multiplier is -1"));
    EXPECT_THAT(refusal(replaced(text, "0 45 90", "0 50 45")),
                HasSubstr("test.ies:8: vertical angle 3 is 45, expected more"));
    EXPECT_THAT(refusal(replaced(text, "0 45 90", "-90 0 90")),
                HasSubstr("expected 0..180 (types A and B have -90..90)"));
    EXPECT_THAT(refusal(replaced(text, "1 1000 1 3 1 1 2", "1 1000 1 3 1 2 2")), HasSubstr("in type A or B"));
    IesFile file;
    file.horizontal = {45, 135};
    EXPECT_THAT(refusal(file.text()), HasSubstr("test.ies:8: horizontal angles from 45 to 135, expected 0; 0..90"));
    file.horizontal = {0, 90};
    file.candela = [](double, double) { return 1e300; };
    EXPECT_THAT(refusal(file.text()), HasSubstr("expected finite and >= 0"));
}

TEST(Ies, SurvivesEveryTruncationAndManyMutations) {
    IesFile file;
    file.tilt = "TILT=INCLUDE\n1\n2\n0 90\n1 1";
    file.horizontal = steps(0, 90, 45);
    const std::string text = file.text();
    for (std::size_t n = 0; n < text.size(); ++n) (void)readIes(std::string_view(text).substr(0, n), "cut.ies");
    RandomStream random(1);
    for (int i = 0; i < 5000; ++i) {
        std::string mutated = text;
        for (std::uint64_t k = 1 + random.below(4); k-- > 0;) {
            mutated[random.below(mutated.size())] = "0123456789-+.,eE \n\t[]x\xFF"[random.below(23)];
        }
        const auto p = readIes(mutated, "mutated.ies");
        if (p) {
            EXPECT_TRUE(std::isfinite(p->table.lumens()));
        }
    }
}

// Every shared file gives lumens within 1 % of its header, or says why not.
TEST(SharedPhotometry, LumensAgreeWithTheHeaderOrAReasonIsNamed) {
    const std::filesystem::path folder = std::filesystem::path(LUXDECK_SOURCE_DIR) / "../shared/data/photometry";
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no test data at " << folder;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    ASSERT_GE(files.size(), 50U);
    std::cout << fmt::format("{:<44} {:>10} {:>10} {:>8}  {}\n", "file", "declared", "integrated", "%", "reason");
    for (const auto& file : files) {
        const auto p = loadPhotometry(file);
        ASSERT_TRUE(p) << p.error().text();
        const double deviation = p->lumensDeclared > 0 ? p->table.lumens() / p->lumensDeclared - 1 : 1e9;
        std::string reason;
        for (const auto& warning : p->warnings) {
            if (warning.starts_with("flux: ")) reason = warning.substr(6);
        }
        std::cout << fmt::format("{:<44.44} {:>10.6g} {:>10.6g} {:>8}  {}\n", file.filename().string(),
                                 p->lumensDeclared, p->table.lumens(),
                                 deviation < 1e8 ? fmt::format("{:+.2f}", 100 * deviation) : "-", reason);
        EXPECT_GT(p->table.lumens(), 0) << file;
        EXPECT_EQ(std::abs(deviation) <= 0.01, reason.empty())
            << file << " deviates by " << deviation << ": " << reason;
    }
}

}  // namespace
}  // namespace luxdeck

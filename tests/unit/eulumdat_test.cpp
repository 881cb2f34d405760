// readEulumdat: symmetries against the same distribution given in full, the axis convention, lamp sets, text and
// numbers as tools write them, malformed files.
#include "engine/core/rng.h"
#include "engine/io/photometry.h"
#include "tests/support/photometry_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace luxdeck {
namespace {

using namespace test;
using testing::HasSubstr;

Photometry read(const std::string& text) {
    auto p = readEulumdat(text, "test.ldt");
    EXPECT_TRUE(p) << p.error().text();
    return p ? *p : Photometry{};
}

std::string refusal(const std::string& text) {
    const auto p = readEulumdat(text, "test.ldt");
    return p ? "accepted" : p.error().text();
}

double cosine(double degrees) { return std::cos(degrees * kDegree); }
double sine(double degrees) { return std::sin(degrees * kDegree); }

struct SymmetryCase {
    int indicator;
    PhotometrySymmetry symmetry;
    std::vector<double> stored;  // planes in the file's order
    Distribution candela;        // has that symmetry over the whole turn
};

class LdtSymmetry : public testing::TestWithParam<SymmetryCase> {};

TEST_P(LdtSymmetry, IsTheSameAsTheFullFile) {
    const auto& c = GetParam();
    LdtFile file;
    file.planes = c.indicator == 1 ? std::vector<double>{0} : steps(0, 345, 15);
    file.gammas = steps(0, 180, 15);
    file.symmetry = c.indicator;
    file.stored = c.stored;
    file.candelaPer1000lm = c.candela;
    const Photometry part = read(file.text());
    file.symmetry = 0;
    file.planes = file.stored = steps(0, 345, 15);
    const Photometry full = read(file.text());
    EXPECT_EQ(part.symmetry, c.symmetry);
    EXPECT_EQ(full.symmetry, PhotometrySymmetry::None);
    RandomStream random(5);
    for (int i = 0; i < 500; ++i) {
        const Vec3 d = Vec3(float(random.normal()), float(random.normal()), float(random.normal())).normalized();
        // The same planes, so the same to float rounding of values up to 1000.
        ASSERT_NEAR(part.table.intensity(d), full.table.intensity(d), 2e-3);
    }
}

std::vector<double> from270To90() {
    auto planes = steps(270, 345, 15);
    for (const double c : steps(0, 90, 15)) planes.push_back(c);
    return planes;
}

INSTANTIATE_TEST_SUITE_P(
    All, LdtSymmetry,
    testing::Values(SymmetryCase{1, PhotometrySymmetry::Axial, {0}, [](double, double g) { return 100 + g; }},
                    SymmetryCase{2, PhotometrySymmetry::Bilateral0to180, steps(0, 180, 15),
                                 [](double c, double g) { return 500 + 300 * cosine(c) + g; }},
                    SymmetryCase{3, PhotometrySymmetry::Bilateral90to270, from270To90(),
                                 [](double c, double g) { return 500 + 300 * sine(c) + g; }},
                    SymmetryCase{4, PhotometrySymmetry::Quadrant, steps(0, 90, 15),
                                 [](double c, double g) { return 500 + 200 * cosine(2 * c) + g; }}));

TEST(Eulumdat, Symmetry3StartsAtC270) {
    // 1, 2, 3 in the order of the file are C270, C0 and C90; read from C90 the luminaire would face backwards.
    LdtFile file;
    file.symmetry = 3;
    file.planes = {0, 90, 180, 270};
    file.stored = {270, 0, 90};
    file.candelaPer1000lm = [](double c, double g) { return g < 90 ? 0.0 : c == 270 ? 1.0 : c == 0 ? 2.0 : 3.0; };
    const auto table = read(file.text()).table;
    EXPECT_NEAR(table.intensity({0, -1, 0}), 1, 1e-5);
    EXPECT_NEAR(table.intensity({1, 0, 0}), 2, 1e-5);
    EXPECT_NEAR(table.intensity({-1, 0, 0}), 2, 1e-5);
    EXPECT_NEAR(table.intensity({0, 1, 0}), 3, 1e-5);
}

TEST(Eulumdat, AllPlanesStoredDespiteASymmetry) {
    LdtFile file;
    file.symmetry = 3;
    file.planes = file.stored = {0, 90, 180, 270};
    file.candelaPer1000lm = [](double c, double) { return 100 + c; };
    const Photometry p = read(file.text());
    EXPECT_EQ(p.symmetry, PhotometrySymmetry::None);
    EXPECT_TRUE(mentions(p.repairs, "all 4 C planes are stored"));
    EXPECT_NEAR(p.table.intensity({0, -1, 0}), 370, 1e-3);
}

TEST(Eulumdat, LengthRunsAlongC90) {
    // A tube along C90-C270 is 1.2 m long as seen from C0: its side of that length faces x. In LM-63, whose length
    // runs along 0-180, the same lamp turned by 90 degrees has width 1.2 and length 0.1.
    LdtFile file;
    file.luminousLength = 1200;
    file.luminousWidth = 100;
    Photometry p = read(file.text());
    EXPECT_EQ(p.opening.shape, OpeningShape::Rectangle);
    EXPECT_DOUBLE_EQ(p.opening.lengthM, 0.1);
    EXPECT_DOUBLE_EQ(p.opening.widthM, 1.2);

    IesFile ies;
    ies.width = 1.2;
    ies.length = 0.1;
    EXPECT_DOUBLE_EQ(readIes(ies.text(), "a.ies")->opening.widthM, p.opening.widthM);

    file.luminousHeights[0] = file.luminousHeights[1] = file.luminousHeights[2] = file.luminousHeights[3] = 50;
    p = read(file.text());
    EXPECT_EQ(p.opening.shape, OpeningShape::Box);
    EXPECT_DOUBLE_EQ(p.opening.heightM, 0.05);
    file.luminousHeights[0] = 0;
    EXPECT_TRUE(mentions(read(file.text()).repairs, "taken as their mean, 37.5 mm"));
}

TEST(Eulumdat, WidthZeroIsRound) {
    LdtFile file;
    file.luminousLength = 400;
    Photometry p = read(file.text());
    EXPECT_EQ(p.opening.shape, OpeningShape::Disc);
    EXPECT_DOUBLE_EQ(p.opening.lengthM, 0.4);
    EXPECT_DOUBLE_EQ(p.opening.widthM, 0.4);
    for (double& height : file.luminousHeights) height = 80;
    EXPECT_EQ(read(file.text()).opening.shape, OpeningShape::Cylinder);
    file.luminousLength = 0;
    EXPECT_EQ(read(file.text()).opening.shape, OpeningShape::Point);
}

TEST(Eulumdat, IntensitiesArePer1000LumensOfTheFirstLampSet) {
    LdtFile file;
    file.lampSets = {"2\nFirst\n3000\n4000\n80\n70", "1\nSecond\n9999\n4000\n80\n99"};
    file.conversion = "0.5";
    const Photometry p = read(file.text());
    EXPECT_FLOAT_EQ(p.table.intensity({0, 0, -1}), 100 * 3 * 0.5F);
    EXPECT_EQ(p.lamp, "First");
    EXPECT_EQ(p.watts, 70);
    EXPECT_TRUE(mentions(p.repairs,
                         "2 lamp sets, which are alternatives: the first, \"First\" (3000 lm), is used; not used: "
                         "\"Second\" (9999 lm)"));
}

TEST(Eulumdat, DeclaredFluxDownwardShareAndReasons) {
    LdtFile file;  // 100 cd/klm over the lower half: 62.83 % of the lamps
    file.outputPercent = 62.8;
    Photometry p = read(file.text());
    EXPECT_DOUBLE_EQ(p.lumensDeclared, 628);
    EXPECT_FALSE(mentions(p.warnings, "flux:"));
    EXPECT_FALSE(mentions(p.warnings, "downward share"));
    file.downwardPercent = 80;
    EXPECT_TRUE(
        mentions(read(file.text()).warnings, "downward share: 100.00 % from the intensities, 80.00 % in the header"));
    file.outputPercent = 62.83 / 0.8;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "flux: only the lower hemisphere is stored"));
    file.outputPercent = 0;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "flux: the header states a flux of 0"));
    file.outputPercent = 20;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "flux: table and header contradict each other"));

    // 100 cd written as they are beside 5000 lm lamps: 628.3 lm, 12.566 % of them.
    file = {};
    file.lampSets = {"1\nLamp\n5000\n4000\n80\n70"};
    file.outputPercent = 62.83 / 5;
    EXPECT_TRUE(mentions(read(file.text()).warnings, "flux: the intensities look absolute"));
    file.lampSets = {"-1\nLED\n1000\n4000\n80\n10"};
    EXPECT_TRUE(read(file.text()).absolute);
}

TEST(Eulumdat, HeaderOfAProgramThatDropsThePlaneC180) {
    // As in one shared file: the mean over C0..C175 instead of the whole turn.
    LdtFile file;
    file.symmetry = 2;
    file.planes = steps(0, 350, 10);
    file.stored = steps(0, 180, 10);
    file.gammas = steps(0, 90, 5);
    file.candelaPer1000lm = [](double c, double) { return 50 + c; };
    // Planes 50, 60 .. 220 without the last: mean 135 cd/klm against the true 140; 2 pi sr give 848.2 lm.
    file.outputPercent = 84.82;
    EXPECT_TRUE(mentions(read(file.text()).warnings,
                         "flux: the header's flux is a zonal sum that leaves out the last stored plane"));
}

TEST(Eulumdat, TextAndNumbersAsToolsWriteThem) {
    LdtFile file;
    file.name =
        "Stra\xDF"
        "enleuchte";  // ISO-8859-1
    file.candelaPer1000lm = [](double, double g) { return 100.5 - g; };
    const Photometry crlf = read(file.text());
    EXPECT_EQ(crlf.name,
              "Stra\xC3\x9F"
              "enleuchte");
    file.lineEnd = "\n";
    const std::string text = file.text();
    EXPECT_EQ(read(text).table.candela(), crlf.table.candela());
    std::string commas = text;
    std::replace(commas.begin(), commas.end(), '.', ',');
    EXPECT_EQ(read(commas).table.candela(), crlf.table.candela());
    EXPECT_EQ(read("\xEF\xBB\xBF" + text).manufacturer, "Maker");
    EXPECT_EQ(read(text + "\n\n\n").table.candela(), crlf.table.candela());
    EXPECT_TRUE(mentions(read(text + "7\n").repairs, "1 line(s) after the last intensity ignored"));
    EXPECT_DOUBLE_EQ(read(replaced(text, "Lamp\n1000\n", "Lamp\n10 080,5\n")).lumensDeclared, 10080.5);
    EXPECT_DOUBLE_EQ(read(replaced(text, "Lamp\n1000\n", "Lamp\n1.000,5\n")).lumensDeclared, 1000.5);
    EXPECT_TRUE(mentions(read(replaced(text, "3000\n80\n50\n", "warm\n1B\n\n")).repairs,
                         "the power of the lamps is \"\", taken as 0"));
    EXPECT_TRUE(mentions(read(replaced(text, "\n1000\n", "\n0\n")).repairs, "lamp flux 0"));
    EXPECT_TRUE(mentions(read(replaced(text, "\n55.5\n", "\n-3\n")).warnings, "1 negative intensities"));
}

TEST(Eulumdat, EqualGammasAreSteps) {
    LdtFile file;
    file.gammas = {0, 45, 45, 90};
    const auto p = readEulumdat(file.text(), "test.ldt");
    ASSERT_TRUE(p) << p.error().text();
    EXPECT_EQ(p->table.vertical().size(), 3U) << "rows that agree are one";
}

TEST(Eulumdat, AnglesThatAreAllZeroComeFromTheStep) {
    LdtFile file;
    const std::string good = file.text();
    std::string zeros = replaced(good, "0\r\n45\r\n90\r\n", "0\r\n0\r\n0\r\n");
    EXPECT_THAT(refusal(zeros), HasSubstr("gamma angle 2 is 0, expected more than the one before, 0"));
    zeros = replaced(zeros, "\r\n3\r\n0\r\nReport", "\r\n3\r\n45\r\nReport");
    const Photometry p = read(zeros);
    EXPECT_EQ(p.table.vertical(), (std::vector<double>{0, 45, 90}));
    EXPECT_TRUE(mentions(p.repairs, "gamma angles are all 0"));
}

TEST(Eulumdat, RefusesWithPlaceSeenAndExpected) {
    const std::string text = LdtFile{}.text();
    EXPECT_EQ(refusal(""), "test.ldt: the file is empty, expected photometric data");
    EXPECT_THAT(refusal("Maker\n1\n1\n"), HasSubstr("test.ldt:3: the file ends here, expected the number of C planes"));
    EXPECT_EQ(refusal(replaced(text, "Maker\r\n1\r\n1\r\n", "Maker\r\n1\r\n5\r\n")),
              "test.ldt:3: the symmetry indicator is 5, expected a whole number from 0 to 4");
    EXPECT_EQ(refusal(replaced(text, "Lamp\r\n1000", "Lamp\r\nnan")),
              "test.ldt:29: seen \"nan\", expected the total flux of the lamps (a finite number)");
    EXPECT_EQ(refusal(replaced(text, "Maker\r\n1\r\n1\r\n1\r\n", "Maker\r\n1\r\n1\r\n99999\r\n")),
              "test.ldt:42: the file states 99999 C planes and 3 gamma angles; only 7 lines follow this one");
    EXPECT_EQ(refusal(text.substr(0, text.size() - 5)),
              "test.ldt:46: 1 planes of 3 intensities take 3 lines after this one; seen 2");
    EXPECT_EQ(refusal(replaced(text, "100\r\n100\r\n100\r\n", "100\r\n\r\n100\r\n")),
              "test.ldt:48: seen \"\", expected an intensity (a finite number)");
    LdtFile file;
    file.symmetry = 3;
    file.planes = {0, 120, 240};
    file.stored = {0, 120, 240};
    EXPECT_THAT(refusal(file.text()), HasSubstr("no C plane at 270 degrees"));
    file = {};
    file.gammas = {0, 60, 45};
    EXPECT_EQ(refusal(file.text()), "test.ldt:46: gamma angle 3 is 45, expected more than the one before, 60");
    file.gammas = {0, 200};
    EXPECT_THAT(refusal(file.text()), HasSubstr("vertical angle 1 is 200, expected 0..180"));
}

TEST(Eulumdat, SurvivesEveryTruncationAndManyMutations) {
    LdtFile file;
    file.symmetry = 4;
    file.planes = steps(0, 315, 45);
    file.stored = steps(0, 90, 45);
    const std::string text = file.text();
    for (std::size_t n = 0; n < text.size(); ++n) (void)readEulumdat(std::string_view(text).substr(0, n), "cut.ldt");
    RandomStream random(1);
    for (int i = 0; i < 5000; ++i) {
        std::string mutated = text;
        for (std::uint64_t k = 1 + random.below(4); k-- > 0;) {
            mutated[random.below(mutated.size())] = "0123456789-+.,eE \n\t[]x\xFF"[random.below(23)];
        }
        const auto p = readEulumdat(mutated, "mutated.ldt");
        if (p) {
            EXPECT_TRUE(std::isfinite(p->table.lumens()));
        }
    }
}

TEST(LoadPhotometry, TellsTheFormatByExtensionElseByContent) {
    const auto folder = std::filesystem::temp_directory_path() / "luxdeck_photometry_test";
    std::filesystem::create_directories(folder);
    const auto load = [&](const char* name, const std::string& text) {
        std::ofstream(folder / name, std::ios::binary) << text;
        const auto p = loadPhotometry(folder / name);
        return p ? p->format : p.error().message;
    };
    EXPECT_EQ(load("a.IES", IesFile{}.text()), "LM-63-2002");
    EXPECT_EQ(load("a.ldt", LdtFile{}.text()), "EULUMDAT");
    EXPECT_EQ(load("a.txt", IesFile{}.text()), "LM-63-2002");
    EXPECT_EQ(load("b.txt", LdtFile{}.text()), "EULUMDAT");
    EXPECT_EQ(load("swapped.ies", LdtFile{}.text()), "EULUMDAT");
    EXPECT_EQ(load("swapped.ldt", IesFile{}.text()), "LM-63-2002");
    EXPECT_THAT(loadPhotometry(folder / "swapped.ldt")->warnings,
                ::testing::Contains(HasSubstr("its name ends with .ldt, but it holds IES LM-63")));
    EXPECT_THAT(load("page.ies", "<!DOCTYPE html>\n<html>not found</html>\n"), HasSubstr("a web page"));
    EXPECT_EQ(load("c.txt", "hello\n"), "neither an IES LM-63 nor an EULUMDAT file");
    const auto missing = loadPhotometry(folder / "missing.ies");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::FileNotFound);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace luxdeck

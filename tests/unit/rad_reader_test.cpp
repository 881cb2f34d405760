#include "engine/io/rad_material.h"
#include "engine/io/rad_polygon.h"
#include "engine/io/rad_reader.h"
#include "engine/io/rad_surface.h"
#include "engine/io/rad_view.h"
#include "engine/io/rad_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

class RadReader : public testing::Test {
protected:
    RadReader() : folder_(fs::temp_directory_path() / ("luxdeck-rad-" + std::to_string(::getpid()))) { fs::create_directories(folder_ / "inner"); }
    ~RadReader() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }
    Scene scene(const std::string& text) {
        auto part = readRad({write("scene.rad", text)}, {});
        EXPECT_TRUE(part) << part.error().text();
        return part ? std::move(part->scene) : Scene{};
    }
    std::string error(const std::string& text) {
        const auto part = readRad({write("scene.rad", text)}, {}, {.primitives = 1000});
        return part ? "no error" : part.error().text();
    }

    fs::path folder_;
};

double area(const Scene& scene) {
    double sum = 0;
    for (const auto& mesh : scene.meshes)
        for (const auto& t : mesh.triangles)
            sum += 0.5 * double((mesh.positions[t[1]] - mesh.positions[t[0]]).cross(mesh.positions[t[2]] - mesh.positions[t[0]]).length());
    return sum;
}

const std::string kGrey = "void plastic grey 0 0 5 .5 .5 .5 0 0\n";
// Positions are floats of about 1: areas are good to a few 1e-7.
constexpr double kFloat = 1e-5;

TEST_F(RadReader, RadiancesBecomeLuminancesByRadiancesOwnWeights) {
    const auto s = scene("void light lamp 0 0 3 1 2 3\nlamp polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n");
    ASSERT_EQ(s.materials.size(), 1U);
    // 179 (0.265 + 1.34 + 0.195)
    EXPECT_NEAR(luminance(s.materials[0].emission, s.weights), 322.2, 1e-3);
    EXPECT_TRUE(s.materials[0].oneSidedEmission);
    EXPECT_TRUE(s.materials[0].reflectance.isBlack());
    EXPECT_THAT(s.warnings, IsEmpty());
}

// Bug: a window in a wall whose hole ran in the direction of the outline was filled; a real room became dark.
TEST_F(RadReader, AHoleIsAHoleWhicheverWayItRuns) {
    const std::string outline = "0 0 0  4 0 0  4 4 0  0 4 0  0 0 0 ";
    for (const auto* hole : {"1 1 0  1 3 0  3 3 0  3 1 0  1 1 0", "1 1 0  3 1 0  3 3 0  1 3 0  1 1 0"}) {
        const auto s = scene(kGrey + "grey polygon p 0 0 30 " + outline + hole);
        EXPECT_NEAR(area(s), 12, 12 * kFloat) << hole;
        EXPECT_THAT(s.warnings, IsEmpty());
    }
}

TEST_F(RadReader, SeveralHolesOfEitherDirection) {
    const auto s = scene(kGrey + "grey polygon p 0 0 48  0 0 0  1 1 0 4 1 0 4 4 0 1 4 0 1 1 0  0 0 0  9 0 0  9 9 0  8 8 0 8 5 0 5 5 0 5 8 0 8 8 0  9 9 0  0 9 0");
    EXPECT_NEAR(area(s), 81 - 9 - 9, 63 * kFloat);
}

TEST_F(RadReader, RoundEmittersHaveTheirTrueArea) {
    const std::string light = "void light l 0 0 3 1 1 1\n";
    EXPECT_NEAR(area(scene(light + "l sphere s 0 0 4 0 0 0 1")), 4 * kPiD, 1e-3);
    EXPECT_NEAR(area(scene(light + "l cylinder c 0 0 7 0 0 0 0 0 2 .5")), 2 * kPiD, 1e-3);
    EXPECT_NEAR(area(scene(light + "l ring r 0 0 8 0 0 0 0 0 1 .5 1")), 0.75 * kPiD, 1e-3);
    // pi (r0 + r1) sqrt(h^2 + (r1 - r0)^2)
    EXPECT_NEAR(area(scene(light + "l cone k 0 0 8 0 0 0 0 0 1 1 .5")), kPiD * 1.5 * std::sqrt(1.25), 1e-3);
}

TEST_F(RadReader, SurfacesFaceTheirSide) {
    const auto outward = [&](const std::string& type, const std::string& numbers) {
        const auto s = scene(kGrey + "grey " + type + " x " + numbers);
        const auto& m = s.meshes.at(0);
        double sum = 0;
        for (const auto& t : m.triangles) {
            const Vec3 a = m.positions[t[0]], n = (m.positions[t[1]] - a).cross(m.positions[t[2]] - a);
            sum += double(n.dot(a - Vec3(0, 0, 0.5F)));
        }
        return sum > 0;
    };
    EXPECT_TRUE(outward("sphere", "0 0 4 0 0 .5 1"));
    EXPECT_FALSE(outward("bubble", "0 0 4 0 0 .5 1"));
    EXPECT_TRUE(outward("cylinder", "0 0 7 0 0 0 0 0 1 1"));
    EXPECT_FALSE(outward("tube", "0 0 7 0 0 0 0 0 1 1"));
    EXPECT_TRUE(outward("cone", "0 0 8 0 0 0 0 0 1 1 0"));
    EXPECT_FALSE(outward("cup", "0 0 8 0 0 0 0 0 1 1 .5"));
    EXPECT_TRUE(outward("ring", "0 0 8 0 0 1 0 0 1 0 1"));
    EXPECT_FALSE(outward("ring", "0 0 8 0 0 1 0 0 -1 0 1"));
}

TEST_F(RadReader, MaterialsKeepTheirEnergy) {
    const auto s = scene("void trans t 0 0 7 .5 .5 .5 .1 .05 .4 .25\nt sphere a 0 0 4 0 0 0 1\n"
                         "void metal m 0 0 5 .8 .6 .4 .9 .1\nm sphere b 0 0 4 3 0 0 1\nvoid glass g 0 0 3 .96 .96 .96\ng sphere c 0 0 4 6 0 0 1\n");
    ASSERT_EQ(s.materials.size(), 3U);
    EXPECT_NEAR(s.materials[0].reflectance.r, 0.5 * 0.9 * 0.6, 1e-6);
    EXPECT_NEAR(s.materials[0].diffuseTransmittance.r, 0.5 * 0.9 * 0.4 * 0.75, 1e-6);
    EXPECT_NEAR(s.materials[0].specularTransmittance.r, 0.5 * 0.9 * 0.4 * 0.25, 1e-6);
    EXPECT_NEAR(s.materials[1].specular.g, 0.54, 1e-6);
    // Radiance's manual: a transmittance of 0.88 is a transmissivity of 0.96, rounded to 0.005, times 0.92.
    EXPECT_NEAR(s.materials[2].transmittance.r, 0.88, 0.0046);
    EXPECT_NEAR(rad::paneTransmissivity(rad::paneTransmittance(0.7, 1.52), 1.52), 0.7, 1e-12);
}

TEST_F(RadReader, LaterDefinitionsChangeNothingBeforeThem) {
    const auto s = scene("void plastic a 0 0 5 .1 .1 .1 0 0\nvoid alias b a\na sphere x 0 0 4 0 0 0 1\nvoid plastic a 0 0 5 .9 .9 .9 0 0\n"
                         "a sphere y 0 0 4 3 0 0 1\nb sphere z 0 0 4 6 0 0 1\n");
    ASSERT_EQ(s.materials.size(), 2U);
    EXPECT_FLOAT_EQ(s.materials[0].reflectance.r, 0.1F);
}

TEST_F(RadReader, CommandsAndPipesMakeSurfaces) {
    EXPECT_NEAR(area(scene(kGrey + "!genbox grey b 1 2 3 | xform -s 2 -t 5 0 0")), 4 * 22, 88 * kFloat);
    EXPECT_NEAR(area(scene(kGrey + "!genprism grey p 3 0 0 3 0 0 4 -l 0 0 1")), 2 * 6 + 12, 24 * kFloat);
    write("part.rad", kGrey + "grey polygon q 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n");
    EXPECT_NEAR(area(scene("!xform -a 3 -t 2 0 0 -a 2 -t 0 2 0 part.rad")), 6, 6 * kFloat);
    EXPECT_NEAR(area(scene("!cat part.rad | xform -s 3")), 9, 9 * kFloat);
    EXPECT_NEAR(area(scene(kGrey + "!gensurf grey s s t 0 4 4")), 1, kFloat);
    EXPECT_NEAR(area(scene("void light l 0 0 3 1 1 1\n!genrev l r t 1 2")), 2 * kPiD, 1e-3);
}

TEST_F(RadReader, SkiesAndSunsAreFoundAgain) {
    const auto s = scene("!gensky 6 21 12 +s -a 40 -o 74 -m 75\nskyfunc glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\n");
    EXPECT_EQ(s.sky.domes.size(), 1U);
    ASSERT_EQ(s.sky.suns.size(), 1U);
    EXPECT_GT(s.sky.suns[0].direction.z, 0.9F);  // 40 degrees north, midsummer noon: 73 degrees high
    EXPECT_THAT(s.warnings, IsEmpty());
}

TEST_F(RadReader, NothingOutsideOfTheNamedFoldersIsOpened) {
    const auto secret = write("secret.rad", kGrey);
    fs::create_symlink(secret, folder_ / "inner" / "link.rad");
    for (const auto& name : {std::string("../secret.rad"), secret.string(), std::string("link.rad")}) {
        std::ofstream(folder_ / "inner" / "main.rad") << "!xform " << name << "\n";
        const auto part = readRad({folder_ / "inner" / "main.rad"}, {});
        ASSERT_FALSE(part) << name;
        EXPECT_THAT(part.error().text(), HasSubstr("main.rad:1:"));
    }
}

TEST_F(RadReader, RefusalsNameFileAndLine) {
    EXPECT_THAT(error("\nvoid antimatter a 1 void 0 0\na sphere s 0 0 4 0 0 0 1"), HasSubstr("scene.rad:2: the material antimatter a is not read"));
    EXPECT_THAT(error("nothing sphere s 0 0 4 0 0 0 1"), HasSubstr("'nothing' is not defined before"));
    EXPECT_THAT(error("!rm -rf x"), HasSubstr("the command 'rm', expected one that is built in"));
    EXPECT_THAT(error("!xform scene.rad"), HasSubstr("includes itself"));
    EXPECT_THAT(error(kGrey + "!xform -a 100 -t 1 0 0 -a 100 -t 0 1 0 scene.rad"), HasSubstr("at most 1000 copies"));
    EXPECT_THAT(error(kGrey + "grey sphere s 0 0 4 0 0 0 0"), HasSubstr("expected more than 0"));
    EXPECT_THAT(error(kGrey + "grey polygon s 0 0 6 0 0 0 1 0 0"), HasSubstr("expected three for each of at least 3 corners"));
    EXPECT_EQ(error("void BSDF unused 0 0 3 1 1 1\n"), "no error");
}

TEST_F(RadReader, WhatIsWrittenIsReadAsTheSame) {
    const auto before = scene("void metal m 0 0 5 .8 .6 .4 .9 .1\nm sphere b 0 0 4 .1 .2 .3 1\nvoid light l 0 0 3 1 2 3\nl ring r 0 0 8 0 0 2 0 0 -1 0 .3\n"
                              "void glass g 0 0 3 .9 .8 .7\n!genbox g box 1.1 2.2 3.3\nl source sun 0 0 4 0 1 1 .5\n");
    const auto text = writeRad(before);
    const auto after = readRad({write("m.rad", text.materials), write("g.rad", text.geometry), write("s.rad", text.sky)}, {});
    ASSERT_TRUE(after) << after.error().text();
    const auto soup = [](const Scene& s) {
        std::vector<std::vector<float>> corners;
        for (const auto& mesh : s.meshes)
            for (const auto& t : mesh.triangles) {
                corners.emplace_back();
                for (const auto v : t)
                    for (int i = 0; i < 3; ++i) corners.back().push_back(mesh.positions[v][i]);
            }
        std::sort(corners.begin(), corners.end());
        return corners;
    };
    EXPECT_EQ(soup(before), soup(after->scene));
    ASSERT_EQ(after->scene.materials.size(), before.materials.size());
    for (const auto& m : before.materials)
        for (const auto& n : after->scene.materials) {
            if (n.name != m.name) continue;
            // Floats through decimal text and two conversions.
            EXPECT_NEAR(n.specular.g, m.specular.g, 1e-5) << m.name;
            EXPECT_NEAR(n.transmittance.b, m.transmittance.b, 1e-5) << m.name;
            EXPECT_NEAR(n.emission.b, m.emission.b, 1e-5 * m.emission.b) << m.name;
        }
    EXPECT_EQ(after->scene.sky.suns.size(), 1U);
}

TEST(RadView, ReadsAndWritesViews) {
    const auto view = parseView("rvu -vtv -vp 1 2 3 -vd 0 2 0 -vu 0 0 1 -vh 60 -vv 40 -vo 0 -va 0", "a.vf");
    ASSERT_TRUE(view) << view.error().text();
    EXPECT_EQ(view->position, Vec3d(1, 2, 3));
    EXPECT_EQ(view->direction, Vec3d(0, 1, 0));
    EXPECT_EQ(view->verticalFovDeg, 40);
    // 800 tan 30 / tan 20, to the pixel
    EXPECT_NEAR(view->width, 1269, 1);
    const auto again = parseView(viewLine(*view), "b.vf");
    ASSERT_TRUE(again);
    EXPECT_EQ(again->width, view->width);
    EXPECT_THAT(parseView("-vth -vp 0 0 0", "a.vf").error().text(), HasSubstr("a.vf: -vth, a hemispherical fisheye view"));
    EXPECT_THAT(parseView("-vtv -vp 0 x 0", "a.vf").error().text(), HasSubstr("-vp has 'x', expected a number"));
    EXPECT_THAT(parseView("hello", "a.vf").error().text(), HasSubstr("has no view"));
}

}  // namespace
}  // namespace luxdeck

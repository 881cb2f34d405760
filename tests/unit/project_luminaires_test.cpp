#include "engine/io/project.h"

#include "tests/support/photometry_files.h"
#include "tests/support/project_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

/// How luminaires are aimed, and what their lamps make of it.
namespace luxdeck::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class ProjectLuminaires : public ProjectTest {
protected:
    /// A project of one luminaire of b.ies.
    Result<Project> one(const std::string& aim, const std::string& type = {}) {
        return load(std::string(kHead) + "[[luminaire_type]]\nid = \"B\"\nfile = \"b.ies\"\n" + type +
                    "[[luminaire]]\ntype = \"B\"\nposition = [0, 0, 2]\n" + aim);
    }
    Luminaire placed(const std::string& aim, const std::string& type = {}) {
        const auto project = one(aim, type);
        EXPECT_TRUE(project) << project.error().text();
        return project ? project->scene.luminaires.at(0) : Luminaire{};
    }
    std::string refusal(const std::string& aim) {
        const auto project = one(aim);
        EXPECT_FALSE(project);
        return project ? std::string() : project.error().text();
    }
};

/// A flood of type B that gives 800 cd up and to the right of its aim, 100, 200 and 400 elsewhere.
IesFile flood() {
    IesFile file;
    file.type = 2;
    file.vertical = steps(-90, 90, 10);
    file.horizontal = steps(-90, 90, 10);
    file.candela = [](double h, double v) { return (h > 0 ? 4 : 1) * (v > 0 ? 2 : 1) * 100.0; };
    return file;
}

/// The bug: a flood aimed at the horizon lay on its side: its "up" was carried along by the smallest turn.
TEST_F(ProjectLuminaires, AFloodIsAimedAsTheTradeAimsIt) {
    write("b.ies", flood().text());
    const auto candela = [&](const std::string& aim, const Vec3& towards) {
        const auto project = one(aim);
        EXPECT_TRUE(project) << project.error().text();
        if (!project) return -1.0F;
        const auto& f = project->scene.luminaires[0].frame;
        const auto d = towards.normalized();
        const Vec3 local(dot(d, f.tangent), dot(d, f.bitangent), dot(d, f.normal));
        return project->scene.luminaireTypes[0].photometry.table.intensity(local);
    };
    // Aimed north, the right hand is east: up and right is (+, +, +).
    for (const char* aim : {"aim = [0, 1, 0]\n", "orient = 90\ntilt = 90\n", "aim = [0, 1, 0]\nrotation_deg = 90\n"}) {
        EXPECT_FLOAT_EQ(candela(aim, {0.3F, 1, 0.3F}), 800) << aim;
        EXPECT_FLOAT_EQ(candela(aim, {-0.3F, 1, 0.3F}), 200) << aim;
        EXPECT_FLOAT_EQ(candela(aim, {0.3F, 1, -0.3F}), 400) << aim;
        EXPECT_FLOAT_EQ(candela(aim, {-0.3F, 1, -0.3F}), 100) << aim;
    }
    EXPECT_FLOAT_EQ(candela("aim = [-1, 0, -1]\n", {-1, 0.3F, -0.6F}), 800) << "north is the right hand of west";
    EXPECT_FLOAT_EQ(candela("orient = 180\ntilt = 45\n", {-1, 0.3F, -0.6F}), 800);
    EXPECT_FLOAT_EQ(candela("orient = 90\ntilt = 90\nspin = 180\n", {-0.3F, 1, -0.3F}), 800);
    EXPECT_FLOAT_EQ(candela("aim = [0, 1, 0]\nrotation_deg = 0\n", {0.3F, 1, -0.3F}), 800) << "a rotation given is obeyed";
}

TEST_F(ProjectLuminaires, TypeCKeepsTheSmallestTurn) {
    write("b.ies", IesFile{}.text());
    EXPECT_NEAR(placed("aim = [0, 1, 0]\n").frame.tangent.x, 1, 1e-6F);
    EXPECT_NEAR(placed("orient = 90\ntilt = 90\n").frame.tangent.z, 1, 1e-6F);
    EXPECT_NEAR(placed("roll = 90\n").frame.normal.y, -1, 1e-6F);
}

TEST_F(ProjectLuminaires, BothWaysOfAimingAreRefusedByName) {
    write("b.ies", IesFile{}.text());
    EXPECT_THAT(refusal("aim = [0, 1, 0]\ntilt = 90\n"), HasSubstr("tilt and aim"));
    EXPECT_THAT(refusal("rotation_deg = 10\nspin = 90\n"), HasSubstr("spin and rotation_deg"));
    EXPECT_THAT(refusal("orient = 5000\n"), HasSubstr("orient is 5000"));
}

/// TILT was read and only told: a luminaire of a metal halide lamp tilted by 90 degrees shone as if it hung.
TEST_F(ProjectLuminaires, TheLampKnowsHowItsLuminaireIsTilted) {
    IesFile file;
    file.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1.0 0.9 0.8";
    write("b.ies", file.text());
    EXPECT_EQ(placed("").fluxScale, 1);
    EXPECT_NEAR(placed("aim = [1, 0, 0]\n").fluxScale, 0.8, 1e-6);   // floats of the frame
    EXPECT_NEAR(placed("tilt = 67.5\n").fluxScale, 0.85, 1e-6);
    EXPECT_EQ(placed("tilt = 67.5\n", "lamp_tilt = false\n").fluxScale, 1);
    const auto project = one("array = { count = [2, 1], spacing = [1, 1] }\naim = [1, 0, 0]\n");
    EXPECT_THAT(project->scene.warnings, Contains(HasSubstr("luminaire type \"B\": 2 are tilted and shine with 0.8..0.8")));
    EXPECT_THAT(one("")->scene.warnings, Not(Contains(HasSubstr("are tilted"))));
    write("LAMP.TLT", "1\n2\n0 90\n1.0 0.5\n");
    file.tilt = "TILT=LAMP.TLT";
    write("b.ies", file.text());
    EXPECT_NEAR(placed("aim = [1, 0, 0]\n").fluxScale, 0.5, 1e-6);
}

TEST_F(ProjectLuminaires, WhatLooksWrongInAPhotometricFileIsToldOfTheProject) {
    write("b.ies", LdtFile{}.text());
    EXPECT_THAT(one("")->scene.warnings,
                Contains(HasSubstr("luminaire type \"B\": b.ies: its name ends with .ies, but it holds EULUMDAT")));
}

TEST_F(ProjectLuminaires, WeatherWithABadFieldServesItsOtherHours) {
    const std::string header = "LOCATION,Here,XX,TST,made up,0,45,0,0,0\nD\nT\nG\nH\nC\nC\nDATA PERIODS,1,1,Data,Sunday,6/21,6/21\n";
    const auto row = [](int hour, const std::string& direct) {
        return "1999,6,21," + std::to_string(hour) + ",60,?,21.0,12.5,58,101300,1200,1330,360,700," + direct + ",250\n";
    };
    write("Year.EPW", header + row(12, "oops") + row(13, "500") + row(77, "500"));
    const auto at = [&](const std::string& sky, double hour) {
        const auto project = load(std::string(kHead) + "[sky]\n" + sky + "weather = \"Year.EPW\"\ndate = \"06-21\"\nhour = " +
                                  std::to_string(hour) + "\n");
        return project ? std::string() : project.error().text();
    };
    EXPECT_EQ(at("kind = \"perez\"\n", 12.5), "");
    EXPECT_THAT(at("kind = \"perez\"\n", 11.5), HasSubstr("Year.EPW:9: field 15 is \"oops\""));
    EXPECT_EQ(at("kind = \"cie-clear\"\nhorizontal_lux = 10000\n", 11.5), "") << "it needs the sun's place alone";
    EXPECT_THAT(at("kind = \"perez\"\n", 15), HasSubstr("1 of its rows have no date that can be read"));
}

}  // namespace
}  // namespace luxdeck::test

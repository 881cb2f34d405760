// Patterns: what a scene's functions and data give on surfaces, beside closed forms.
#include "engine/io/cal_builtin.h"
#include "engine/io/image_files.h"
#include "engine/io/pattern_radiance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CalPatterns : public testing::Test {
protected:
    CalPatterns() : folder_(fs::temp_directory_path() / ("luxdeck-cal-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_ / "scene");
    }
    ~CalPatterns() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    [[nodiscard]] Result<std::shared_ptr<const Pattern>> make(PatternKind kind, std::vector<std::string> strings,
                                                              std::vector<double> reals = {},
                                                              const Matrix4d& toWorld = {}) const {
        CalLibrary library({folder_ / "scene"});
        return makePattern(kind, {std::move(strings), std::move(reals), folder_ / "scene", toWorld, "s.rad:3"},
                           library);
    }
    [[nodiscard]] std::shared_ptr<const Pattern> made(PatternKind kind, std::vector<std::string> strings,
                                                      std::vector<double> reals = {},
                                                      const Matrix4d& toWorld = {}) const {
        auto result = make(kind, std::move(strings), std::move(reals), toWorld);
        EXPECT_TRUE(result) << result.error().text();
        return result ? *result : nullptr;
    }
    [[nodiscard]] std::string error(PatternKind kind, std::vector<std::string> strings,
                                    std::vector<double> reals = {}) const {
        const auto result = make(kind, std::move(strings), std::move(reals));
        return result ? "no error" : result.error().text();
    }
    fs::path folder_;
};

PatternPoint along(const Vec3d& direction, const Vec3& normal = {0, 0, 1}) {
    PatternPoint at;
    at.direction = Vec3(direction);
    at.normal = normal;
    return at;
}

/// A direction that light leaves a source in, by LM-63's angles [degrees]: v from straight down, h from +x to +y.
Vec3d leaving(double v, double h) {
    const double sinV = std::sin(v * kDegree);
    return {sinV * std::cos(h * kDegree), sinV * std::sin(h * kDegree), -std::cos(v * kDegree)};
}

// Values pass through float directions and a float result: 6e-8 each, times some slopes of 10.
constexpr double kFloat = 2e-6;

TEST_F(CalPatterns, BuiltInFilesAllCompile) {
    for (const auto name : cal::builtinFileNames())
        EXPECT_TRUE(cal::Module::parse(cal::builtinFile(name), std::string(name))) << name;
    const std::vector<double> reals(15, 0.4);
    const std::vector<std::pair<std::string, std::vector<std::string>>> names = {
        {"source.cal",
         {"src_theta", "src_phi", "src_phi2+90", "src_phi4", "srcB_vert+360", "srcB_horiz+360", "srcB_vert2",
          "srcB_horiz2", "corr(1)", "flatcorr(1)", "boxcorr(1)", "lboxcorr(1)", "cylcorr(1)"}},
        {"tilt.cal", {"tilt_ang", "tilt_ang2", "tilt_xang", "tilt_xang2"}},
        {"skybright.cal", {"skybr", "skybright"}},
        {"perezlum.cal", {"skybr", "skybright"}},
        {"picture.cal",
         {"pic_u", "pic_v", "tile_u", "tile_v", "match_u", "match_v", "stag_u", "stag_v", "inpic", "fadered(1,1,1)",
          "fadegreen(1,1,1)", "fadeblue(1,1,1)", "fadegrey(1,1,1)", "infore(1,1,1)"}},
        {"tmesh.cal", {"dx+2", "dy+2", "dz+2", "u", "v"}},
        {"surf.cal", {"surf_dx", "surf_dy", "surf_dz"}},
        {"rev.cal", {"rev_dx+9", "rev_dy+9", "rev_dz"}},
        {"illum.cal", {"il_alt+1", "il_azi", "il_alth", "il_azih"}},
        {".",
         {"U+9", "V+9", "D(1)+1", "N(2)+1", "P(3)+1", "turbulence(Px,Py,Pz,.1)", "turbulencea(Px,Py,Pz,.1)+9",
          "nrand(Px)+9", "noise3d(1,Px,Py,Pz)+1", "AC", "S", "Tx+1", "Iy+1", "Kz", "NxP+1", "RdotP", "T", "Ts", "Lu"}}};
    PatternPoint at = along({0.48, 0.6, -0.64}, {-0.6F, 0, 0.8F});
    at.position = {0.2, 0.3, 0.4};
    at.distance = 2;
    for (const auto& [file, expressions] : names)
        for (const auto& expression : expressions) {
            const auto pattern = made(PatternKind::BrightFunc, {expression, file}, reals);
            ASSERT_TRUE(pattern) << file << " " << expression;
            EXPECT_TRUE(std::isfinite(pattern->value(at).r)) << file << " " << expression;
        }
}

TEST_F(CalPatterns, SourceAnglesAreThoseOfLm63) {
    const auto theta = made(PatternKind::BrightFunc, {"src_theta", "source.cal"});
    const auto phi = made(PatternKind::BrightFunc, {"src_phi", "source.cal"});
    const auto phi2 = made(PatternKind::BrightFunc, {"src_phi2", "source.cal"});
    const auto phi4 = made(PatternKind::BrightFunc, {"src_phi4", "source.cal"});
    for (double v = 5; v < 180; v += 25)
        for (double h = 1; h < 360; h += 31) {
            const auto at = along(leaving(v, h) * -1.0);  // rays go against the light
            // acos and atan2 of float directions: 6e-8 / sin(5 degrees), in degrees 4e-5.
            constexpr double kAngle = 1e-4;
            EXPECT_NEAR(theta->value(at).r, v, kAngle);
            EXPECT_NEAR(phi->value(at).r, h, kAngle);
            EXPECT_NEAR(phi2->value(at).r, h <= 180 ? h : 360 - h, kAngle);
            const double half = h <= 180 ? h : 360 - h;
            EXPECT_NEAR(phi4->value(at).r, half <= 90 ? half : 180 - half, kAngle);
        }
}

TEST_F(CalPatterns, PhotometricLightsGiveTheirIntensity) {
    // What ies2rad writes for a flat luminaire of 0.6 m x 0.2 m: candelas / 179 in the data, 1 / area as multiplier.
    const double area = 0.6 * 0.2;
    const auto candela = [](double h, double v) { return 1790 + 17.9 * v - 3.58 * h; };
    std::string data = "2\n0 90 4\n0 90 7\n";
    for (int h = 0; h <= 90; h += 30)
        for (int v = 0; v <= 90; v += 15) data += std::to_string(candela(h, v) / 179) + "\n";
    write("scene/lamp.dat", data);
    const auto flat =
        made(PatternKind::BrightData, {"flatcorr", "lamp.dat", "source.cal", "src_phi4", "src_theta"}, {1 / area});
    for (double v = 4; v < 89; v += 4)  // straight down all planes meet, and these data do not
        for (double h = 0; h <= 90; h += 9) {
            const Vec3d out = leaving(v, h);
            const double radiance = flat->value(along(out * -1.0, {0, 0, -1})).r;
            const double cosine = -out.z;
            // Bilinear data are exact; six digits in the file, float angles: 1e-5 of the intensity in all, and the
            // cosine's own 6e-8 / cos(88 degrees).
            EXPECT_NEAR(radiance * area * cosine * 179, candela(h, v), 1e-5 * candela(h, v)) << v << " " << h;
        }
    // A box and a cylinder are divided by the area that is seen from there.
    write("scene/even.dat", "1\n0 180 2\n10 10\n");
    const auto box =
        made(PatternKind::BrightData, {"boxcorr", "even.dat", "source.cal", "src_theta"}, {2, 0.6, 0.2, 0.1});
    const auto cylinder =
        made(PatternKind::BrightData, {"cylcorr", "even.dat", "source.cal", "src_theta"}, {2, 0.3, 0.5});
    const auto sphere = made(PatternKind::BrightData, {"corr", "even.dat", "source.cal", "src_theta"}, {2});
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200; ++i) {
        const Vec3d d = Vec3d(normal(random), normal(random), normal(random)).normalized();
        const double boxArea = std::abs(d.x) * 0.02 + std::abs(d.y) * 0.06 + std::abs(d.z) * 0.12;
        const double cylinderArea = 0.15 * std::hypot(d.x, d.y) + kPiD / 4 * 0.09 * std::abs(d.z);
        EXPECT_NEAR(box->value(along(d)).r * boxArea, 20, 20 * kFloat);
        EXPECT_NEAR(cylinder->value(along(d)).r * cylinderArea, 20, 20 * kFloat);
        EXPECT_FLOAT_EQ(sphere->value(along(d)).r, 20);
    }
}

TEST_F(CalPatterns, SkiesFollowTheirFormulas) {
    const Vec3d sun = Vec3d(0.3, -0.5, 0.6).normalized();
    const double zenithAngle = std::acos(sun.z);
    const double normalization = 0.274 * (0.91 + 10 * std::exp(-3 * zenithAngle) + 0.45 * sun.z * sun.z);
    const std::vector<double> reals{1, 90, 5, normalization, sun.x, sun.y, sun.z};
    const auto with = [&](double kind) {
        auto r = reals;
        r[0] = kind;
        return made(PatternKind::BrightFunc, {"skybr", "skybright.cal"}, r);
    };
    const auto clear = with(1), overcast = with(2), uniform = with(3), intermediate = with(4);
    const auto perez = made(PatternKind::BrightFunc, {"skybright", "perezlum.cal"},
                            {3, 5, -1, -0.32, 10, -3, 0.45, sun.x, sun.y, sun.z});
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 300; ++i) {
        const Vec3d d = Vec3d(normal(random), normal(random), std::abs(normal(random)) + 0.02).normalized();
        const double chi = std::acos(d.dot(sun)), zeta = std::acos(d.z);
        const double up = std::pow(d.z + 1.01, 10), down = 1 / up;
        const auto blended = [&](double sky) { return (up * sky + down * 5) / (up + down); };
        const double indicatrix = 0.91 + 10 * std::exp(-3 * chi) + 0.45 * std::pow(std::cos(chi), 2);
        const double cie = 90 * indicatrix * (1 - std::exp(-0.32 / d.z)) / normalization;
        const double gradation = 1 - std::exp(-0.32 / std::max(d.z, 0.01));
        const double relative = gradation * (1 + 10 * std::exp(-3 * chi) + 0.45 * std::pow(std::cos(chi), 2));
        const double nakamura =
            90 / normalization *
            ((1.35 * std::sin(5.631 - 3.59 * zeta) + 3.12) * std::sin(4.396 - 2.6 * zenithAngle) + 6.37 - zeta) /
            2.326 * std::exp(-0.563 * chi * ((2.629 - zeta) * (1.562 - zenithAngle) + 0.812));
        // Float directions under a tenth power, and near the sun under 10 exp(-3 chi) whose slope is 30.
        constexpr double kSky = 5e-5;
        EXPECT_NEAR(clear->value(along(d)).r / blended(cie), 1, kSky);
        EXPECT_NEAR(overcast->value(along(d)).r / blended(90 * (1 + 2 * d.z) / 3), 1, kSky);
        EXPECT_NEAR(uniform->value(along(d)).r / blended(90), 1, kSky);
        EXPECT_NEAR(intermediate->value(along(d)).r / blended(nakamura), 1, kSky);
        EXPECT_NEAR(perez->value(along(d)).r / blended(3 * relative), 1, kSky);
    }
    // gensky gives an overcast sky three arguments: what clear skies need is not asked for.
    EXPECT_EQ(made(PatternKind::BrightFunc, {"skybr", "skybright.cal"}, {2, 90, 5})->value(along({0, 0.6, 0.8})),
              overcast->value(along({0, 0.6, 0.8})));
    // Far below the horizon there is the ground.
    EXPECT_NEAR(overcast->value(along({0, 0, -1})).r, 5, 1e-3);
}

TEST_F(CalPatterns, TransformsAreUndone) {
    // Scaled by 2, turned by 90 degrees about z (x to y), moved.
    Matrix4d m;
    m[0][0] = 0, m[0][1] = 2, m[1][0] = -2, m[1][1] = 0, m[2][2] = 2, m[3][0] = 10, m[3][1] = 20, m[3][2] = 30;
    PatternPoint at = along({0.6, 0, -0.8});
    at.position = Vec3d(1, 2, 3) * m;
    at.distance = 4;
    const auto value = [&](const char* expression) {
        return made(PatternKind::BrightFunc, {std::string("100+(") + expression + ")", "."}, {}, m)->value(at).r - 100;
    };
    const struct {
        const char* expression;
        double value;
    } cases[] = {{"Px", 1},  {"Py", 2}, {"Pz", 3}, {"Dx", 0},     {"Dy", -0.6}, {"Dz", -0.8},
                 {"Nz", 1},  {"T", 2},  {"Ts", 2}, {"Rdot", 0.8}, {"S", 0.5},   {"Ix", 0},
                 {"Iy", -1}, {"Jx", 1}, {"Kz", 1}, {"Tx", -10},   {"Ty", 5},    {"Tz", -15}};
    for (const auto& c : cases)
        EXPECT_NEAR(value(c.expression), c.value, 1e-5) << c.expression;  // a float of about 100
    EXPECT_THAT(make(PatternKind::BrightFunc, {"Px", "."}, {}, Matrix4d(0.0)).error().text(),
                HasSubstr("s.rad:3: a transform"));
    CalLibrary library({folder_});
    const auto expressions =
        makeRayExpressions(std::array<std::string, 2>{"Px", "CrP"}, ".", {{}, {}, folder_, m, "s.rad:3"}, library);
    ASSERT_TRUE(expressions);
    std::array<double, 2> values{};
    (*expressions)->evaluate(at, Rgb{0.25F}, values);
    EXPECT_NEAR(values[0], 1, 1e-12);
    EXPECT_EQ(values[1], 0.25);
    const Vec3d turned = (*expressions)->toWorld({1, 0, 0});
    EXPECT_NEAR((turned - Vec3d(0, 1, 0)).length(), 0, 1e-12);
}

TEST_F(CalPatterns, EveryKindReadsItsArguments) {
    write("scene/f.cal", "half(v) = v/2; sum(r,g,b) = r+g+b; mix = Px; big = 7*Px;");
    write("scene/a.dat", "1 0 1 2  0 1");
    write("scene/b.dat", "1 0 1 2  0 2");
    write("scene/c.dat", "1 0 1 2  0 3");
    PatternPoint at = along({0, 0, -1});
    at.position = {0.5, 0.25, 0};
    const auto value = [&](PatternKind kind, std::vector<std::string> strings) {
        return made(kind, std::move(strings))->value(at);
    };
    EXPECT_EQ(value(PatternKind::BrightFunc, {"mix*2", "f.cal"}), Rgb{1.0F});
    EXPECT_EQ(value(PatternKind::ColorFunc, {"Px", "Py", "1", "."}), Rgb(0.5F, 0.25F, 1));
    EXPECT_EQ(value(PatternKind::BrightData, {"half", "b.dat", "f.cal", "-Py+1"}), Rgb{0.75F});
    EXPECT_EQ(value(PatternKind::ColorData, {"noop", "half", "sum", "a.dat", "b.dat", "c.dat", "f.cal", "Px"}),
              Rgb(0.5F, 0.5F, 3));
    EXPECT_EQ(value(PatternKind::MixFunc, {"front", "back", "mix", "f.cal"}), Rgb{0.5F});
    EXPECT_EQ(value(PatternKind::MixFunc, {"front", "back", "big", "f.cal"}), Rgb{1.0F});  // a fraction
    EXPECT_EQ(value(PatternKind::MixData, {"front", "back", "half", "a.dat", "f.cal", "Px"}), Rgb{0.25F});
    EXPECT_TRUE(std::isnan(value(PatternKind::BrightFunc, {"-1", "."}).r));
    EXPECT_TRUE(std::isnan(value(PatternKind::BrightFunc, {"1/(Px-.5)", "."}).r));
    EXPECT_EQ(patternKind("mixpict"), PatternKind::MixPict);
    EXPECT_FALSE(patternKind("plastic"));
    const std::vector<std::string> strings{"corr", "a.dat", "source.cal", "-Px", "Py", "-rz", "90"};
    EXPECT_EQ(firstTransformArgument(PatternKind::BrightData, strings), 5U);
    EXPECT_NE(made(PatternKind::BrightFunc, {"A1", "."}, {1})->identity(),
              made(PatternKind::BrightFunc, {"A1", "."}, {2})->identity());
    EXPECT_EQ(made(PatternKind::BrightFunc, {"A1", "."}, {1})->identity(),
              made(PatternKind::BrightFunc, {"A1", "."}, {1})->identity());
}

TEST_F(CalPatterns, PicturesComeRawWithTheirShorterSideOne) {
    // Three by two pixels; the file's exposure is not taken out, as in Radiance.
    std::string bytes = "#?RADIANCE\nEXPOSURE=4\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 3\n";
    for (const int level : {128, 160, 192, 64, 96, 112})  // the upper row first
        bytes += {static_cast<char>(level), static_cast<char>(level / 2), 0, static_cast<char>(129)};
    write("scene/p.hdr", bytes);
    const auto red = [](int level) { return (level + 0.5) / 128; };  // mantissas stand for the middle of their interval
    const auto pattern =
        made(PatternKind::ColorPict, {"red", "green", "blue", "p.hdr", "picture.cal", "pic_u", "pic_v"});
    const auto mix = made(PatternKind::MixPict, {"a", "b", "red", "p.hdr", "picture.cal", "pic_u", "pic_v"});
    const auto at = [&](double u, double v) {
        PatternPoint p = along({0, 0, -1});
        p.position = {u, v, 0};
        return p;
    };
    // The matrix there and back in float: 1e-6 of the value.
    EXPECT_NEAR(pattern->value(at(0, 0)).r, red(64), 1e-5);
    EXPECT_NEAR(pattern->value(at(1.5, 0)).r, red(112), 1e-5);
    EXPECT_NEAR(pattern->value(at(0, 1)).r, red(128), 1e-5);
    EXPECT_NEAR(pattern->value(at(1.5, 1)).g, red(96), 1e-5);
    EXPECT_NEAR(pattern->value(at(0.375, 0)).r, red(80), 1e-5);  // between the first two
    EXPECT_NEAR(mix->value(at(0, 0)).r, red(64), 1e-5);
}

TEST_F(CalPatterns, FilesAreFoundInTheirFoldersAndNowhereElse) {
    write("secret.cal", "x = 1;");
    write("scene/own.cal", "x = 2;");
    write("scene/source.cal", "src_theta = 77;");  // before what is built in
    fs::create_symlink(folder_ / "secret.cal", folder_ / "scene/link.cal");
    const auto kind = PatternKind::BrightFunc;
    EXPECT_EQ(made(kind, {"x", "own.cal"})->value({}), Rgb{2.0F});
    EXPECT_EQ(made(kind, {"x", (folder_ / "scene/own.cal").string()})->value({}), Rgb{2.0F});
    EXPECT_EQ(made(kind, {"src_theta", "source.cal"})->value({}), Rgb{77.0F});
    for (const auto& name : {std::string("../secret.cal"), std::string("link.cal"), (folder_ / "secret.cal").string()})
        EXPECT_THAT(error(kind, {"x", name}), testing::AllOf(HasSubstr("s.rad:3: "), HasSubstr("outside"))) << name;
    EXPECT_THAT(error(kind, {"x", "gone.cal"}),
                testing::AllOf(HasSubstr("s.rad:3: 'gone.cal' is not found"), HasSubstr((folder_ / "scene").string()),
                               HasSubstr("source.cal")));
    EXPECT_THAT(error(PatternKind::BrightData, {"noop", "gone.dat", ".", "Px"}), HasSubstr("'gone.dat' is not found"));
}

TEST_F(CalPatterns, WhatIsWrongIsSaidWithItsPlace) {
    write("scene/bad.cal", "a = 1;\nb = 2 +;\n");
    write("scene/lazy.cal", "\nx = y;\nz = A3;\nforever(v) = forever(v+1);\n");
    write("scene/a.dat", "2 0 1 2 0 1 2 1 2 3 4");
    const auto kind = PatternKind::BrightFunc;
    EXPECT_THAT(error(kind, {"a", "bad.cal"}),
                testing::AllOf(HasSubstr("bad.cal:2: ';', expected"), HasSubstr("asked for by s.rad:3")));
    EXPECT_THAT(error(kind, {"x", "lazy.cal"}), HasSubstr("lazy.cal:2: 'y' is not defined"));
    EXPECT_THAT(error(kind, {"z", "lazy.cal"}, {1, 2}),
                HasSubstr("asks for a real argument that is not given (2 real"));
    EXPECT_THAT(error(kind, {"forever(Px)", "lazy.cal"}), HasSubstr("without end"));
    EXPECT_THAT(error(kind, {"1 +", "."}), HasSubstr("s.rad:3: in the expression '1 +': the end, expected"));
    EXPECT_THAT(error(kind, {"CrP", "."}), HasSubstr("only materials have a colour"));
    EXPECT_THAT(error(kind, {"1"}), HasSubstr("has 1 string arguments, expected at least 2"));
    EXPECT_THAT(error(PatternKind::BrightData, {"noop", "a.dat", ".", "Px"}),
                HasSubstr("1 variables for data of 2 dimensions"));
    EXPECT_THAT(error(PatternKind::BrightData, {"nope", "a.dat", ".", "Px", "Py"}), HasSubstr("'nope' is not defined"));
}

TEST_F(CalPatterns, ThreadsGetTheSameBits) {
    write("scene/t.cal",
          "f(n) = if(n-.5, noise3(Px*n,Py,Pz) + f(n-1), 2); w = f(5); v = w*w + turbulence(Px,Py,Pz,.1);");
    const auto pattern = made(PatternKind::BrightFunc, {"v+w", "t.cal"});
    const auto values = [&] {
        std::vector<float> result;
        std::mt19937 random(9);
        std::uniform_real_distribution<double> place(-5, 5);
        for (int i = 0; i < 2000; ++i) {
            PatternPoint at = along({0, 0, -1});
            at.position = {place(random), place(random), place(random)};
            result.push_back(pattern->value(at).r);
        }
        return result;
    };
    const auto expected = values();
    std::vector<std::vector<float>> got(8);
    std::vector<std::thread> threads;
    for (auto& result : got) threads.emplace_back([&] { result = values(); });
    for (auto& thread : threads) thread.join();
    for (const auto& result : got)
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_TRUE(result[i] == expected[i] || (std::isnan(result[i]) && std::isnan(expected[i])));
}

}  // namespace
}  // namespace luxdeck

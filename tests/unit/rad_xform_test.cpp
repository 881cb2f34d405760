#include "engine/io/rad_transform.h"
#include "engine/io/xform.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace luxdeck::rad {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

// Rounding of a few turns in double.
constexpr double kRounding = 1e-12;

using Words = std::vector<std::string>;

Xform xform(const Words& words) {
    std::size_t used = 0;
    const auto x = parseXform(words, used);
    EXPECT_TRUE(x) << x.error().text();
    EXPECT_EQ(used, words.size());
    return *x;
}

void expectNear(const Vec3d& a, const Vec3d& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], kRounding) << i;
}

XformCommand command(const Words& words) {
    auto c = parseXformCommand(words, 1000);
    EXPECT_TRUE(c) << c.error().text();
    return *c;
}

Primitive surface(const std::string& type, std::vector<double> numbers) {
    return {"mat", type, "thing", {}, std::move(numbers), {}, {std::make_shared<const std::string>("a.rad"), 1}, nullptr};
}

Primitive moved(const Primitive& p, const Words& words) {
    const auto c = command(words);
    auto result = transformed(p, c.copies.at(0));
    EXPECT_TRUE(result) << result.error().text();
    return *result;
}

TEST(Xform, StepsGoInTheirOrder) {
    expectNear(xform({"-t", "1", "0", "0", "-rz", "90"}).point({0, 0, 0}), {0, 1, 0});
    expectNear(xform({"-rz", "90", "-t", "1", "0", "0"}).point({0, 0, 0}), {1, 0, 0});
    expectNear(xform({"-rx", "90"}).point({0, 1, 0}), {0, 0, 1});
    expectNear(xform({"-ry", "90"}).point({0, 0, 1}), {1, 0, 0});
    expectNear(xform({"-s", "2", "-mx"}).point({1, 2, 3}), {-2, 4, 6});
    EXPECT_TRUE(xform({"-mx"}).mirrored);
    EXPECT_FALSE(xform({"-mx", "-my"}).mirrored);
    EXPECT_EQ(xform({"-s", "2", "-s", "3"}).scale, 6);
}

TEST(Xform, IterationsRepeatWhatFollowsThem) {
    expectNear(xform({"-i", "3", "-t", "1", "0", "0"}).point({0, 0, 0}), {3, 0, 0});
    expectNear(xform({"-i", "0", "-t", "1", "0", "0"}).point({0, 0, 0}), {0, 0, 0});
    expectNear(xform({"-t", "0", "5", "0", "-i", "2", "-t", "1", "0", "0", "-i", "1", "-rz", "90"}).point({0, 0, 0}), {-5, 2, 0});
}

TEST(Xform, ArraysNestAndNumberTheirCopies) {
    const auto c = command({"-n", "desk", "-a", "2", "-t", "10", "0", "0", "-a", "3", "-t", "0", "1", "0", "a.rad", "b.rad"});
    ASSERT_EQ(c.copies.size(), 6U);
    EXPECT_THAT(c.files, ElementsAre("a.rad", "b.rad"));
    EXPECT_EQ(c.copies[4].prefix, "desk.1.1");
    expectNear(c.copies[4].xform.point({0, 0, 0}), {10, 1, 0});
    expectNear(c.copies[0].xform.point({0, 0, 0}), {0, 0, 0});
    EXPECT_EQ(command({"-a", "2", "-t", "1", "0", "0"}).copies[1].prefix, "a1");
}

TEST(Xform, RefusesByName) {
    const auto text = [](const Words& words) {
        const auto c = parseXformCommand(words, 1000);
        return c ? std::string() : c.error().message;
    };
    EXPECT_THAT(text({"-q", "a.rad"}), HasSubstr("'-q'"));
    EXPECT_THAT(text({"-t", "1", "x", "0"}), HasSubstr("'x', expected a number"));
    EXPECT_THAT(text({"-s", "0"}), HasSubstr("a factor that is not 0"));
    EXPECT_THAT(text({"-a", "0", "-t", "1", "0", "0"}), HasSubstr("-a has 0"));
    EXPECT_THAT(text({"-a", "100", "-t", "1", "0", "0", "-a", "100", "-t", "0", "1", "0"}), HasSubstr("at most 1000 copies"));
}

// Bug to guard against: a mirror turns a polygon's order about, and with it the side that a light shines to.
TEST(Xform, AMirroredPolygonKeepsFacingItsMirroredSide) {
    const auto p = surface("polygon", {0, 0, 0, 1, 0, 0, 1, 1, 0});  // faces +z
    EXPECT_THAT(moved(p, {"-mx"}).numbers, Pointwise(DoubleNear(kRounding), {-1.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
    EXPECT_THAT(moved(p, {"-I"}).numbers, Pointwise(DoubleNear(kRounding), {1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
}

TEST(Xform, SurfacesChangeAsRadianceChangesThem) {
    EXPECT_EQ(moved(surface("sphere", {0, 0, 0, 1}), {"-I"}).type, "bubble");
    EXPECT_EQ(moved(surface("tube", {0, 0, 0, 0, 0, 1, 1}), {"-I"}).type, "cylinder");
    EXPECT_THAT(moved(surface("sphere", {1, 0, 0, 1}), {"-s", "2", "-t", "0", "0", "1"}).numbers, ElementsAre(2, 0, 1, 2));
    EXPECT_THAT(moved(surface("ring", {0, 0, 0, 0, 0, 1, 1, 2}), {"-I", "-s", "3"}).numbers, ElementsAre(0, 0, 0, 0, 0, -1, 3, 6));
    EXPECT_THAT(moved(surface("source", {0, 0, 1, 5}), {"-rx", "180", "-t", "9", "9", "9"}).numbers, Pointwise(DoubleNear(kRounding), {0.0, 0.0, -1.0, 5.0}));
    const auto named = moved(surface("sphere", {0, 0, 0, 1}), {"-n", "a", "-m", "red"});
    EXPECT_EQ(named.name, "a.thing");
    EXPECT_EQ(named.modifier, "red");
    EXPECT_FALSE(transformed(surface("sphere", {0, 0, 0}), command({"-I"}).copies[0]));
}

TEST(Xform, ModifiersKeepTheirNamesAndScaleWhatIsByLength) {
    const auto glow = moved(surface("glow", {1, 1, 1, 2}), {"-n", "a", "-m", "x", "-s", "3"});
    EXPECT_EQ(glow.name, "thing");
    EXPECT_EQ(glow.modifier, "mat");
    EXPECT_THAT(glow.numbers, ElementsAre(1, 1, 1, 6));
    // Half as much of the light passes a unit; scaled by 2, a new unit is half an old one.
    EXPECT_THAT(moved(surface("dielectric", {0.25, 0.25, 0.25, 1.5, 0}), {"-s", "2"}).numbers, ElementsAre(0.5, 0.5, 0.5, 1.5, 0));
}

TEST(Xform, PatternsTakeTheTransformIntoTheirArguments) {
    auto pattern = surface("brightfunc", {});
    pattern.strings = {"f", "f.cal", "-t", "1", "0", "0"};
    EXPECT_THAT(moved(pattern, {"-rz", "90"}).strings, ElementsAre("f", "f.cal", "-t", "1", "0", "0", "-i", "1", "-rz", "90"));
}

}  // namespace
}  // namespace luxdeck::rad

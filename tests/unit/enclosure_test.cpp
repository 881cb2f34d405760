#include "engine/transport/enclosure.h"

#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

Result<void> checked(Scene scene) {
    const Lit lit(std::move(scene));
    return checkThatLightIsLost(lit.transport());
}

Scene whiteRoom(float reflectance) {
    SceneBuilder b;
    return b.box({0, 0, 0}, {4, 4, 4}, b.matte(reflectance), true).isotropic({2, 2, 2}, 1000).build();
}

TEST(LightIsLost, NotInAClosedRoomThatReflectsEverything) {
    const auto refused = checked(whiteRoom(1));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidArgument);
    EXPECT_THAT(refused.error().message, HasSubstr("never lost"));
    EXPECT_TRUE(checked(whiteRoom(0.999F)));
}

TEST(LightIsLost, ThroughAWindowOrByOneDarkWall) {
    SceneBuilder b;
    const auto white = b.matte(1), dark = b.matte(0.5F);
    b.quad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, white).quad({0, 0, 4}, {0, 4, 0}, {4, 0, 0}, white).quad({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, white);
    b.quad({0, 4, 0}, {4, 0, 0}, {0, 0, 4}, white).quad({0, 0, 0}, {0, 4, 0}, {0, 0, 4}, white).isotropic({2, 2, 2}, 1000);
    EXPECT_TRUE(checked(SceneBuilder(b).build()));
    EXPECT_TRUE(checked(SceneBuilder(b).quad({4, 0, 0}, {0, 0, 4}, {0, 4, 0}, dark).build()));
    EXPECT_FALSE(checked(SceneBuilder(b).quad({4, 0, 0}, {0, 0, 4}, {0, 4, 0}, white).build()));
}

// The closed white box stands in an ordinary room, a lamp in each: the one in the box is named.
TEST(LightIsLost, NamesTheLightThatIsNot) {
    SceneBuilder b;
    b.box({0, 0, 0}, {4, 4, 4}, b.matte(0.5F), true).box({1, 1, 1}, {2, 2, 2}, b.matte(1), true);
    const auto refused = checked(b.isotropic({3, 3, 3}, 1000).isotropic({1.5F, 1.5F, 1.5F}, 1000).build());
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("\"T2\""));
}

TEST(MeanReflectance, IsByArea) {
    SceneBuilder b;
    b.quad({0, 0, 0}, {3, 0, 0}, {0, 1, 0}, b.matte(0.8F)).quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, b.matte(0.2F));
    EXPECT_NEAR(meanReflectance(b.build()), (3 * 0.8 + 0.2) / 4, 1e-6);  // float's fractions
    EXPECT_EQ(meanReflectance(Scene{}), 0);
}

// Bug: two panels in the same place, as exporters leave them, gave twice the light of one by next-event estimation.
TEST(CoincidentEmitters, ShineOnce) {
    SceneBuilder b;
    const auto glow = b.glowing(100, 0), matte = b.matte(0.5F);
    b.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glow).quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glow);
    b.quad({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, glow);  // the other side up: another light
    b.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, matte).quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, matte);
    const Scene scene = b.build();
    EXPECT_EQ(scene.triangleCount(), 8U);
    EXPECT_TRUE(scene.meshes[1].triangles.empty());
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_THAT(scene.warnings[0], HasSubstr("2 emitting triangles"));
}

}  // namespace
}  // namespace luxdeck::test

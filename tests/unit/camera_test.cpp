#include "analysis/pictures/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace luxdeck {
namespace {

View viewOf(ViewKind kind) {
    View view;
    view.kind = kind;
    view.position = {1, 2, 1.5};
    view.direction = {0, 3, 0};
    view.verticalFovDeg = 60;
    view.width = 800, view.height = 400;
    return view;
}

void expectDirection(const std::optional<Ray>& ray, const Vec3& expected) {
    ASSERT_TRUE(ray);
    EXPECT_LT((ray->direction - expected.normalized()).length(), 1e-6F) << ray->direction << " is not " << expected;  // float rounding
}

TEST(Camera, PerspectiveIsAPinhole) {
    const Camera camera(viewOf(ViewKind::Perspective), Scene{});
    const float t = std::tan(static_cast<float>(30 * kDegree));
    const auto middle = camera.ray(400, 200);
    expectDirection(middle, {0, 1, 0});
    EXPECT_EQ(middle->origin, Vec3(1, 2, 1.5F));
    EXPECT_EQ(middle->tMin, 0);
    expectDirection(camera.ray(400, 0), {0, 1, t});
    expectDirection(camera.ray(400, 400), {0, 1, -t});
    expectDirection(camera.ray(0, 200), {-2 * t, 1, 0});  // square pixels: twice as wide as high
    expectDirection(camera.ray(800, 0), {2 * t, 1, t});
}

TEST(Camera, FisheyeAnglesGrowWithTheRadius) {
    const Camera camera(viewOf(ViewKind::Fisheye), Scene{});
    expectDirection(camera.ray(400, 200), {0, 1, 0});
    for (int i = 1; i <= 9; ++i) {
        const auto theta = static_cast<float>(10 * i * kDegree), r = 200 * theta / (kPi / 2) * (i == 9 ? 0.99999F : 1);
        // At the very rim the radius is kept just inside: 90 degrees less 1e-5 of it.
        const auto ray = camera.ray(400 + r, 200);
        ASSERT_TRUE(ray);
        EXPECT_NEAR(std::acos(std::clamp(ray->direction.y, -1.0F, 1.0F)), theta, 5e-4F) << "acos loses half the digits near 1";
        EXPECT_GT(ray->direction.x, 0);
        expectDirection(camera.ray(400, 200 - r), {0, ray->direction.y, ray->direction.x});
    }
}

TEST(Camera, FisheyeHasNothingOutsideItsCircle) {
    const Camera camera(viewOf(ViewKind::Fisheye), Scene{});
    int inside = 0;
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 800; ++x) {
            const float dx = static_cast<float>(x) - 399.5F, dy = static_cast<float>(y) - 199.5F, r = std::sqrt(dx * dx + dy * dy);
            const auto ray = camera.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            if (std::abs(r - 200) > 0.01F) { ASSERT_EQ(ray.has_value(), r < 200) << x << ", " << y; }
            inside += ray ? 1 : 0;
            if (ray) { ASSERT_NEAR(ray->direction.length(), 1, 1e-6F); }
        }
    EXPECT_NEAR(inside / (kPiD * 200 * 200), 1, 1e-3);  // a lattice in a circle of radius 200
}

TEST(Camera, LooksStraightDownAndFromFarAway) {
    auto view = viewOf(ViewKind::Perspective);
    view.direction = {0, 0, -1};  // along "up"
    const auto down = Camera(view, Scene{}).ray(100, 50);
    ASSERT_TRUE(down);
    EXPECT_TRUE(isFinite(down->direction));
    Scene far;
    far.origin = {1e6, 2e6, 0};
    view.position = {1e6 + 1.25, 2e6 + 2.5, 1.5};
    EXPECT_EQ(Camera(view, far).ray(400, 200)->origin, Vec3(1.25F, 2.5F, 1.5F));
}

}  // namespace
}  // namespace luxdeck

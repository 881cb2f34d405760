#include "engine/scene/scene.h"

#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// What validate() says of a good scene after one change.
std::string refused(const std::function<void(Scene&)>& change) {
    Scene scene = furnishedRoom();
    change(scene);
    const auto ok = validate(scene);
    if (ok) return "was accepted";
    EXPECT_EQ(ok.error().code, ErrorCode::InvalidArgument);
    return ok.error().text();
}

TEST(ValidateScene, RefusesWhatTheStagesRelyOn) {
    const auto ward = [](Scene& s) -> Material& { return s.materials[0].kind = MaterialKind::Ward, s.materials[0]; };
    EXPECT_THAT(refused([&](Scene& s) { ward(s).specular = Rgb(0.9F); }), HasSubstr("expected at most 1"));
    EXPECT_THAT(refused([&](Scene& s) { ward(s).wardU = 0.1F; }), HasSubstr("ward widths are 0.1 and 0"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].diffuseTransmittance.r = -1; }), HasSubstr("diffuse transmittance is (-1, 0, 0)"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].emissionPattern = 0; }), HasSubstr("emission pattern 0, expected one below 0"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].kind = MaterialKind::Mix; }), HasSubstr("a mixture without a pattern"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].alphaCutoff = -1; }), HasSubstr("alpha cutoff is -1"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].alpha = 2; }), HasSubstr("alpha is 2"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].reflectance.g = 1.01F; }), HasSubstr("reflectance is (0.65, 1.01, 0.65), expected fractions 0..1"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[1].specular.b = -0.1F; }), HasSubstr("material 1"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].transmittance.r = kNan; }), HasSubstr("transmittance"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].roughness = 1.5F; }), HasSubstr("roughness is 1.5"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].metallic = kNan; }), HasSubstr("metallic"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].ior = 0.9F; }), HasSubstr("ior is 0.9, expected 1..4"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].emission.r = kInfinity; }), HasSubstr("emission"));
    EXPECT_THAT(refused([](Scene& s) { s.materials[0].emissionTexture.texture = 0; }), HasSubstr("texture 0, expected one below 0"));
    EXPECT_THAT(refused([](Scene& s) { s.meshes[0].material = 99; }), HasSubstr("material 99"));
    EXPECT_THAT(refused([](Scene& s) { s.meshes[0].object = 99; }), HasSubstr("object 99"));
    EXPECT_THAT(refused([](Scene& s) { s.meshes[0].positions[3].y = kNan; }), HasSubstr("vertex 3"));
    EXPECT_THAT(refused([](Scene& s) { s.meshes[0].normals.resize(1); }), HasSubstr("1 normals"));
    EXPECT_THAT(refused([](Scene& s) { s.meshes[0].triangles[1][2] = 1'000'000; }), HasSubstr("triangle 1 names vertex 1000000"));
    EXPECT_THAT(refused([](Scene& s) { s.luminaires[0].type = 99; }), HasSubstr("type 99"));
    EXPECT_THAT(refused([](Scene& s) { s.luminaires[1].position.z = kNan; }), HasSubstr("luminaire 1"));
    EXPECT_THAT(refused([](Scene& s) { s.luminaires[2].dimming = -1; }), HasSubstr("output scale is -1"));
}

TEST(ValidateScene, DropsTrianglesWithoutAreaAndSaysSo) {
    Scene scene = furnishedRoom();
    const auto count = scene.triangleCount();
    scene.meshes[0].triangles.push_back({0, 0, 1});
    scene.meshes[0].positions.insert(scene.meshes[0].positions.end(), {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
    scene.meshes[0].normals.clear(), scene.meshes[0].uvs.clear();
    const auto last = static_cast<std::uint32_t>(scene.meshes[0].positions.size());
    scene.meshes[0].triangles.push_back({last - 3, last - 2, last - 1});
    ASSERT_TRUE(validate(scene));
    EXPECT_EQ(scene.triangleCount(), count);
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_THAT(scene.warnings[0], HasSubstr("2 triangles without area"));
}

TEST(Scene, BoundsAndOrigin) {
    EXPECT_TRUE(Scene().bounds().isEmpty());
    Scene scene = cubeRoom(0.5F, 1000);
    EXPECT_EQ(scene.bounds().min, Vec3(0, 0, 0));
    EXPECT_EQ(scene.bounds().max, Vec3(4, 4, 4));
    scene.luminaires[0].position = {2, 2, 9};
    EXPECT_EQ(scene.bounds().max.z, 9.0F);
    scene.origin = {1e6, -2e6, 3};
    EXPECT_EQ(scene.toUser({1, 2, 3}), Vec3d(1e6 + 1, -2e6 + 2, 6));
    EXPECT_EQ(scene.toRebased(scene.toUser({0.25F, 0.5F, 1})), Vec3(0.25F, 0.5F, 1));
}

// The hash changes with the light, and with nothing else.
TEST(SceneHash, CoversWhatChangesTheLight) {
    const Scene base = richRoom();
    const auto hash = sceneHash(base);
    EXPECT_EQ(sceneHash(richRoom()), hash);
    const std::function<void(Scene&)> changes[] = {
        [](Scene& s) { s.meshes[0].positions[0].x += 0.001F; }, [](Scene& s) { s.meshes[0].material = 0; },
        [](Scene& s) { std::swap(s.meshes[0].triangles[0][0], s.meshes[0].triangles[0][1]); },
        [](Scene& s) { s.materials[0].reflectance.r += 0.01F; }, [](Scene& s) { s.materials[0].roughness = 0.9F; },
        [](Scene& s) { s.materials[0].oneSidedEmission = false; }, [](Scene& s) { s.materials[0].reflectanceTexture.offset.x = 0.5F; },
        [](Scene& s) { s.textures[0].rgba[0] = 1; }, [](Scene& s) { s.luminaires[0].dimming = 0.5; },
        [](Scene& s) { s.luminaires[0].position.z += 0.1F; }, [](Scene& s) { s.luminaireTypes[0].photometry.opening.lengthM = 0.3; },
        [](Scene& s) { s.luminaireTypes[0].colour.r = 1.1F; }, [](Scene& s) { s.sky.zenithCdM2 = 1; },
        [](Scene& s) { s.sky.groundReflectance = 0.3; }, [](Scene& s) { s.origin.x = 1; }, [](Scene& s) { s.weights.r = 0.3; }};
    int index = -1;
    for (const auto& change : changes) {
        Scene scene = base;
        ++index;
        change(scene);
        EXPECT_NE(sceneHash(scene), hash) << "change " << index;
    }
    Scene renamed = base;
    renamed.name = "other", renamed.meshes[0].name = "other", renamed.materials[0].source = "other", renamed.warnings.push_back("w");
    EXPECT_EQ(sceneHash(renamed), hash);
}

TEST(Sky, HorizontalIlluminanceIsTheIntegralOfItsRadiance) {
    for (const auto kind : {SkyKind::None, SkyKind::Uniform, SkyKind::CieOvercast}) {
        const Sky sky{kind, 3000, 0.2, Rgb(1.0F)};
        double lux = 0;
        constexpr int kSteps = 1000;  // midpoints of a quadratic: an error of 1e-6
        for (int i = 0; i < kSteps; ++i) {
            const float z = (static_cast<float>(i) + 0.5F) / kSteps;
            lux += sky.radiance({std::sqrt(1 - z * z), 0, z}).g * z * 2 * kPiD / kSteps;
        }
        EXPECT_NEAR(sky.horizontalLux(), lux, 1e-5 * lux);
        // The ground is Lambert's, lit by all of the sky.
        EXPECT_NEAR(sky.radiance({0, 0, -1}).g * kPiD, 0.2 * lux, 1e-5 * lux);
    }
    EXPECT_FALSE((Sky{SkyKind::Uniform, 0, 0.2, Rgb(1.0F)}).present());
}

}  // namespace
}  // namespace luxdeck::test

// Volumes of scenes in which something moved, and volumes of pictures.
#include "engine/volume/field.h"
#include "engine/volume/volume_pictures.h"
#include "engine/volume/volume_update.h"

#include "engine/io/image_files.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace luxdeck::test {
namespace {

namespace fs = std::filesystem;

/// Two rooms behind a wall, a lamp in each, a box in the left one.
Scene twoRooms(float boxX) {
    SceneBuilder b;
    b.box({0, 0, 0}, {6, 3, 3}, b.matte(0.5F), true, 2);
    b.quad({3.2F, 0, 0}, {0, 3, 0}, {0, 0, 3}, b.matte(0.5F));
    b.isotropic({1.5F, 1.5F, 2.5F}, 2000).isotropic({4.5F, 1.5F, 2.5F}, 1000);
    auto scene = b.build();
    SceneBuilder other;
    other.box({boxX, 1, 0}, {boxX + 0.5F, 1.5F, 0.8F}, other.matte(0.5F), false);
    auto box = other.build();
    scene.objects.push_back({"box", true});
    for (auto& mesh : box.meshes) {
        mesh.object = static_cast<std::uint32_t>(scene.objects.size() - 1), mesh.material = 0;
        scene.meshes.push_back(mesh);
    }
    return scene;
}

VolumeSettings settings() {
    VolumeSettings s;
    s.firstLevel = {5, 3, 3}, s.side = 5, s.samplesPerBin = 4;
    return s;
}

IrradianceVolume build(const Lit& lit, VertexStore* store = nullptr) {
    BuildOptions options;
    options.store = store;
    return buildVolume(lit.transport(), *lit.estimator("path"), settings(), options, Progress{}).value();
}

// No light passes the wall: what the other room's vertices keep is exactly what a new build gives them, and all others are
// made anew, so that the whole volume is that of a new build, bit for bit.
TEST(VolumeUpdate, KeepsWhatSeesNothingOfTheChange) {
    const Lit before(twoRooms(0.5F)), after(twoRooms(1.7F));
    const auto old = build(before);
    VolumeUpdate update(old, after.transport(), nullptr);
    EXPECT_THAT(update.changes(), testing::ElementsAre("object box changed"));
    const auto updated = build(after, &update);
    EXPECT_GT(update.kept(), updated.vertexCount() / 4);
    EXPECT_LT(update.kept(), updated.vertexCount());
    const auto anew = build(after);
    EXPECT_EQ(updated.lattice.vertices(), anew.lattice.vertices());
    EXPECT_EQ(updated.indirect, anew.indirect);
    const auto path = after.estimator("path");
    const auto off = update.measureKept(updated, VertexSampler::create(after.transport(), *path, settings(), 1).value());
    EXPECT_GT(off.vertices, 0U);
    EXPECT_EQ(off.relative, 0);
}

TEST(VolumeUpdate, KeepsNothingWhenTheLightsChange) {
    const auto scene = twoRooms(0.5F);
    auto dimmed = scene;
    dimmed.luminaires[0].dimming = 0.5;
    const Lit before(scene), after(dimmed);
    const auto old = build(before);
    VolumeUpdate update(old, after.transport(), nullptr);
    build(after, &update);
    EXPECT_EQ(update.kept(), 0U);
}

class Pictures : public testing::Test {
protected:
    Pictures() : folder_(fs::temp_directory_path() / ("luxdeck_pictures_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        fs::create_directories(folder_);
    }
    ~Pictures() override {
        std::error_code ec;
        fs::remove_all(folder_, ec);
    }
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
    void uniform(const std::string& name, float cdM2, int width = 64, int height = 32) const {
        Image image(width, height, {"R", "G", "B"});
        for (const auto* channel : {"R", "G", "B"})
            for (auto& v : image.channel(channel)) v = cdM2;
        image.numbers["whiteLuminance"] = 1;
        ASSERT_TRUE(writeExr(path(name), image));
    }

private:
    fs::path folder_;
};

// Invariant: energy. All of a panorama's light is in its bins: the mean radiance by solid angle, whatever lies in a pixel.
TEST(Panorama, NoPixelIsMissed) {
    Image image(64, 32, {"R", "G", "B"});
    image.channel("G")[image.index(17, 9)] = 1e6F;  // one small lamp
    const DirectionBins bins(5);
    const auto radiance = binsOfPanorama(image, -90, 90, 0, bins);
    double sum = 0;
    for (const auto& c : radiance) sum += c.g * bins.solidAngleSr();
    const double top = 90 - 9 * 180.0 / 32, bottom = top - 180.0 / 32;
    const double pixel = (std::sin(top * kDegree) - std::sin(bottom * kDegree)) * 2 * kPiD / 64;
    EXPECT_NEAR(sum, 1e6 * pixel, 5e-3 * 1e6 * pixel);  // bins' areas are counted by parts of pixels, 48 across a bin: a quarter of 1 / 48 at worst
}

TEST(Panorama, WhatItDoesNotShowHasTheDefault) {
    Image image(64, 8, {"R", "G", "B"});
    for (auto& v : image.channel("G")) v = 100;
    const DirectionBins bins(5);
    const auto radiance = binsOfPanorama(image, -22.5, 22.5, 7, bins);
    EXPECT_NEAR(radiance[static_cast<std::size_t>(bins.binOf({0, 0, 1}))].g, 7, 1e-3);
    EXPECT_NEAR(radiance[static_cast<std::size_t>(bins.binOf({0, 0, -1}))].r, 7, 1e-3);
    image.channel("G")[3] = std::nanf("");
    for (const auto& c : binsOfPanorama(image, -22.5, 22.5, 7, bins)) EXPECT_TRUE(isFinite(c));
}

TEST_F(Pictures, OfAGridBecomeAVolume) {
    uniform("a.exr", 100), uniform("b.exr", 300);
    write("nodes.toml", "[[node]]\nposition = [0, 0, 1]\npicture = \"a.exr\"\n[[node]]\nposition = [2, 0, 1]\npicture = \"b.exr\"\n");
    const auto nodes = readPanoramaNodes(path("nodes.toml"));
    ASSERT_TRUE(nodes) << nodes.error().text();
    const auto volume = buildVolumeFromPictures(*nodes, 9, Progress{});
    ASSERT_TRUE(volume) << volume.error().text();
    const auto field = VolumeField::make(*volume, {}).value();
    EXPECT_NEAR(field.at({0.5F, 0.1F, 1.2F}, {0, 0, 1}).g, 150 * kPi, 1e-3 * 150 * kPi);
}

TEST_F(Pictures, ThatFormNoGridAreRefused) {
    uniform("a.exr", 100), uniform("square.exr", 100, 32, 32);
    const auto refusal = [&](const std::string& toml) {
        write("nodes.toml", toml);
        const auto nodes = readPanoramaNodes(path("nodes.toml"));
        if (!nodes) return nodes.error().text();
        const auto volume = buildVolumeFromPictures(*nodes, 5, Progress{});
        return volume ? std::string() : volume.error().text();
    };
    const auto node = [](const std::string& at, const std::string& more = "") { return "[[node]]\nposition = [" + at + "]\npicture = \"a.exr\"\n" + more; };
    EXPECT_EQ(refusal(node("0, 0, 0")), "");
    EXPECT_THAT(refusal(node("0, 0, 0") + node("1, 0, 0") + node("3, 0, 0")), testing::HasSubstr("regular grid along x"));
    EXPECT_THAT(refusal(node("0, 0, 0") + node("1, 1, 0")), testing::HasSubstr("do not fill the grid of 2 x 2 x 1"));
    EXPECT_THAT(refusal("default = 3\n"), testing::HasSubstr("no [[node]]"));
    EXPECT_THAT(refusal(node("0, 0, 0", "latitude = [40, -40]\n")), testing::HasSubstr("nodes.toml:4"));
    EXPECT_THAT(refusal("[[node]]\nposition = [0, 0, 0]\npicture = \"square.exr\"\n"), testing::HasSubstr("expected 2 times as wide"));
    EXPECT_THAT(refusal("[[node]]\nposition = [0, 0, 0]\npicture = \"none.exr\"\n"), testing::HasSubstr("none.exr"));
}

}  // namespace
}  // namespace luxdeck::test

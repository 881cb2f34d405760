#include "engine/io/scene_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// Extensions of glTF that place, hide, thicken and light: what everyday exporters write.
namespace luxdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// A document whose numbers stand in one buffer, which is embedded.
struct Model {
    json doc = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}},
                {"nodes", {{{"mesh", 0}, {"name", "thing"}}}}};
    std::string bytes;

    int accessor(const std::vector<float>& values, const char* type, std::size_t components) {
        return raw(std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)), 5126,
                   values.size() / components, type);
    }
    int raw(const std::string& data, int componentType, std::size_t count, const char* type, bool normalized = false) {
        while (bytes.size() % 4 != 0) bytes.push_back('\0');
        doc["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}});
        bytes += data;
        doc["accessors"].push_back({{"bufferView", doc["bufferViews"].size() - 1}, {"componentType", componentType},
                                    {"count", count}, {"type", type}, {"normalized", normalized}});
        return static_cast<int>(doc["accessors"].size()) - 1;
    }
    /// A mesh of triangles without indices, of material 0.
    void mesh(const std::vector<float>& corners) {
        doc["meshes"] = {{{"name", "m"}, {"primitives", {{{"attributes", {{"POSITION", accessor(corners, "VEC3", 3)}}},
                                                          {"material", 0}}}}}};
        doc["materials"] = {{{"name", "w"}}};
    }
    json& node(std::size_t i) { return doc["nodes"][i]; }
};

class GltfExtensions : public testing::Test {
protected:
    GltfExtensions() : folder_(fs::temp_directory_path() / ("luxdeck_gltf_ext_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~GltfExtensions() override { fs::remove_all(folder_); }

    Result<ScenePart> read(const Model& m, const GeometryPlacement& placement = {}) {
        json doc = m.doc;
        std::ofstream(folder_ / "m.bin", std::ios::binary) << m.bytes;
        if (!m.bytes.empty()) doc["buffers"] = {{{"byteLength", m.bytes.size()}, {"uri", "m.bin"}}};
        std::ofstream(folder_ / "m.gltf") << doc.dump();
        return readSceneFile(folder_ / "m.gltf", placement);
    }
    Scene scene(const Model& m, const GeometryPlacement& placement = {}) {
        auto part = read(m, placement);
        EXPECT_TRUE(part) << part.error().text();
        return part ? std::move(part->scene) : Scene{};
    }
    std::string refusal(const Model& m) {
        const auto part = read(m);
        EXPECT_FALSE(part);
        return part ? std::string() : part.error().text();
    }
    fs::path folder_;
};

const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

/// A tetrahedron, each face seen from outside counter-clockwise.
std::vector<float> tetrahedron(bool insideOut = false) {
    const std::array<std::array<float, 3>, 4> p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::vector<float> corners;
    for (auto face : std::vector<std::array<std::size_t, 3>>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        if (insideOut) std::swap(face[1], face[2]);
        for (const auto i : face) corners.insert(corners.end(), p[i].begin(), p[i].end());
    }
    return corners;
}

Model triangle() {
    Model m;
    m.mesh(kTriangle);
    return m;
}

/// Glass with a thickness on a mesh.
Model glass(const std::vector<float>& corners, const json& volume) {
    Model m;
    m.mesh(corners);
    m.doc["materials"] = {{{"name", "glass"},
                           {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0}}},
                           {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                                           {"KHR_materials_volume", volume}, {"KHR_materials_ior", {{"ior", 1.5}}}}}}};
    return m;
}

TEST_F(GltfExtensions, AClosedMeshWithThicknessIsASolid) {
    const auto s = scene(glass(tetrahedron(), {{"thicknessFactor", 0.1}, {"attenuationDistance", 0.5},
                                               {"attenuationColor", {0.25, 0.5, 1}}}));
    ASSERT_EQ(s.materials.size(), 1U);
    EXPECT_EQ(s.materials[0].kind, MaterialKind::Dielectric);
    EXPECT_FLOAT_EQ(s.materials[0].ior, 1.5F);
    // 0.25 is left after half a metre, so its square after a metre.
    EXPECT_FLOAT_EQ(s.materials[0].transmittance.r, 0.0625F);
    EXPECT_FLOAT_EQ(s.materials[0].transmittance.g, 0.25F);
    EXPECT_FLOAT_EQ(s.materials[0].transmittance.b, 1);
    EXPECT_TRUE(s.warnings.empty());
}

TEST_F(GltfExtensions, AttenuationCountsInTheProjectsMetres) {
    GeometryPlacement millimetres;
    millimetres.metresPerUnit = 0.001;
    const auto s = scene(glass(tetrahedron(), {{"thicknessFactor", 1}, {"attenuationDistance", 500},
                                               {"attenuationColor", {0.25, 0.5, 1}}}), millimetres);
    EXPECT_NEAR(s.materials[0].transmittance.r, 0.0625F, 1e-6F);  // floats of a power: a few 1e-8 of 0.06
}

TEST_F(GltfExtensions, WhatIsNotClosedStaysAPane) {
    const json volume{{"thicknessFactor", 0.1}, {"attenuationDistance", 0.1}, {"attenuationColor", {0.5, 0.5, 0.5}}};
    auto corners = tetrahedron();
    corners.resize(corners.size() - 9);  // a face is missing
    for (const auto& open : {kTriangle, corners}) {
        const auto s = scene(glass(open, volume));
        EXPECT_THAT(s.warnings, testing::Contains(HasSubstr("not closed")));
        ASSERT_EQ(s.meshes.size(), 1U);
        const auto& material = s.materials[s.meshes[0].material];
        EXPECT_EQ(material.kind, MaterialKind::ThinGlass);
        // (1 - F) / (1 + F) of both faces with F = 0.04, and half of it absorbed on the thickness.
        EXPECT_NEAR(material.transmittance.g, 0.5F * 0.96F / 1.04F, 1e-6F);
    }
}

TEST_F(GltfExtensions, ASolidTurnedInsideOutIsTurnedRound) {
    const auto right = scene(glass(tetrahedron(), {{"thicknessFactor", 0.1}}));
    const auto turned = scene(glass(tetrahedron(true), {{"thicknessFactor", 0.1}}));
    EXPECT_THAT(turned.warnings, testing::Contains(HasSubstr("inside out")));
    const auto volume = [](const Scene& s) {
        double sum = 0;
        for (const auto& t : s.meshes.at(0).triangles) {
            const auto& p = s.meshes[0].positions;
            sum += static_cast<double>(dot(p[t[0]], cross(p[t[1]], p[t[2]])));
        }
        return sum / 6;
    };
    EXPECT_NEAR(volume(right), 1.0 / 6, 1e-6);
    EXPECT_NEAR(volume(turned), 1.0 / 6, 1e-6);
}

TEST_F(GltfExtensions, ThicknessZeroIsAThinPaneAndBadNumbersAreRefused) {
    const auto s = scene(glass(tetrahedron(), {{"thicknessFactor", 0}}));
    EXPECT_EQ(s.materials[0].kind, MaterialKind::ThinGlass);
    EXPECT_THAT(refusal(glass(tetrahedron(), {{"thicknessFactor", -1}})), HasSubstr("thicknessFactor: is -1"));
    EXPECT_THAT(refusal(glass(tetrahedron(), {{"thicknessFactor", 1}, {"attenuationDistance", 0}})),
                HasSubstr("attenuationDistance: is 0"));
}

TEST_F(GltfExtensions, InstancesArePlacedByTheirOwnTurnAndTheNodes) {
    auto m = triangle();
    const float half = std::sqrt(0.5F);
    const int places = m.accessor({0, 0, 0, 5, 0, 0}, "VEC3", 3);
    const int turns = m.accessor({0, 0, 0, 1, 0, 0, half, half}, "VEC4", 4);  // the second: 90 degrees about z
    const int scales = m.accessor({1, 1, 1, 2, 2, 2}, "VEC3", 3);
    m.node(0)["translation"] = {0, 0, 3};
    m.node(0)["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", places}, {"ROTATION", turns}, {"SCALE", scales}, {"_ID", scales}};
    m.doc["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const auto s = scene(m);
    ASSERT_EQ(s.meshes.size(), 2U);
    EXPECT_EQ(s.objects[0].name, "thing 1");
    EXPECT_EQ(s.objects[1].name, "thing 2");
    // glTF's (x, y, z) is our (x, -z, y). The corner (1, 0, 0), doubled, turned to (0, 2, 0), moved to (5, 2, 3).
    const Vec3 corner = s.meshes[1].positions[1];
    EXPECT_NEAR(corner.x, 5, 1e-6);
    EXPECT_NEAR(corner.y, -3, 1e-6);
    EXPECT_NEAR(corner.z, 2, 1e-6);
}

TEST_F(GltfExtensions, InstancesOfNormalisedIntegers) {
    auto m = triangle();
    // (0, 0, 127, 0) / 127: half a turn about z.
    const int turns = m.raw(std::string("\0\0\x7F\0", 4), 5120, 1, "VEC4", true);
    m.node(0)["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"ROTATION", turns}};
    const auto s = scene(m);
    ASSERT_EQ(s.meshes.size(), 1U);
    EXPECT_NEAR(s.meshes[0].positions[1].x, -1, 1e-6);
}

TEST_F(GltfExtensions, WrongInstancesAreRefusedByName) {
    auto m = triangle();
    auto& attributes = m.node(0)["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    EXPECT_THAT(refusal(m), HasSubstr("attributes: is "));
    attributes = {{"TRANSLATION", m.accessor({0, 0, 0, 5, 0, 0}, "VEC3", 3)}, {"SCALE", m.accessor({1, 1, 1}, "VEC3", 3)}};
    EXPECT_THAT(refusal(m), HasSubstr("instances, expected"));
    attributes = {{"ROTATION", m.accessor({0, 0, 0}, "VEC3", 3)}};
    EXPECT_THAT(refusal(m), HasSubstr("is not VEC4"));
    attributes = {{"ROTATION", m.accessor({0, 0, 0, 0}, "VEC4", 4)}};
    EXPECT_THAT(refusal(m), HasSubstr("without length"));
    attributes = {{"TRANSLATION", m.accessor({NAN, 0, 0}, "VEC3", 3)}};
    EXPECT_THAT(refusal(m), HasSubstr("expected finite numbers"));
    m.doc["accessors"].push_back({{"componentType", 5126}, {"count", 60000}, {"type", "VEC3"}});
    attributes = {{"TRANSLATION", m.doc["accessors"].size() - 1}};
    EXPECT_THAT(refusal(m), HasSubstr("no bufferView"));
}

TEST_F(GltfExtensions, HiddenNodesHideAllBelowThem) {
    auto m = triangle();
    const json hidden{{"KHR_node_visibility", {{"visible", false}}}}, shown{{"KHR_node_visibility", {{"visible", true}}}};
    m.doc["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}, {{"type", "directional"}}};
    m.doc["nodes"] = {{{"children", {1, 2, 3}}, {"extensions", hidden}},
                      {{"mesh", 0}, {"name", "inner"}, {"extensions", shown}},
                      {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
                      {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}},
                      {{"mesh", 0}, {"extensions", shown}}};
    m.doc["scenes"][0]["nodes"] = {0, 4};
    const auto s = scene(m);
    EXPECT_EQ(s.meshes.size(), 1U);
    EXPECT_TRUE(s.luminaires.empty());
    EXPECT_TRUE(s.sky.suns.empty());
    EXPECT_THAT(s.warnings, testing::Contains(HasSubstr("3 nodes are hidden by KHR_node_visibility and left out: 'inner'")));
}

TEST_F(GltfExtensions, ColoursOfVerticesMultiplyTheBaseColour) {
    auto m = triangle();
    const int colours = m.accessor({0.8F, 0.2F, 0, 0.8F, 0.2F, 0, 0.2F, 0.2F, 0.3F}, "VEC3", 3);
    m.doc["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = colours;
    m.doc["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}, {"metallicFactor", 0}};
    const auto seen = [](const Scene& s) {
        const auto& mesh = s.meshes.at(0);
        const auto& material = s.materials[mesh.material];
        const auto texel = s.textures.at(0).sample(mesh.uvs.at(0));
        return material.reflectance * texel;
    };
    auto got = seen(scene(m));
    // Half of the mean of the corners; one colour is its own largest, so that its texel is white.
    EXPECT_NEAR(got.r, 0.3F, 1e-6F);
    EXPECT_NEAR(got.g, 0.1F, 1e-6F);
    EXPECT_NEAR(got.b, 0.05F, 1e-6F);
    m.doc["meshes"][0]["primitives"][0].erase("material");
    got = seen(scene(m));
    EXPECT_NEAR(got.r, 0.6F, 1e-6F) << "without a material the colours are the reflectance";
    m.doc["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = m.accessor({1, 1}, "VEC2", 2);
    EXPECT_THAT(refusal(m), HasSubstr("is not VEC3 or VEC4"));
}

TEST_F(GltfExtensions, FilesOfOtherMachinesAreFoundBesideTheModel) {
    auto m = triangle();
    ASSERT_TRUE(read(m));
    json doc = m.doc;
    for (const char* uri : {"M.BIN", "C:\\models\\m.bin", ".\\m.bin"}) {
        doc["buffers"] = {{{"byteLength", m.bytes.size()}, {"uri", uri}}};
        std::ofstream(folder_ / "m.gltf") << doc.dump();
        const auto part = readSceneFile(folder_ / "m.gltf", {});
        ASSERT_TRUE(part) << uri << ": " << part.error().text();
        EXPECT_EQ(part->scene.triangleCount(), 1U);
    }
}

TEST_F(GltfExtensions, DirectionalLightsAreSuns) {
    auto m = triangle();
    m.doc["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 1000}},
        {{"type", "directional"}, {"intensity", 300}, {"color", {1, 0, 0}}},
        {{"type", "directional"}, {"intensity", 0}}};
    const auto light = [](int i, const json& rotation) {
        return json{{"rotation", rotation}, {"scale", {3, 3, 3}}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}};
    };
    const double half = std::sqrt(0.5);
    m.doc["nodes"] = {{{"mesh", 0}}, light(0, {-half, 0, 0, half}), light(1, {0, half, 0, half}), light(2, {0, 0, 0, 1})};
    m.doc["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const auto s = scene(m);
    ASSERT_EQ(s.sky.suns.size(), 2U);
    // The first looks along glTF's -y, down: it stands in the zenith.
    EXPECT_NEAR(s.sky.suns[0].direction.z, 1, 1e-6);
    EXPECT_NEAR(luminance(s.sky.suns[0].normalIrradiance(), s.weights), 1000, 0.01);  // floats of a small solid angle
    // The second looks along -x after its turn about y: it stands towards +x. Its lx are color x intensity.
    EXPECT_NEAR(s.sky.suns[1].direction.x, 1, 1e-6);
    EXPECT_NEAR(luminance(s.sky.suns[1].normalIrradiance(), s.weights), 300 * 0.2126, 0.01);
    EXPECT_EQ(s.sky.suns[1].radiance.g, 0);
    m.doc["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = -1;
    EXPECT_THAT(refusal(m), HasSubstr("must not be negative"));
}

}  // namespace
}  // namespace luxdeck

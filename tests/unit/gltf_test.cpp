#include "engine/io/scene_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <png.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

constexpr int kByte = 5120, kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

/// A glTF document being put together, written as GLB.
struct Model {
    json doc = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}, {"nodes", {{{"mesh", 0}}}}};
    std::string bytes;

    /// A bufferView of these values; returns its index.
    template <class T>
    int view(const std::vector<T>& values, int stride = 0) {
        while (bytes.size() % 4 != 0) bytes.push_back('\0');
        json v = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}};
        if (stride > 0) v["byteStride"] = stride;
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        doc["bufferViews"].push_back(v);
        return static_cast<int>(doc["bufferViews"].size()) - 1;
    }
    int accessor(int viewIndex, int componentType, std::size_t count, const char* type, json extra = json::object()) {
        extra.update({{"componentType", componentType}, {"count", count}, {"type", type}});
        if (viewIndex >= 0) extra["bufferView"] = viewIndex;
        doc["accessors"].push_back(extra);
        return static_cast<int>(doc["accessors"].size()) - 1;
    }
    int floats(const std::vector<float>& values, const char* type, std::size_t components) {
        return accessor(view(values), kFloat, values.size() / components, type);
    }
    json& mesh(const json& primitive) {
        doc["meshes"].push_back({{"primitives", json::array({primitive})}});
        return doc["meshes"].back();
    }
    [[nodiscard]] std::string glb() const {
        json d = doc;
        if (!bytes.empty()) d["buffers"] = {{{"byteLength", bytes.size()}}};
        std::string text = d.dump(), binary = bytes;
        text.resize((text.size() + 3) / 4 * 4, ' ');
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        const auto word = [](std::size_t value) {
            const auto w = static_cast<std::uint32_t>(value);
            return std::string(reinterpret_cast<const char*>(&w), 4);
        };
        return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" + text +
               word(binary.size()) + std::string("BIN\0", 4) + binary;
    }
};

const std::vector<float> kCorner{0, 0, 0, 1, 0, 0, 0, 1, 0};  // a triangle facing +z, which is to become -y

Model triangle() {
    Model m;
    m.mesh({{"attributes", {{"POSITION", m.floats(kCorner, "VEC3", 3)}}}});
    return m;
}

class Gltf : public testing::Test {
protected:
    Gltf() : folder_(fs::temp_directory_path() / ("luxdeck_gltf_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_ / "models");
    }
    ~Gltf() override { fs::remove_all(folder_); }

    Result<ScenePart> readBytes(const std::string& bytes, const char* name = "models/m.glb", const GeometryPlacement& placement = {}) {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return readSceneFile(folder_ / name, placement);
    }
    Result<ScenePart> read(const Model& m, const GeometryPlacement& placement = {}) { return readBytes(m.glb(), "models/m.glb", placement); }
    Scene scene(const Model& m) {
        auto part = read(m);
        EXPECT_TRUE(part) << part.error().text();
        return part ? part->scene : Scene{};
    }
    Material material(const json& j) {
        auto m = triangle();
        m.doc["materials"] = json::array({j});
        m.doc["meshes"][0]["primitives"][0]["material"] = 0;
        const auto s = scene(m);
        return s.materials.empty() ? Material{} : s.materials[0];
    }
    fs::path folder_;
};

Vec3 faceNormal(const Mesh& mesh, std::size_t i) {
    const auto& t = mesh.triangles[i];
    return cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
}

std::vector<std::uint8_t> onePixelPng(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 1;
    image.format = PNG_FORMAT_RGB;
    const std::uint8_t pixel[3] = {r, g, b};
    std::vector<std::uint8_t> bytes(1000);
    png_alloc_size_t size = bytes.size();
    png_image_write_to_memory(&image, bytes.data(), &size, 0, pixel, 0, nullptr);
    bytes.resize(size);
    return bytes;
}

TEST_F(Gltf, TurnsYUpAndScales) {
    GeometryPlacement placement;
    placement.metresPerUnit = 2;
    placement.transform.setTranslation(Vec3d(0, 0, 1));
    auto part = read(triangle(), placement);
    ASSERT_TRUE(part) << part.error().text();
    const Mesh& mesh = part->scene.meshes.at(0);
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 1}, {2, 0, 1}, {0, 0, 3}}));
    EXPECT_LT(faceNormal(mesh, 0).y, 0);
    EXPECT_EQ(part->scene.materials.at(0).reflectance, Rgb{0.5F});  // none given
    EXPECT_TRUE(validate(part->scene));
}

TEST_F(Gltf, NodesMultiplyTheirTransforms) {
    auto m = triangle();
    const double h = std::sqrt(0.5);
    m.doc["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}, {"rotation", {0, h, 0, h}}},  // x -> -z
                      {{"mesh", 0}, {"name", "desk"}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 0, 0, 1}}}};
    const auto s = scene(m);
    ASSERT_EQ(s.objects.size(), 1U);
    EXPECT_EQ(s.objects[0].name, "desk");
    // Second corner: (1,0,0) * 2 + (1,0,0) = (3,0,0); turned (0,0,-3); moved (10,0,-3); z up (10,3,0).
    EXPECT_LT((s.meshes[0].positions[1] - Vec3(10, 3, 0)).length(), 1e-6F);  // float rounding at 10
}

TEST_F(Gltf, MirroredNodesKeepFacingOutwards) {
    auto m = triangle();
    m.doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = m.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
    m.doc["nodes"][0]["scale"] = {-3, 1, 2};
    const auto s = scene(m);
    EXPECT_LT(faceNormal(s.meshes[0], 0).y, 0);
    EXPECT_EQ(s.meshes[0].normals[0], (Vec3{0, -1, 0}));
}

TEST_F(Gltf, FlatScaleAndBadNormals) {
    auto m = triangle();
    m.doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = m.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
    m.doc["nodes"][0]["scale"] = {1, 1, 0};
    EXPECT_EQ(scene(m).meshes[0].normals[0], (Vec3{0, -1, 0}));  // a plane squashed flat still has its normal
    auto bad = triangle();
    bad.doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = bad.floats({0, 0, 1, NAN, 0, 1, 0, 0, 0}, "VEC3", 3);
    const auto s = scene(bad);
    EXPECT_TRUE(s.meshes[0].normals.empty());
    EXPECT_THAT(s.warnings, testing::Contains(HasSubstr("shaded flat")));
}

TEST_F(Gltf, ComponentTypesStridesAndSparse) {
    Model m;
    // Positions and byte uvs interleaved: 12 + 4 bytes a vertex.
    std::vector<std::uint8_t> mixed(48);
    for (std::size_t i = 0; i < 3; ++i) std::memcpy(&mixed[16 * i], &kCorner[3 * i], 12);
    mixed[12] = 255, mixed[16 + 13] = 51;
    const int view = m.view(mixed, 16);
    const int position = m.accessor(view, kFloat, 3, "VEC3");
    const int uv = m.accessor(view, kUnsignedByte, 3, "VEC2", {{"byteOffset", 12}, {"normalized", true}});
    const int indices = m.accessor(m.view(std::vector<std::uint8_t>{2, 0, 1}), kUnsignedByte, 3, "SCALAR");
    m.doc["images"] = {{{"bufferView", m.view(onePixelPng(255, 255, 255))}, {"mimeType", "image/png"}}};
    m.doc["textures"] = {{{"source", 0}}};
    m.doc["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    m.mesh({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}}, {"indices", indices}, {"material", 0}});
    const auto s = scene(m);
    EXPECT_EQ(s.meshes[0].positions[1], (Vec3{1, 0, 0}));
    EXPECT_EQ(s.meshes[0].uvs[0], (Vec2{1, 0}));
    EXPECT_FLOAT_EQ(s.meshes[0].uvs[1].y, 0.2F);
    EXPECT_EQ(s.meshes[0].triangles[0], (std::array<std::uint32_t, 3>{2, 0, 1}));
    Model quantized;  // KHR_mesh_quantization: normalised bytes, -128 is -1 as well
    quantized.doc["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int bytes = quantized.view(std::vector<std::int8_t>{-128, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0, 0}, 4);
    quantized.mesh({{"attributes", {{"POSITION", quantized.accessor(bytes, kByte, 3, "VEC3", {{"normalized", true}})}}}});
    EXPECT_EQ(scene(quantized).meshes[0].positions[0], (Vec3{-1, 0, 0}));
    Model sparse;
    const json part = {{"count", 2},
                       {"indices", {{"bufferView", sparse.view(std::vector<std::uint16_t>{1, 2})}, {"componentType", kUnsignedShort}}},
                       {"values", {{"bufferView", sparse.view(std::vector<float>{5, 0, 0, 0, 6, 0})}}}};
    sparse.mesh({{"attributes", {{"POSITION", sparse.accessor(-1, kFloat, 3, "VEC3", {{"sparse", part}})}}}});
    EXPECT_EQ(scene(sparse).meshes[0].positions, (std::vector<Vec3>{{0, 0, 0}, {5, 0, 0}, {0, 0, 6}}));
}

TEST_F(Gltf, StripsAndFansFaceOneWay) {
    for (const int mode : {5, 6}) {
        Model m;  // a unit square facing +z
        const std::vector<float> strip{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, fan{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
        m.mesh({{"attributes", {{"POSITION", m.floats(mode == 5 ? strip : fan, "VEC3", 3)}}}, {"mode", mode}});
        const auto s = scene(m);
        ASSERT_EQ(s.meshes[0].triangles.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(faceNormal(s.meshes[0], i), (Vec3{0, -1, 0})) << mode;
    }
}

TEST_F(Gltf, PrimitivesTakeAlongOnlyTheirVertices) {
    Model m;
    std::vector<float> many(3000, 0.0F);
    many[2997] = 7;  // x of vertex 999
    const int position = m.floats(many, "VEC3", 3);
    const int few = m.accessor(m.view(std::vector<std::uint32_t>{999, 3, 500}), kUnsignedInt, 3, "SCALAR");
    m.mesh({{"attributes", {{"POSITION", position}}}, {"indices", few}});
    const auto s = scene(m);
    ASSERT_EQ(s.meshes[0].positions.size(), 3U);
    EXPECT_EQ(s.meshes[0].positions[s.meshes[0].triangles[0][0]].x, 7);
}

TEST_F(Gltf, Materials) {
    const auto plain = material({{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.75}}}});
    EXPECT_EQ(plain.kind, MaterialKind::MetallicRoughness);
    EXPECT_EQ(plain.reflectance, (Rgb{0.1F, 0.2F, 0.3F}));
    EXPECT_EQ(plain.metallic, 0.25F);
    EXPECT_EQ(plain.roughness, 0.75F);
    EXPECT_TRUE(plain.oneSidedEmission);
    EXPECT_FALSE(plain.emits());
    const auto lamp = material({{"doubleSided", true}, {"emissiveFactor", {1, 0.5, 0}},
                                {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 3000}}}}}});
    EXPECT_EQ(lamp.emission, (Rgb{3000, 1500, 0}));
    EXPECT_FALSE(lamp.oneSidedEmission);
    const auto pane = material({{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}, {"KHR_materials_ior", {{"ior", 1.5}}}}}});
    EXPECT_EQ(pane.kind, MaterialKind::ThinGlass);
    EXPECT_NEAR(pane.transmittance.g, 0.96 / 1.04, 1e-6);  // (1 - F) / (1 + F), F = 0.04; float rounding
    EXPECT_EQ(material({{"extensions", {{"KHR_materials_unlit", json::object()}}}}).kind, MaterialKind::Matte);
    const auto gloss = material({{"extensions", {{"KHR_materials_pbrSpecularGlossiness",
                                                  {{"diffuseFactor", {1, 1, 1, 1}}, {"specularFactor", {0.25, 0.25, 0.25}}, {"glossinessFactor", 0.25}}}}}});
    EXPECT_EQ(gloss.kind, MaterialKind::Plastic);
    EXPECT_EQ(gloss.reflectance, Rgb{0.75F});
    EXPECT_EQ(gloss.roughness, 0.75F);
    EXPECT_EQ(material({{"pbrMetallicRoughness", {{"baseColorFactor", {2, 0, 0, 1}}}}}).reflectance.r, 1.0F);
}

TEST_F(Gltf, AlphaModes) {
    const auto withAlpha = [&](const char* mode, double alpha, const json& cutoff = nullptr) {
        json j = {{"alphaMode", mode}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}};
        if (!cutoff.is_null()) j["alphaCutoff"] = cutoff;
        return material(j);
    };
    EXPECT_FALSE(withAlpha("OPAQUE", 0.25).hasHoles());
    const auto blend = withAlpha("BLEND", 0.25);
    EXPECT_TRUE(blend.alphaBlend);
    EXPECT_EQ(blend.alpha, 0.25F);
    EXPECT_FALSE(withAlpha("BLEND", 1).hasHoles()) << "marked, but solid";
    EXPECT_EQ(withAlpha("MASK", 0.25).alphaCutoff, 0.5F);
    EXPECT_FALSE(withAlpha("MASK", 0.25, 0.2).hasHoles());
    EXPECT_EQ(withAlpha("MASK", 0.25, 2).alphaCutoff, 2);
}

TEST_F(Gltf, TexturesAreSharedAndTransformed) {
    auto m = triangle();
    m.doc["images"] = {{{"bufferView", m.view(onePixelPng(255, 128, 0))}, {"mimeType", "image/png"}}};
    m.doc["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
    m.doc["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 0}, {"sampler", 0}}};
    const json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"scale", {2, 3}}, {"rotation", 1}}}};
    m.doc["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"extensions", transform}}},
                                                     {"metallicRoughnessTexture", {{"index", 1}}}}},
                           {"emissiveTexture", {{"index", 1}}}, {"emissiveFactor", {1, 1, 1}}}};
    auto& primitive = m.doc["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["TEXCOORD_0"] = m.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    const auto s = scene(m);
    ASSERT_EQ(s.textures.size(), 2U);  // one picture as colour, once more as plain numbers
    const Material& material = s.materials[0];
    EXPECT_EQ(material.reflectanceTexture.texture, material.emissionTexture.texture);
    EXPECT_TRUE(s.textures[0].srgb);
    EXPECT_FALSE(s.textures[1].srgb);
    EXPECT_EQ(s.textures[0].wrapU, TextureWrap::Clamp);
    EXPECT_EQ(s.textures[0].wrapV, TextureWrap::Mirror);
    EXPECT_EQ(material.reflectanceTexture.scale, (Vec2{2, 3}));
    EXPECT_EQ(material.reflectanceTexture.offset, (Vec2{0.5F, 0.25F}));
    EXPECT_EQ(material.reflectanceTexture.rotation, 1.0F);
}

TEST_F(Gltf, PunctualLightsBecomeLuminaires) {
    Model m;
    m.doc["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}, {"intensity", 100}},
        {{"type", "spot"}, {"intensity", 1000}, {"color", {1, 0, 0}}, {"name", "spot"},
         {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.6}}}},
        {{"type", "directional"}, {"name", "sun"}}};
    const auto node = [](int light) { return json{{"translation", {1, 2, 3}}, {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}}; };
    m.doc["nodes"] = {node(0), node(1), node(2), node(0)};
    m.doc["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const auto s = scene(m);
    ASSERT_EQ(s.luminaires.size(), 3U);
    ASSERT_EQ(s.luminaireTypes.size(), 2U);
    EXPECT_EQ(s.sky.suns.size(), 1U);
    const auto& point = s.luminaireTypes[s.luminaires[0].type];
    EXPECT_NEAR(point.photometry.table.lumens(), 400 * kPiD, 1e-9 * 400 * kPiD);  // 4 pi I
    EXPECT_FLOAT_EQ(point.photometry.table.intensity({0, 0, 1}), 100);
    EXPECT_EQ(s.luminaires[0].position, (Vec3{1, -3, 2}));
    const auto& spot = s.luminaireTypes[s.luminaires[1].type];
    EXPECT_FLOAT_EQ(luminance(spot.colour), 1.0F);
    const auto towards = [&](double angle) {
        return spot.photometry.table.intensity(Vec3(float(std::sin(angle)), 0, float(-std::cos(angle))));
    };
    const double peak = 1000 * 0.2126;  // the luminance of red
    EXPECT_NEAR(towards(0.1), peak, 1e-4 * peak);
    const double middle = (std::cos(0.4) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
    EXPECT_NEAR(towards(0.4), peak * middle * middle, 1e-4 * peak);  // 64 linear pieces: 6e-5 of the peak
    EXPECT_EQ(towards(0.61), 0);
    // The node is not turned: its -z lies along the project's +y, and so must the nadir, local -z.
    EXPECT_LT((s.luminaires[1].frame.toWorld({0, 0, -1}) - Vec3(0, 1, 0)).length(), 1e-6F);
    EXPECT_LT((s.luminaires[1].frame.toWorld({1, 0, 0}) - Vec3(1, 0, 0)).length(), 1e-6F);
}

TEST_F(Gltf, IesProfiles) {
    const std::string ies = "IESNA:LM-63-2002\n[TEST] 1\n[MANUFAC] x\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n100 50 0\n";
    Model m;
    m.doc["extensions"]["EXT_lights_ies"]["lights"] = {
        {{"bufferView", m.view(std::vector<char>(ies.begin(), ies.end()))}, {"mimeType", "application/x-ies-lm-63"}}, {{"uri", "lamp%20a.ies"}}};
    std::ofstream(folder_ / "models/lamp a.ies") << ies;
    m.doc["nodes"] = {{{"extensions", {{"EXT_lights_ies", {{"light", 0}, {"multiplier", 2}, {"color", {0, 1, 0}}}}}}},
                      {{"extensions", {{"EXT_lights_ies", {{"light", 1}}}}}}};
    m.doc["scenes"][0]["nodes"] = {0, 1};
    const auto s = scene(m);
    ASSERT_EQ(s.luminaires.size(), 2U);
    EXPECT_DOUBLE_EQ(s.luminaires[0].fluxScale, 2 * 0.7152);  // green alone
    EXPECT_FLOAT_EQ(luminance(s.luminaireTypes[0].colour), 1.0F);
    EXPECT_FLOAT_EQ(s.luminaireTypes[1].photometry.table.intensity({0, 0, -1}), 100);
    m.doc["extensions"]["EXT_lights_ies"]["lights"][1]["uri"] = "none.ies";
    EXPECT_EQ(read(m).error().code, ErrorCode::FileNotFound);
}

TEST_F(Gltf, Cameras) {
    auto m = triangle();
    m.doc["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", kPiD / 3}, {"znear", 0.1}}}}};
    m.doc["nodes"].push_back({{"camera", 0}, {"translation", {0, 1.6, 4}}, {"name", "eye"}});
    m.doc["scenes"][0]["nodes"] = {0, 1};
    const auto part = read(m);
    ASSERT_TRUE(part);
    ASSERT_EQ(part->cameras.size(), 1U);
    EXPECT_EQ(part->cameras[0].name, "eye");
    EXPECT_EQ(part->cameras[0].position, Vec3d(0, -4, 1.6));
    EXPECT_EQ(part->cameras[0].direction, Vec3d(0, 1, 0));
    EXPECT_EQ(part->cameras[0].up, Vec3d(0, 0, 1));
    EXPECT_NEAR(part->cameras[0].verticalFovDeg, 60, 1e-12);  // rounding
}

TEST_F(Gltf, RefusesWhatIsWrongAndSaysWhere) {
    const struct {
        std::function<void(json&)> spoil;
        const char* message;
        ErrorCode code;
    } cases[] = {
        {[](json& d) { d["asset"]["version"] = "1.0"; }, "asset.version: is '1.0'", ErrorCode::Unsupported},
        {[](json& d) { d.erase("asset"); }, "asset: is missing", ErrorCode::Parse},
        {[](json& d) { d["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }, "KHR_draco_mesh_compression", ErrorCode::Unsupported},
        {[](json& d) { d["accessors"][0]["count"] = 10000000000ULL; }, "accessors[0]: claims 10000000000 elements", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["count"] = 18446744073709551615ULL; }, "accessors[0]: claims", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["count"] = -1; }, "accessors[0].count: is -1", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["count"] = 2; }, "multiple of 3", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["byteOffset"] = 18446744073709551615ULL; }, "accessors[0]: claims", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["byteOffset"] = 4; }, "accessors[0]: claims 3 elements of 12 bytes", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0].erase("bufferView"); d["accessors"][0]["count"] = 10000000000ULL; }, "without a bufferView", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["componentType"] = 5124; }, "accessors[0].componentType: is 5124", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["type"] = "VEC9"; }, "'VEC9'", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["type"] = "VEC2"; }, "is not VEC3", ErrorCode::Parse},
        {[](json& d) { d["accessors"][0]["bufferView"] = 7; }, "accessors[0].bufferView: is 7, expected an index into the 1 bufferViews", ErrorCode::Parse},
        {[](json& d) { d["bufferViews"][0]["byteLength"] = 10000000000ULL; }, "bufferViews[0]: bytes 0 + 10000000000", ErrorCode::Parse},
        {[](json& d) { d["bufferViews"][0]["byteOffset"] = 18446744073709551615ULL; }, "bufferViews[0]", ErrorCode::Parse},
        {[](json& d) { d["bufferViews"][0]["byteStride"] = 1000; }, "byteStride: is 1000", ErrorCode::Parse},
        {[](json& d) { d["bufferViews"][0]["byteStride"] = 16; }, "every 16 bytes", ErrorCode::Parse},
        {[](json& d) { d["meshes"][0]["primitives"][0]["mode"] = 9; }, "mode: is 9", ErrorCode::Parse},
        {[](json& d) { d["meshes"][0]["primitives"][0]["indices"] = 0; }, "accessors[0] is not SCALAR", ErrorCode::Parse},
        {[](json& d) { d["meshes"][0]["primitives"][0]["material"] = 0; }, "the file has no materials", ErrorCode::Parse},
        {[](json& d) { d["nodes"][0]["mesh"] = 1; }, "nodes[0].mesh: is 1", ErrorCode::Parse},
        {[](json& d) { d["nodes"][0]["children"] = {0}; }, "its own ancestor", ErrorCode::Parse},
        {[](json& d) { d["nodes"] = {{{"children", {1, 2}}}, {{"children", {2}}}, json::object()}; }, "already a child", ErrorCode::Parse},
        {[](json& d) { d["nodes"][0]["matrix"] = {1, 2, 3}; }, "nodes[0].matrix: is an array of 3, expected an array of 16", ErrorCode::Parse},
        {[](json& d) { d["nodes"][0]["rotation"] = {0, 0, 0, 0}; }, "without length", ErrorCode::Parse},
        {[](json& d) { d["nodes"][0]["scale"] = {1e300, 1, 1}; }, "out of the range of floats", ErrorCode::Parse},
        {[](json& d) { d["scenes"][0]["nodes"] = {5}; }, "scenes[0].nodes[0]: is 5", ErrorCode::Parse},
        {[](json& d) { d["nodes"][0]["mesh"] = "desk"; }, "nodes[0].mesh: is \"desk\"", ErrorCode::Parse}};
    for (const auto& c : cases) {
        auto m = triangle();
        c.spoil(m.doc);
        const auto part = read(m);
        ASSERT_FALSE(part) << c.message;
        EXPECT_EQ(part.error().code, c.code) << part.error().text();
        EXPECT_THAT(part.error().message, HasSubstr(c.message));
        EXPECT_THAT(part.error().where, HasSubstr("m.glb"));
    }
}

TEST_F(Gltf, RefusesValuesThatAreNoPlaces) {
    for (const float bad : {NAN, INFINITY}) {
        Model m;
        m.mesh({{"attributes", {{"POSITION", m.floats({0, 0, 0, 1, 0, 0, 0, bad, 0}, "VEC3", 3)}}}})["name"] = "desk";
        const auto part = read(m);
        ASSERT_FALSE(part);
        EXPECT_THAT(part.error().message, HasSubstr("vertex 2 of mesh 'desk'"));
    }
}

TEST_F(Gltf, SmallFilesCannotAskForEndlessCopies) {
    Model m;  // 12,000 vertices placed 10,000 times
    m.mesh({{"attributes", {{"POSITION", m.floats(std::vector<float>(36000, 1.0F), "VEC3", 3)}}}});
    m.doc["nodes"] = json::array();
    m.doc["scenes"][0]["nodes"] = json::array();
    for (int i = 0; i < 10000; ++i) {
        m.doc["nodes"].push_back({{"mesh", 0}});
        m.doc["scenes"][0]["nodes"].push_back(i);
    }
    EXPECT_EQ(read(m).error().code, ErrorCode::OutOfResources);
}

TEST_F(Gltf, FilesOutsideTheFolderAreNotRead) {
    std::ofstream(folder_ / "secret.bin") << std::string(36, '\0');
    auto m = triangle();
    const auto refused = [&](const std::string& uri) {
        m.doc["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        return readBytes(m.doc.dump(), "models/m.gltf");
    };
    for (const std::string& uri : std::vector<std::string>{"../secret.bin", "a/../../secret.bin", "%2e%2e/secret.bin", (folder_ / "secret.bin").string(),
                                  "file:///etc/passwd", "http://example.com/a.bin"}) {
        const auto part = refused(uri);
        ASSERT_FALSE(part) << uri;
        EXPECT_EQ(part.error().code, ErrorCode::Unsupported) << part.error().text();
    }
    EXPECT_EQ(refused("none.bin").error().code, ErrorCode::FileNotFound);
    EXPECT_THAT(refused("data:application/octet-stream;base64,AAAA").error().message, HasSubstr("only 3 bytes are there"));
    EXPECT_THAT(refused("data:application/octet-stream;base64,A*AA").error().message, HasSubstr("not base64"));
}

TEST_F(Gltf, SurvivesEveryTruncation) {
    const std::string whole = triangle().glb();
    for (std::size_t keep = 0; keep < whole.size(); ++keep) EXPECT_FALSE(readBytes(whole.substr(0, keep))) << keep;
    EXPECT_FALSE(readBytes(std::string(100000, '['), "models/m.gltf"));
    EXPECT_FALSE(readBytes("[]", "models/m.gltf"));
    EXPECT_FALSE(readBytes("", "models/m.gltf"));
}

TEST(GltfFiles, EachOfTheCollectionLoadsOrIsRefusedForItsReason) {
    const fs::path folder = fs::path(LUXDECK_SOURCE_DIR) / "../shared/data/gltf";
    if (!fs::exists(folder)) GTEST_SKIP() << "test data is not there: " << folder;
    const std::map<std::string, std::string> refused{
        {"BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb", "vertex 0 of mesh 'Mesh' is (-inf"},
        {"IncorrectVertexArrays/Cube.gltf", "lie outside buffer 0 of 514 bytes"},
        {"IndexOutOfRange/AllIndicesOutOfRange.gltf", "index 0 is 65535, but there are 24 vertices"},
        {"IndexOutOfRange/IndexOutOfRange.gltf", "index 0 is 255, but there are 24 vertices"},
        {"MissingBin/BoxTextured.gltf", "no such file"},
        {"RecursiveNodes/RecursiveNodes.gltf", "is recursive"},
        {"SchemaFailures/sceneWrongType.gltf", "scene: is \"hello\""},
        {"TestNoRootNode/NoScene.gltf", "scene: is 0, expected no index"},
        {"draco/2CylinderEngine.gltf", "KHR_draco_mesh_compression"},
        {"wrongTypes/badArray.gltf", "meshes[0].primitives: is an object, expected an array"},
        {"wrongTypes/badExtension.gltf", "KHR_texture_transform: is \"Not an object\""},
        {"wrongTypes/badNumber.gltf", "normalTexture.scale: is \"not a number\""},
        {"wrongTypes/badObject.gltf", "pbrMetallicRoughness: is an array"},
        {"wrongTypes/badString.gltf", "scenes[0].name: is 42"},
        {"wrongTypes/badUint.gltf", "baseColorTexture.index: is -1"}};
    const std::map<std::string, std::size_t> triangles{{"2CylinderEngine-glTF-Binary/2CylinderEngine.glb", 121496},
                                                       {"BoxBadNormals-glTF-Binary/BoxBadNormals.glb", 12},
                                                       {"cameras/Cameras.gltf", 2},
                                                       {"issue_3269/texcoord_crash.gltf", 10},
                                                       {"simple_skin/simple_skin.gltf", 8},
                                                       {"glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_04.gltf", 2},
                                                       {"glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_03.gltf", 0}};
    std::size_t seen = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const auto extension = entry.path().extension();
        if (extension != ".gltf" && extension != ".glb") continue;
        const std::string name = entry.path().lexically_relative(folder).string();
        SCOPED_TRACE(name);
        auto part = readGltf(entry.path(), {});
        const auto why = refused.find(name);
        ASSERT_EQ(bool(part), why == refused.end()) << (part ? "loads" : part.error().text());
        seen += why != refused.end();
        if (!part) {
            EXPECT_THAT(part.error().text(), HasSubstr(why->second));
            continue;
        }
        if (const auto count = triangles.find(name); count != triangles.end()) {
            EXPECT_EQ(part->scene.triangleCount(), count->second);
        }
        EXPECT_TRUE(validate(part->scene));  // after counting: it drops triangles without area
    }
    EXPECT_EQ(seen, refused.size());
}

}  // namespace
}  // namespace luxdeck

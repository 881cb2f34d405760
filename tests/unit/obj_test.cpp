#include "engine/io/obj_polygon.h"
#include "engine/io/scene_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Obj : public testing::Test {
protected:
    Obj() : folder_(fs::temp_directory_path() / ("luxdeck_obj_" + std::to_string(::getpid()))) { fs::create_directories(folder_); }
    ~Obj() override { fs::remove_all(folder_); }

    Result<ScenePart> read(const std::string& text, const GeometryPlacement& placement = {}) {
        write("scene.obj", text);
        return readSceneFile(folder_ / "scene.obj", placement);
    }
    void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name, std::ios::binary) << text; }
    Material material(const std::string& mtl) {
        write("m.mtl", "newmtl m\n" + mtl);
        const auto part = read("mtllib m.mtl\nusemtl m\n" + kTriangle);
        EXPECT_TRUE(part) << part.error().text();
        return part ? part->scene.materials.at(0) : Material{};
    }

    const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    fs::path folder_;
};

double area(const Scene& scene) {
    double sum = 0;
    for (const auto& mesh : scene.meshes)
        for (const auto& t : mesh.triangles)
            sum += 0.5 * double(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]).length());
    return sum;
}

TEST_F(Obj, ReadsFacesOfEveryForm) {
    const auto part = read(
        "# comment\n\nv 0 0 0\r\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 +1.0e0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
        "f 1 2 3 \\\n 4\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf -4/-3/-1 -3/-2/-1 -2/-1/-1\n");
    ASSERT_TRUE(part) << part.error().text();
    ASSERT_EQ(part->scene.meshes.size(), 4U);  // one for each set of data that faces give
    EXPECT_EQ(part->scene.triangleCount(), 5U);
    EXPECT_EQ(part->scene.meshes[0].positions.size(), 4U);
    EXPECT_TRUE(part->scene.meshes[0].normals.empty());
    EXPECT_EQ(part->scene.meshes[1].uvs[0], (Vec2{0, 1}));  // v runs down from the top row
    EXPECT_EQ(part->scene.meshes[3].normals[0], (Vec3{0, 0, 1}));
}

TEST_F(Obj, ObjectsAndMaterials) {
    const auto part = read("v 0 0 0\nv 1 0 0\nv 0 1 0\no desk\nusemtl wood\nf 1 2 3\nusemtl steel\nf 1 2 3\ng chair\nf 1 2 3\no desk\nf 3 2 1\n");
    ASSERT_TRUE(part);
    ASSERT_EQ(part->scene.objects.size(), 2U);
    EXPECT_EQ(part->scene.objects[1].name, "chair");
    ASSERT_EQ(part->scene.meshes.size(), 3U);
    EXPECT_EQ(part->scene.meshes[1].triangles.size(), 2U);  // desk in steel, taken up again
    EXPECT_EQ(part->scene.materials[0].reflectance, Rgb{0.5F});
    EXPECT_THAT(part->scene.warnings[0], HasSubstr("grey"));
}

TEST_F(Obj, ErrorsNameFileAndLine) {
    const struct {
        const char* text;
        const char* where;
        const char* message;
    } cases[] = {{"v 0 0\n", "scene.obj:1", "'v' has ''"},
                 {"v 0 0 0\nv 1 x 0\n", "scene.obj:2", "'x'"},
                 {"v 0 0 0\nv 0 nan 0\n", "scene.obj:2", "vertex 2"},
                 {"v 0 0 inf\n", "scene.obj:1", "finite"},
                 {"v 0 0 0\n\nf 1 2 3\n", "scene.obj:3", "v 2, but there are 1"},
                 {"v 0 0 0\nf 0 1 1\n", "scene.obj:2", "'0'"},
                 {"v 0 0 0\nf -2 1 1\n", "scene.obj:2", "v -2"},
                 {"v 0 0 0\nf 99999999999999999999 1 1\n", "scene.obj:2", "99999999999999999999"},
                 {"v 0 0 0\nf 1/1 1 1\n", "scene.obj:2", "vt 1"},
                 {"mtllib ../x.mtl\n", "scene.obj:1", "out of the folder"}};
    for (const auto& c : cases) {
        const auto part = read(c.text);
        ASSERT_FALSE(part) << c.text;
        EXPECT_THAT(part.error().where, HasSubstr(c.where));
        EXPECT_THAT(part.error().message, HasSubstr(c.message));
    }
    EXPECT_EQ(readObj(folder_ / "none.obj", {}).error().code, ErrorCode::FileNotFound);
}

TEST_F(Obj, BadNormalsAreShadedFlat) {
    const auto part = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn nan 0 1\nf 1//1 2//2 3//1\n");
    ASSERT_TRUE(part) << part.error().text();
    EXPECT_TRUE(part->scene.meshes[0].normals.empty());
    EXPECT_THAT(part->scene.warnings.back(), HasSubstr("flat"));
}

TEST_F(Obj, PlacementTurnsScalesAndMirrors) {
    GeometryPlacement placement;
    placement.yUp = true;
    placement.metresPerUnit = 0.5;
    placement.transform.setTranslation(Vec3d(10, 0, 0));
    auto part = read("v 2 4 6\nv 3 4 6\nv 2 5 6\nf 1 2 3\n", placement);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->scene.meshes[0].positions[0], (Vec3{11, -3, 2}));
    placement = {};
    placement.transform.setScale(Vec3d(-1, 1, 1));
    part = read(kTriangle, placement);
    const auto& mesh = part->scene.meshes[0];
    const auto& t = mesh.triangles[0];
    const Vec3 n = cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    EXPECT_GT(n.z, 0);  // a mirrored room still faces inwards
}

TEST_F(Obj, FarCoordinatesKeepTheirDigits) {
    const auto part = read("v 1000000.001 2000000 0\nv 1000001 2000000 0\nv 1000000 2000001 0\nf 1 2 3\n");
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->scene.toUser(part->scene.meshes[0].positions[0]).x, 1000000.001, 1e-6);  // a float there: 0.06 m
}

TEST_F(Obj, AppendMovesIndicesAndOrigin) {
    auto first = read("v 1000000 0 0\nv 1000001 0 0\nv 1000000 1 0\nf 1 2 3\n");
    auto second = read("usemtl other\n" + kTriangle);
    ASSERT_TRUE(first && second);
    Scene scene;
    append(scene, std::move(*first));
    append(scene, std::move(*second));
    EXPECT_NEAR(scene.origin.x, 1000000, 1);
    EXPECT_EQ(scene.meshes[1].material, 1U);
    EXPECT_EQ(scene.meshes[1].object, 1U);
    EXPECT_EQ(scene.toUser(scene.meshes[1].positions[0]).x, 0);
}

TEST_F(Obj, MaterialKinds) {
    EXPECT_EQ(material("Kd 0.2 0.3 0.4\n").kind, MaterialKind::Matte);
    const auto plastic = material("Kd 0.8 0.8 0.8\nKs 0.5 0.5 0.5\nNs 100\nillum 2\n");
    EXPECT_EQ(plastic.kind, MaterialKind::Plastic);
    EXPECT_LE((plastic.reflectance + plastic.specular).max(), 1.0F);
    EXPECT_EQ(material("Kd 0 0 0\nKs 0.9 0.8 0.7\nillum 2\n").kind, MaterialKind::Metal);
    EXPECT_EQ(material("Kd 0 0 0\nKs 0.9 0.9 0.9\nillum 5\n").kind, MaterialKind::Mirror);
    EXPECT_EQ(material("Kd 0.5 0.5 0.5\nPr 0.3\nPm 1\n").kind, MaterialKind::MetallicRoughness);
    EXPECT_EQ(material("Kd 0.5 0.5 0.5\nd 0.2\nillum 2\n").kind, MaterialKind::Matte);
    const auto glass = material("Kd 0.5 0.5 0.5\nd 0.1\nNi 1.5\nillum 4\n");
    EXPECT_EQ(glass.kind, MaterialKind::ThinGlass);
    EXPECT_NEAR(glass.transmittance.r, 0.9 * 0.96 / 1.04, 1e-6);  // F = 0.04; float rounding
    EXPECT_EQ(material("Kd 0 0 0\nKe 100 200 300\n").emission, (Rgb{100, 200, 300}));
    EXPECT_EQ(material("Kd 2 0.5 0.5\n").reflectance.r, 1.0F);
}

TEST_F(Obj, MissingPicturesAndLibrariesAreWarnings) {
    write("m.mtl", "newmtl m\nKd 0.3 0.3 0.3\nmap_Kd -s 2 2 -o 0.5 0.25 none.png\n");
    const auto part = read("mtllib m.mtl\nmtllib gone.mtl\nusemtl m\n" + kTriangle);
    ASSERT_TRUE(part) << part.error().text();
    EXPECT_EQ(part->scene.materials[0].reflectance, Rgb{0.3F});
    EXPECT_FALSE(part->scene.materials[0].reflectanceTexture.used());
    EXPECT_EQ(part->scene.warnings.size(), 2U);
    EXPECT_THAT(material("Kd 1 1 1\nmap_Kd ../../etc/x.png\n").reflectanceTexture.used(), false);
    write("m.mtl", "newmtl m\nKd a b c\n");
    EXPECT_THAT(read("mtllib m.mtl\n").error().where, HasSubstr("m.mtl:2"));
}

/// The bug: `mtllib a.mtl b.mtl` was taken for one name with a space.
TEST_F(Obj, LibrariesAreNamedAsProgramsWriteThem) {
    write("a.mtl", "newmtl a\nKd 0.1 0.1 0.1\n");
    write("b.mtl", "newmtl b\nKd 0.2 0.2 0.2\n");
    write("my room.mtl", "newmtl c\nKd 0.3 0.3 0.3\n");
    const std::string uses = kTriangle + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n";
    for (const char* lines : {"mtllib a.mtl b.mtl my room.mtl\n", "mtllib my room.mtl a.mtl\nmtllib b.mtl\n",
                              "mtllib \"my room.mtl\"\nmtllib  b.mtl\ta.mtl \r\n", "mtllib .\\a.mtl b.mtl\nmtllib my room.mtl\n"}) {
        const auto part = read(lines + uses);
        ASSERT_TRUE(part) << part.error().text();
        for (const auto& [name, kd] : {std::pair{"a", 0.1F}, {"b", 0.2F}, {"c", 0.3F}}) {
            bool found = false;
            for (const auto& m : part->scene.materials) found |= m.name == name && m.reflectance == Rgb(kd);
            EXPECT_TRUE(found) << lines << name;
        }
    }
    const auto missing = read("mtllib gone one.mtl a.mtl gone.mtl\nusemtl a\n" + kTriangle);
    EXPECT_THAT(missing->scene.warnings, testing::Contains(HasSubstr("gone one.mtl is not there")));
    EXPECT_THAT(missing->scene.warnings, testing::Contains(HasSubstr("/gone.mtl is not there")));
    EXPECT_EQ(missing->scene.materials[0].reflectance, Rgb(0.1F));
}

TEST_F(Obj, FilesOfOtherMachinesAreFoundBesideTheModel) {
    write("Paint.MTL", "newmtl m\nKd 0.3 0.3 0.3\n");
    for (const char* name : {"paint.mtl", "C:\\Users\\me\\Paint.mtl", "/models/paint.mtl", "..\\lib\\PAINT.mtl"}) {
        const auto part = read(std::string("mtllib ") + name + "\nusemtl m\n" + kTriangle);
        ASSERT_TRUE(part) << name << part.error().text();
        EXPECT_EQ(part->scene.materials.at(0).reflectance, Rgb(0.3F)) << name;
        EXPECT_THAT(part->scene.warnings, testing::Contains(HasSubstr("taken is 'Paint.MTL'"))) << name;
    }
    EXPECT_FALSE(read("mtllib C:\\Users\\me\\other.mtl\n" + kTriangle));
}

/// The colours of vertices were dropped without a word: a red model came out grey.
TEST_F(Obj, VertexColoursAreTheFacesReflectances) {
    const auto part = read("v 0 0 0 0.8 0.1 0.4\nv 1 0 0 0.8 0.1 0.4\nv 0 1 0 0.8 0.1 0.4\nv 1 1 0 0.2 0.1 0\n"
                           "v 5 5 5\nf 1 2 3\nf 2 4 3\nf 1 2 5\n");
    ASSERT_TRUE(part) << part.error().text();
    const auto& s = part->scene;
    ASSERT_EQ(s.meshes.size(), 2U);
    const auto& mesh = s.meshes[0];
    const auto& material = s.materials[mesh.material];
    ASSERT_EQ(material.reflectanceTexture.texture, 0);
    const auto colour = [&](std::size_t triangle) {
        const auto texel = s.textures[0].sample(mesh.uvs[mesh.triangles[triangle][0]]);
        return Vec3(texel.r * material.reflectance.r, texel.g * material.reflectance.g, texel.b * material.reflectance.b);
    };
    // Texels are 8 bits of the largest of each channel: half a step of 0.8 / 255.
    EXPECT_LT((colour(0) - Vec3(0.8F, 0.1F, 0.4F)).length(), 0.003F);
    EXPECT_LT((colour(1) - Vec3(0.6F, 0.1F, 0.8F / 3)).length(), 0.003F) << "the mean of its corners";
    EXPECT_THAT(s.warnings, testing::Contains(HasSubstr("vertex colours are taken as reflectances")));
    EXPECT_THAT(s.warnings, testing::Contains(HasSubstr("not all corners")));
    EXPECT_EQ(s.materials[s.meshes[1].material].reflectance, Rgb(0.5F));

    write("m.mtl", "newmtl m\nKd 0.3 0.3 0.3\n");
    const std::string red = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n";
    const auto described = read("mtllib m.mtl\nusemtl m\n" + red + "f 1 2 3\n");
    EXPECT_EQ(described->scene.materials.at(0).reflectance, Rgb(0.3F));
    EXPECT_THAT(described->scene.warnings, testing::Contains(HasSubstr("vertex colours are left out")));
    const auto bytes = read("v 0 0 0 255 0 51\nv 1 0 0 255 0 51\nv 0 1 0 255 0 51\nf 1 2 3\n");
    EXPECT_EQ(bytes->scene.materials.at(0).reflectance, (Rgb{1, 0, 0.2F}));
    EXPECT_THAT(bytes->scene.warnings, testing::Contains(HasSubstr("counting to 255")));
}

TEST_F(Obj, ManyColoursFitOnePicture) {
    std::string text;
    for (int i = 0; i < 70000; ++i) text += fmt::format("v {} 0 0 {:.6f} {:.6f} 0.5\n", i % 7, (i % 300) / 300.0, (i / 300) / 300.0);
    for (int i = 1; i + 2 <= 70000; i += 3) text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
    const auto part = read(text);
    ASSERT_TRUE(part) << part.error().text();
    const auto& texture = part->scene.textures.at(0);
    EXPECT_LE(texture.width * texture.height, 65536);
    EXPECT_EQ(texture.rgba.size(), std::size_t{4} * static_cast<std::size_t>(texture.width * texture.height));
}

TEST_F(Obj, CutsConcavePolygons) {
    // An L of three unit squares, listed both ways round.
    const std::string corners = "v 0 0 5\nv 2 0 5\nv 2 1 5\nv 1 1 5\nv 1 2 5\nv 0 2 5\n";
    for (const char* face : {"f 1 2 3 4 5 6\n", "f 6 5 4 3 2 1\n", "f 4 5 6 1 2 3\n"}) {
        const auto part = read(corners + face);
        ASSERT_TRUE(part);
        EXPECT_EQ(part->scene.triangleCount(), 4U);
        EXPECT_DOUBLE_EQ(area(part->scene), 3.0);  // triangles that overlap or stick out would add up to more
    }
}

TEST(Polygon, StarsOfAnySizeKeepTheirArea) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(0.2, 1.0);
    for (const std::size_t n : {4U, 5U, 17U, 200U, 1500U}) {
        std::vector<Vec3d> corners;
        double expected = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = 2 * kPiD * double(i) / double(n), r = radius(random);
            corners.emplace_back(r * std::cos(angle), 1.0, r * std::sin(angle));
        }
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3d &a = corners[i], &b = corners[(i + 1) % n];
            expected += 0.5 * (a.x * b.z - a.z * b.x);
        }
        std::vector<std::array<std::uint32_t, 3>> triangles;
        ASSERT_TRUE(obj::triangulate(corners, triangles));
        ASSERT_EQ(triangles.size(), n - 2);
        double sum = 0;
        for (const auto& t : triangles) sum += 0.5 * (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).length();
        EXPECT_NEAR(sum, std::abs(expected), 1e-10);  // some thousand roundings of 1e-16 each
    }
}

TEST(Polygon, DegenerateOnesEnd) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::vector<Vec3d> point(10, Vec3d(1, 2, 3));
    EXPECT_TRUE(obj::triangulate(point, triangles));
    EXPECT_EQ(triangles.size(), 8U);
    const std::vector<Vec3d> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_TRUE(obj::triangulate(bow, triangles));
    EXPECT_EQ(triangles.size(), 2U);
}

TEST(ChooseOrigin, StaysNearAndRoundsFar) {
    EXPECT_EQ(chooseOrigin(Box3d()), Vec3d(0, 0, 0));
    EXPECT_EQ(chooseOrigin(Box3d({-5, -5, 0}, {60, 5, 3})), Vec3d(0, 0, 0));
    EXPECT_EQ(chooseOrigin(Box3d({1e6, 0, 0}, {1e6 + 10.6, 4, 3})), Vec3d(1000005, 2, 2));
    EXPECT_EQ(chooseOrigin(Box3d({-1e4, -1e4, 0}, {1e4, 1e4, 10})), Vec3d(0, 0, 0));
}

TEST(ObjFiles, FurnishedRoomsLoadWhole) {
    const fs::path folder = fs::path(LUXDECK_SOURCE_DIR) / "../shared/data/obj";
    if (!fs::exists(folder)) GTEST_SKIP() << "test data is not there: " << folder;
    const struct {
        const char* name;
        std::size_t triangles, materials;
    } rooms[] = {{"church", 74736, 15}, {"fireplace_room", 128295, 19}};
    for (const auto& room : rooms) {
        auto part = readObj(folder / room.name / "scene.obj", {});
        ASSERT_TRUE(part) << part.error().text();
        EXPECT_EQ(part->scene.triangleCount(), room.triangles);
        EXPECT_EQ(part->scene.materials.size(), room.materials);
        EXPECT_TRUE(part->scene.warnings.empty());
        EXPECT_TRUE(validate(part->scene));
    }
}

}  // namespace
}  // namespace luxdeck

#include "engine/io/project.h"

#include "engine/io/project_keys.h"
#include "tests/support/project_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace luxdeck::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

TEST_F(ProjectTest, ReadsEverySection) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    const auto& p = *project;
    EXPECT_EQ(p.info.name, "Test office");
    EXPECT_EQ(p.info.date, "2026-11-22");
    EXPECT_EQ(p.info.notes.size(), 2U);
    EXPECT_EQ(p.file, folder_ / "project.toml");
    EXPECT_EQ(p.fileHash.size(), 16U);
    EXPECT_EQ(p.scene.hash.size(), 16U);
    ASSERT_EQ(p.grids.size(), 3U);
    EXPECT_EQ(p.volumes.at(0).firstLevel, (std::array{5, 6, 7}));
    EXPECT_EQ(p.volumes.at(0).secondLevel, 4);
    EXPECT_EQ(p.volumes.at(0).bins, 9);
    EXPECT_EQ(p.holodeckSections.at(0).axes[2], Vec3d(0, 0, 2));
    EXPECT_EQ(p.holodeckSections.at(0).grid, (std::array{8, 8, 4}));
}

TEST_F(ProjectTest, GridsCarryTheirRequirements) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    const auto& task = project->grids[0];
    ASSERT_EQ(task.requirements.size(), 2U);
    EXPECT_EQ(task.requirements[0].name, "Office: writing");
    EXPECT_EQ(task.requirements[0].meanLux, 500.0);
    EXPECT_EQ(task.requirements[1].name, "far") << "from requirements_file; without a name it is called by its id";
    EXPECT_FALSE(task.requirements[1].uniformity.has_value());
    EXPECT_EQ(task.counts, (std::array{5, 6}));
    EXPECT_EQ(project->grids[1].kind, GridKind::Cylindrical);
    EXPECT_EQ(project->grids[1].spacingM, 0.5);
    ASSERT_EQ(project->grids[2].points.size(), 2U);
    EXPECT_EQ(project->grids[2].points[0][1], Vec3d(0, -1, 0)) << "normals are made unit";
    EXPECT_THAT(task.where, HasSubstr("project.toml:"));
}

TEST_F(ProjectTest, PlacesGeometryByScaleThenTurnThenMove) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    // The floor's corner (4, 5, 0): times 2, turned to (-10, 8), moved by (10, 20).
    const auto bounds = project->scene.meshes.at(0);
    Box3d box;
    for (const auto& p : bounds.positions) box.extendBy(project->scene.toUser(p));
    // Floats below 32 m are spaced 2e-6 m.
    EXPECT_LT((box.min - Vec3d(0, 20, 0)).length(), 1e-5);
    EXPECT_LT((box.max - Vec3d(10, 28, 0)).length(), 1e-5);
}

TEST_F(ProjectTest, ReplacesMaterialsByName) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    const auto& materials = project->scene.materials;
    const auto floor = std::find_if(materials.begin(), materials.end(), [](const auto& m) { return m.name == "floor_paint"; });
    ASSERT_NE(floor, materials.end());
    EXPECT_EQ(floor->kind, MaterialKind::Plastic);
    EXPECT_EQ(floor->reflectance, Rgb(0.3F, 0.25F, 0.2F));
    EXPECT_EQ(floor->specular, Rgb(0.05F));
    EXPECT_EQ(floor->emission, Rgb(5.0F));
    EXPECT_EQ(floor->source, "data sheet");
}

TEST_F(ProjectTest, ReadsWardSurfacesAndSolids) {
    const auto floor = [&](const std::string& as) {
        std::string text = kWhole;
        const std::string plastic = "kind = \"plastic\"\nreflectance = [0.3, 0.25, 0.2]\nspecular = 0.05\nroughness = 0.4";
        text.replace(text.find(plastic), plastic.size(), as);
        const auto project = load(text);
        EXPECT_TRUE(project) << project.error().text();
        Material none;
        if (!project) return none;
        for (const auto& m : project->scene.materials)
            if (m.name == "floor_paint") return m;
        return none;
    };
    const auto trans = floor("kind = \"trans\"\nreflectance = 0.2\ndiffuse_transmittance = 0.3\nspecular_transmittance = [0.1, 0.2, 0.3]\n"
                             "roughness_u = 0.1\nroughness_v = 0.2\ngrain = [0, 1, 0]");
    EXPECT_EQ(trans.kind, MaterialKind::Ward);
    EXPECT_EQ(trans.specular, Rgb(0.0F));
    EXPECT_EQ(trans.diffuseTransmittance, Rgb(0.3F));
    EXPECT_EQ(trans.specularTransmittance, Rgb(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(trans.wardU, 0.1F);
    EXPECT_EQ(trans.wardV, 0.2F);
    EXPECT_EQ(trans.grain, Vec3(0, 1, 0));
    const auto ward = floor("kind = \"ward\"\nreflectance = 0.2\nspecular = 0.1\nroughness_u = 0.1");
    EXPECT_EQ(ward.wardV, 0.1F);
    const auto solid = floor("kind = \"dielectric\"\nior = 1.33");
    EXPECT_EQ(solid.kind, MaterialKind::Dielectric);
    EXPECT_EQ(solid.transmittance, Rgb(1.0F));
}

TEST_F(ProjectTest, PlacesLuminairesInRowsAndByName) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    const auto& scene = project->scene;
    ASSERT_EQ(scene.luminaires.size(), 7U);
    EXPECT_EQ(scene.luminaires[0].name, "A1");
    EXPECT_EQ(scene.luminaires[5].name, "A6");
    EXPECT_LT((scene.toUser(scene.luminaires[3].position) - Vec3d(9.5, 26, 5)).length(), 1e-5);  // float spacing
    EXPECT_DOUBLE_EQ(scene.luminaires[0].maintenanceFactor, 0.8);
    const auto& spot = scene.luminaires[6];
    EXPECT_EQ(spot.name, "spot");
    EXPECT_DOUBLE_EQ(spot.dimming, 0.5);
    EXPECT_DOUBLE_EQ(spot.maintenanceFactor, 0.9);
    const auto& type = scene.luminaireTypes.at(spot.type);
    EXPECT_EQ(type.id, "A");
    EXPECT_DOUBLE_EQ(type.watts, 28.0);
    // Re-lamped: the luminaire gives the lumens asked for, to rounding.
    EXPECT_NEAR(spot.fluxScale * type.photometry.table.lumens(), 3600.0, 1e-9);
    EXPECT_GT(type.colour.r, type.colour.b) << "4000 K is warmer than white";
}

TEST_F(ProjectTest, NumbersAroundNamesThatAreTaken) {
    const std::string text = std::string(kHead) + R"(
[[luminaire_type]]
id = "A"
file = "a.ies"
[[luminaire]]
type = "A"
position = [0, 0, 3]
[[luminaire]]
type = "A"
name = "A1"
position = [1, 0, 3]
[[luminaire]]
type = "A"
name = "row"
position = [2, 0, 3]
array = { count = [2, 1], spacing = [1, 0] }
)";
    const auto project = load(text);
    ASSERT_TRUE(project) << project.error().text();
    std::vector<std::string> names;
    for (const auto& luminaire : project->scene.luminaires) names.push_back(luminaire.name);
    EXPECT_EQ(names, (std::vector<std::string>{"A2", "A1", "row-1", "row-2"}));
    EXPECT_DOUBLE_EQ(project->scene.luminaireTypes[0].watts, 30.0) << "without a value of the project's, the file's";
    EXPECT_TRUE(project->scene.luminaireTypes[0].colour.isGrey());
}

TEST_F(ProjectTest, SkyGivesTheIlluminanceAskedFor) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    EXPECT_EQ(project->scene.sky.kind, SkyKind::CieOvercast);
    EXPECT_NEAR(project->scene.sky.horizontalLux(), 10000.0, 1e-9);  // one division and one product
    EXPECT_DOUBLE_EQ(project->scene.sky.groundReflectance, 0.1);
}

TEST_F(ProjectTest, Views) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    const auto& door = project->views.at(0);
    EXPECT_LT((door.direction - Vec3d(4, 3, -0.4).normalized()).length(), 1e-12);  // rounding of a normalisation
    EXPECT_EQ(door.up, Vec3d(0, 0, 1));
    EXPECT_EQ(door.width, 640);
    const auto& eye = project->views.at(1);
    EXPECT_EQ(eye.kind, ViewKind::Fisheye);
    EXPECT_EQ(eye.width, eye.height);
    EXPECT_DOUBLE_EQ(eye.verticalFovDeg, 180.0);
}

TEST_F(ProjectTest, PlanViewsHaveNorthUp) {
    const auto project = load(std::string(kHead) + "[[view]]\nname = \"plan\"\nposition = [0, 0, 9]\ndirection = [0, 0, -1]\n");
    ASSERT_TRUE(project) << project.error().text();
    EXPECT_EQ(project->views.at(0).up, Vec3d(0, 1, 0));
}

TEST_F(ProjectTest, Furniture) {
    const auto project = load(kWhole);
    ASSERT_TRUE(project) << project.error().text();
    const auto& objects = project->scene.objects;
    ASSERT_EQ(objects.size(), 3U) << "floor, ceiling, and the chair's two parts as one";
    EXPECT_FALSE(objects[0].movable);
    EXPECT_EQ(objects[1].name, "Ceiling");
    EXPECT_TRUE(objects[1].movable);
    EXPECT_EQ(objects[2].name, "My chair");
    EXPECT_FALSE(objects[2].movable);
    Box3d chair;
    for (const auto& mesh : project->scene.meshes)
        if (mesh.object == 2)
            for (const auto& p : mesh.positions) chair.extendBy(project->scene.toUser(p));
    // 1 m to x, depth to +y and up; turned by 90 degrees about z, then moved. Float spacing below 32 m: 2e-6 m.
    EXPECT_LT((chair.min - Vec3d(4, 25, 0)).length(), 1e-5);
    EXPECT_LT((chair.max - Vec3d(5, 26, 1)).length(), 1e-5);
}

TEST_F(ProjectTest, MovesAnObjectOfTheGeometryAboutItsFoot) {
    const auto moved = load(std::string(kHead) + "[[geometry]]\nfile = \"room.obj\"\nunit = \"m\"\n[[furniture]]\nobject = \"Floor\"\nmove = [10, 0, 0.5]\nturn_deg = 90\n");
    ASSERT_TRUE(moved) << moved.error().text();
    const auto& scene = moved->scene;
    Box3d floor, ceiling;
    for (const auto& mesh : scene.meshes)
        for (const auto& p : mesh.positions) (scene.objects[mesh.object].name == "Floor" ? floor : ceiling).extendBy(scene.toUser(p));
    // 4 x 5 m about (2, 2.5), turned to 5 x 4 m about (12, 2.5). Float spacing below 16 m: 1e-6 m.
    EXPECT_LT((floor.min - Vec3d(9.5, 0.5, 0.5)).length(), 1e-5);
    EXPECT_LT((floor.max - Vec3d(14.5, 4.5, 0.5)).length(), 1e-5);
    EXPECT_LT((ceiling.min - Vec3d(0, 0, 3)).length(), 1e-5);
    EXPECT_TRUE(scene.objects[0].movable);
}

TEST_F(ProjectTest, AFileOfFurnitureIsPlacedByItsPosition) {
    const auto project = load(std::string(kHead) + "[[furniture]]\nfile = \"room.obj\"\nunit = \"m\"\nturn_deg = 90\n");
    ASSERT_FALSE(project);
    EXPECT_THAT(project.error().text(), HasSubstr("file and turn_deg exclude each other"));
}

TEST_F(ProjectTest, AnEmptyProjectIsAProject) {
    const auto project = load(kHead);
    ASSERT_TRUE(project) << project.error().text();
    EXPECT_EQ(project->info.name, "project");
    EXPECT_TRUE(project->views.empty());
    EXPECT_TRUE(project->grids.empty());
}

TEST_F(ProjectTest, LuminairesFarAwayAreRebasedWithoutGeometry) {
    const auto project = load(std::string(kHead) +
                              "[[luminaire_type]]\nid = \"A\"\nfile = \"a.ies\"\n"
                              "[[luminaire]]\ntype = \"A\"\nposition = [1000000.125, 2000000.25, 3]\n");
    ASSERT_TRUE(project) << project.error().text();
    const auto& scene = project->scene;
    EXPECT_EQ(scene.toUser(scene.luminaires[0].position), Vec3d(1000000.125, 2000000.25, 3));
}

TEST_F(ProjectTest, WarnsOfAnUnusedType) {
    const auto project = load(std::string(kHead) + "[[luminaire_type]]\nid = \"A\"\nfile = \"a.ies\"\n");
    ASSERT_TRUE(project) << project.error().text();
    EXPECT_THAT(project->scene.warnings, Contains(HasSubstr(at(3) + ": [[luminaire_type]] \"A\": no luminaire is of type")));
}

TEST_F(ProjectTest, ABareModelGetsAViewFromItsCorner) {
    const auto project = loadProject(folder_ / "room.obj");
    ASSERT_TRUE(project) << project.error().text();
    EXPECT_TRUE(project->grids.empty());
    ASSERT_EQ(project->views.size(), 1U);
    const auto& view = project->views[0];
    Box3d box;
    for (const auto& mesh : project->scene.meshes)
        for (const auto& p : mesh.positions) box.extendBy(project->scene.toUser(p));
    EXPECT_TRUE(box.intersects(view.position));
    EXPECT_GT(view.direction.dot(box.center() - view.position), 0.0);
    EXPECT_NEAR(view.direction.length(), 1.0, 1e-12);  // rounding of a normalisation
    EXPECT_THAT(project->scene.warnings, Contains(HasSubstr("y up")));
}

TEST_F(ProjectTest, DocumentationNamesEveryKey) {
    std::ifstream in(fs::path(LUXDECK_SOURCE_DIR) / "docs/project-format.md");
    ASSERT_TRUE(in) << "docs/project-format.md is missing";
    std::stringstream all;
    all << in.rdbuf();
    const auto text = all.str();
    for (const auto* section : project::kSections) {
        const auto heading = "\n## `" + std::string(section->title) + "`";
        const auto begin = text.find(heading);
        ASSERT_NE(begin, std::string::npos) << heading;
        const auto body = text.substr(begin, text.find("\n## ", begin + 4) - begin);
        for (const auto key : section->keys) EXPECT_THAT(body, HasSubstr("\n| `" + std::string(key) + "` |")) << section->title;
    }
}

TEST_F(ProjectTest, DocumentedMinimalProjectWorks) {
    std::ifstream in(fs::path(LUXDECK_SOURCE_DIR) / "docs/project-format.md");
    std::stringstream all;
    all << in.rdbuf();
    const auto text = all.str();
    const auto begin = text.find("```toml\n");
    ASSERT_NE(begin, std::string::npos);
    const auto end = text.find("```", begin + 8);
    fs::create_directories(folder_ / "luminaires");
    write("luminaires/panel.ies", kIes);
    const auto project = load(text.substr(begin + 8, end - begin - 8));
    ASSERT_TRUE(project) << project.error().text();
    EXPECT_EQ(project->scene.luminaires.size(), 12U);
}

}  // namespace
}  // namespace luxdeck::test

#include "engine/io/project.h"

#include "engine/io/project_aim.h"
#include "engine/io/project_colour.h"
#include "engine/io/project_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr const char* kIes = R"(IESNA:LM-63-2002
[TEST] made for a test
[MANUFAC] Luxdeck
TILT=NONE
1 1000 1 3 1 1 2 0 0 0
1 1 30
0 45 90
0
300 200 0
)";

constexpr const char* kRoomObj = R"(mtllib room.mtl
o Floor
v 0 0 0
v 4 0 0
v 4 5 0
v 0 5 0
usemtl floor_paint
f 1 2 3 4
o Ceiling
v 0 0 3
v 0 5 3
v 4 5 3
v 4 0 3
usemtl ceiling_paint
f 5 6 7 8
)";

constexpr const char* kRoomMtl = "newmtl floor_paint\nKd 0.2 0.2 0.2\nnewmtl ceiling_paint\nKd 0.7 0.7 0.7\n";

/// Every section, and every key at least once.
constexpr const char* kWhole = R"(schema = "luxdeck-project/1"
requirements_file = "requirements.toml"

[project]
name = "Test office"
client = "A client"
designer = "A designer"
location = "Here"
date = 2026-11-22
description = "One room"
notes = ["first", "second"]

[[geometry]]
file = "room.obj"
unit = "m"
up = "z"
translate = [10, 20, 0]
rotate_z_deg = 90
scale = 2

[[material]]
name = "floor_paint"
kind = "plastic"
reflectance = [0.3, 0.25, 0.2]
specular = 0.05
roughness = 0.4
emission_cd_m2 = 5
source = "data sheet"

[[luminaire_type]]
id = "A"
file = "a.ies"
description = "Panel"
lumens = 3600
watts = 28
maintenance_factor = 0.8
colour_temperature_k = 4000

[[luminaire]]
type = "A"
position = [8, 24, 5]
array = { count = [2, 3], spacing = [1.5, 2] }

[[luminaire]]
type = "A"
name = "spot"
position = [6, 24, 5]
aim = [0, 1, -1]
rotation_deg = 90
dimming = 0.5
maintenance_factor = 0.9

[sky]
kind = "cie-overcast"
horizontal_lux = 10000
ground_reflectance = 0.1

[[requirement]]
id = "office"
name = "Office: writing"
source = "EN 12464-1"
mean_lux = 500
minimum_lux = 300
uniformity = 0.6

[[grid]]
name = "Task"
kind = "planar"
origin = [2, 22, 0.75]
u = [4, 0, 0]
v = [0, 4, 0]
border = 0.5
counts = [5, 6]
requirements = ["office", "far"]

[[grid]]
name = "Faces"
kind = "cylindrical"
origin = [2, 22, 1.2]
u = [4, 0, 0]
v = [0, 4, 0]
spacing = 0.5
requirement = "office"

[[grid]]
name = "Board"
points = [[2, 22, 1, 0, -2, 0],
          [3, 22, 1, 0, -1, 0]]

[[view]]
name = "door"
kind = "perspective"
position = [2, 21, 1.6]
target = [6, 24, 1.2]
up = [0, 0, 2]
vertical_fov_deg = 60
size = [640, 480]

[[view]]
name = "eye"
kind = "fisheye"
position = [2, 21, 1.2]
direction = [0, 3, 0]

[[volume]]
name = "room"
min = [0, 20, 0]
max = [10, 28, 6]
first_level = [5, 6, 7]
second_level = 4
bins = 9

[[holodeck_section]]
name = "walk"
origin = [1, 21, 0.5]
axes = [[4, 0, 0], [0, 4, 0], [0, 0, 2]]
grid = [8, 8, 4]

[[furniture]]
object = "Ceiling"
movable = true

[[furniture]]
file = "chair.obj"
name = "My chair"
unit = "cm"
up = "y"
scale = 1
position = [5, 25, 0]
rotation_deg = 90
movable = false
)";

constexpr const char* kHead = "schema = \"luxdeck-project/1\"\n";

int lineAt(const std::string& text, std::size_t offset) {
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

class ProjectTest : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("luxdeck_project_" + std::to_string(::getpid()) + "_" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_);
        write("a.ies", kIes);
        write("room.obj", kRoomObj);
        write("room.mtl", kRoomMtl);
        write("chair.obj", "o Seat\nv 0 0 0\nv 100 0 0\nv 0 0 -100\nf 1 2 3\no Back\nv 0 0 0\nv 0 100 0\nv 0 0 -100\nf 4 5 6\n");
        write("requirements.toml", "[[requirement]]\nid = \"far\"\nmean_lux = 200\n");
    }
    void TearDown() override {
        std::error_code ec;
        fs::remove_all(folder_, ec);
    }

    void write(const std::string& name, const std::string& text) const {
        fs::remove(folder_ / name);  // overwriting makes ext4 wait for the disk, thousands of times here
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    [[nodiscard]] Result<Project> load(const std::string& text) const {
        write("project.toml", text);
        return loadProject(folder_ / "project.toml");
    }
    [[nodiscard]] std::string at(int line, const std::string& file = "project.toml") const {
        return (folder_ / file).string() + ":" + std::to_string(line);
    }

    /// The error that kWhole gives with `find` replaced; it must stand where `find` was, or `linesBefore` it.
    Error refused(const std::string& find, const std::string& replacement, int linesBefore = 0) {
        std::string text = kWhole;
        const auto offset = text.find(find);
        if (offset == std::string::npos) {
            ADD_FAILURE() << "the project has no " << find;
            return {};
        }
        text.replace(offset, find.size(), replacement);
        const auto project = load(text);
        if (project) {
            ADD_FAILURE() << "was accepted: " << replacement;
            return {};
        }
        EXPECT_EQ(project.error().where, at(lineAt(text, offset) - linesBefore)) << project.error().text();
        return project.error();
    }

    fs::path folder_;
};

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

TEST_F(ProjectTest, UnknownKeysNameTheNearest) {
    EXPECT_THAT(refused("rotation_deg = 90", "rotaton_deg = 90").message, HasSubstr("did you mean \"rotation_deg\"?"));
    EXPECT_THAT(refused("[sky]\n", "[skye]\n").message, HasSubstr("did you mean \"sky\"?"));
    EXPECT_THAT(refused("bins = 9", "xyzzy = 9").message, HasSubstr("known are \"name\", \"min\""));
    EXPECT_THAT(refused("spacing = [1.5, 2]", "spacing = [1.5, 2], step = 1").message, HasSubstr("unknown key \"step\""));
}

TEST_F(ProjectTest, WrongTypes) {
    EXPECT_EQ(refused("dimming = 0.5", "dimming = \"half\"").code, ErrorCode::Parse);
    EXPECT_THAT(refused("position = [6, 24, 5]", "position = [6, 24]").message,
                HasSubstr("[[luminaire]] \"spot\": position is an array of 2, expected an array of 3 numbers"));
    EXPECT_THAT(refused("notes = [\"first\", \"second\"]", "notes = [1]").message, HasSubstr("array of strings"));
    EXPECT_THAT(refused("movable = true", "movable = 1").message, HasSubstr("expected true or false"));
    EXPECT_THAT(refused("size = [640, 480]", "size = [640.5, 480]").message, HasSubstr("2 integers"));
    EXPECT_THAT(refused("bins = 9", "bins = 9.5").message, HasSubstr("integer"));
    EXPECT_THAT(refused("[sky]", "[[sky]]").message, HasSubstr("[sky]"));
    EXPECT_THAT(refused("name = \"spot\"", "name = 3").message, HasSubstr("name is an integer, expected a string"));
    EXPECT_THAT(refused("reflectance = [0.3, 0.25, 0.2]", "reflectance = [0.3, 0.25]").message, HasSubstr("[r, g, b]"));
    EXPECT_THAT(refused("[3, 22, 1, 0, -1, 0]]", "[3, 22, 1]]").message, HasSubstr("points[1] is not an array of 6 numbers"));
}

TEST_F(ProjectTest, Ranges) {
    EXPECT_EQ(refused("dimming = 0.5", "dimming = 1.5").message, "[[luminaire]] \"spot\": dimming is 1.5, expected 0 .. 1");
    EXPECT_EQ(refused("dimming = 0.5", "dimming = nan").code, ErrorCode::InvalidArgument);
    refused("maintenance_factor = 0.8", "maintenance_factor = 0");
    refused("maintenance_factor = 0.9", "maintenance_factor = 1.01");
    refused("reflectance = [0.3, 0.25, 0.2]", "reflectance = 1");
    refused("reflectance = [0.3, 0.25, 0.2]", "reflectance = [0.3, -0.25, 0.2]");
    refused("emission_cd_m2 = 5", "emission_cd_m2 = inf");
    refused("lumens = 3600", "lumens = 0");
    refused("colour_temperature_k = 4000", "colour_temperature_k = 500");
    refused("position = [6, 24, 5]", "position = [6, nan, 5]");
    refused("position = [6, 24, 5]", "position = [6, 24, 1e9]");
    refused("aim = [0, 1, -1]", "aim = [0, 0, 0]");
    refused("horizontal_lux = 10000", "horizontal_lux = -1");
    refused("ground_reflectance = 0.1", "ground_reflectance = 1");
    refused("uniformity = 0.6", "uniformity = 1.2");
    refused("size = [640, 480]", "size = [0, 480]");
    refused("vertical_fov_deg = 60", "vertical_fov_deg = 180");
    refused("first_level = [5, 6, 7]", "first_level = [5, 6, 1]");
    refused("grid = [8, 8, 4]", "grid = [8, 8, 65]");
    refused("scale = 2", "scale = 0");
    refused("spacing = 0.5", "spacing = 1e-4");
}

TEST_F(ProjectTest, AlmostPerfectReflectanceIsAWarning) {
    std::string text = kWhole;
    text.replace(text.find("[0.3, 0.25, 0.2]"), 16, "0.9995");
    const auto project = load(text);
    ASSERT_TRUE(project) << project.error().text();
    EXPECT_THAT(project->scene.warnings, Contains(HasSubstr("reflectance is 0.9995")));
}

TEST_F(ProjectTest, MissingKeysStandAtTheirTable) {
    EXPECT_THAT(refused("type = \"A\"\nposition = [8, 24, 5]", "type = \"A\"", 1).message, HasSubstr("position is missing"));
    EXPECT_THAT(refused("id = \"A\"\n", "", 1).message, HasSubstr("id is missing"));
    EXPECT_THAT(refused("name = \"Task\"\n", "", 1).message, HasSubstr("name is missing"));
    EXPECT_THAT(refused("kind = \"cie-overcast\"\n", "", 1).message, HasSubstr("kind is missing"));
    EXPECT_THAT(refused("schema = \"luxdeck-project/1\"\n", "").message, HasSubstr("schema is missing"));
    EXPECT_THAT(refused("unit = \"m\"\n", "", 1).message, HasSubstr("unit is missing"));
}

TEST_F(ProjectTest, MissingFilesStandAtTheLineThatNamesThem) {
    for (const auto& [file, key] : {std::pair{"a.ies", "file"}, std::pair{"room.obj", "file"},
                                    std::pair{"chair.obj", "file"}, std::pair{"requirements.toml", "requirements_file"}}) {
        const auto line = std::string(key) + " = \"" + file + "\"";
        const auto error = refused(line, std::string(key) + " = \"gone/" + file + "\"");
        EXPECT_EQ(error.code, ErrorCode::FileNotFound);
        EXPECT_THAT(error.message, HasSubstr(std::string("gone/") + file));
    }
    EXPECT_EQ(refused("file = \"a.ies\"", "file = \".\"").code, ErrorCode::FileNotFound);
}

TEST_F(ProjectTest, ErrorsInNamedFilesSayWhereTheyWereNamed) {
    write("a.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 30\n0 45 90\n0\n300 two hundred\n");
    const auto error = refused("file = \"a.ies\"", "file = \"a.ies\"");
    EXPECT_THAT(error.message, HasSubstr("luminaire type \"A\" -> a.ies:"));
    write("a.ies", kIes);
    write("requirements.toml", "[[requirement]]\nid = \"far\"\nmean_lux = -200\n");
    const auto project = load(kWhole);
    ASSERT_FALSE(project);
    EXPECT_EQ(project.error().where, at(3, "requirements.toml"));
}

TEST_F(ProjectTest, NamesAreUnique) {
    EXPECT_THAT(refused("name = \"Faces\"", "name = \"Task\"").message, HasSubstr("is taken: it stands at " + at(67)));
    refused("name = \"eye\"", "name = \"door\"");
    EXPECT_THAT(refused("uniformity = 0.6\n", "uniformity = 0.6\n[[requirement]]\nid=\"office\"\nmean_lux = 1\n", -2).message,
                HasSubstr("id \"office\" is taken"));
    write("requirements.toml", "[[requirement]]\nid = \"office\"\nmean_lux = 200\n");
    const auto twice = load(kWhole);
    ASSERT_FALSE(twice);
}

TEST_F(ProjectTest, ReferencesMustBeThere) {
    EXPECT_THAT(refused("requirement = \"office\"", "requirement = \"ofice\"").message, HasSubstr("did you mean \"office\"?"));
    EXPECT_THAT(refused("requirements = [\"office\", \"far\"]", "requirements = [\"far\", \"near\"]").message,
                HasSubstr("\"near\" is no [[requirement]]"));
    EXPECT_THAT(refused("type = \"A\"\nname", "type = \"B\"\nname").message, HasSubstr("\"B\" is no [[luminaire_type]]"));
    EXPECT_THAT(refused("name = \"floor_paint\"", "name = \"floor paint\"").message, HasSubstr("did you mean \"floor_paint\"?"));
    EXPECT_THAT(refused("object = \"Ceiling\"", "object = \"Cieling\"", 1).message, HasSubstr("did you mean \"Ceiling\"?"));
}

TEST_F(ProjectTest, Choices) {
    EXPECT_EQ(refused("kind = \"cie-overcast\"", "kind = \"cie-clear\"").code, ErrorCode::Unsupported);
    EXPECT_THAT(refused("kind = \"plastic\"", "kind = \"plastik\"").message, HasSubstr("did you mean \"plastic\"?"));
    EXPECT_THAT(refused("unit = \"m\"", "unit = \"yd\"").message, HasSubstr("expected one of \"m\", \"cm\""));
    EXPECT_THAT(refused("schema = \"luxdeck-project/1\"", "schema = \"luxdeck-project/2\"").message, HasSubstr("expected \"luxdeck-project/1\""));
}

TEST_F(ProjectTest, KeysOfAnotherKindOfMaterialAreRefused) {
    const auto error = refused("roughness = 0.4", "transmittance = 0.8");
    EXPECT_THAT(error.message, HasSubstr("transmittance has no meaning for kind \"plastic\""));
    EXPECT_THAT(error.message, HasSubstr("belongs to glass"));
    EXPECT_THAT(refused("kind = \"plastic\"\nreflectance = [0.3, 0.25, 0.2]\nspecular = 0.05\nroughness = 0.4",
                        "kind = \"glass\"\ntransmittance = 0.95", -1).message,
                HasSubstr("a clear pane of ior 1.52 lets through 0.918"));
}

TEST_F(ProjectTest, GeometryOfGridsViewsAndVolumes) {
    EXPECT_THAT(refused("u = [4, 0, 0]", "u = [0, 3, 0]").message, HasSubstr("span no area"));
    EXPECT_THAT(refused("border = 0.5", "border = 2").message, HasSubstr("nothing is left"));
    EXPECT_THAT(refused("counts = [5, 6]", "counts = [5000, 6000]").message, HasSubstr("30000000 points"));
    EXPECT_THAT(refused("counts = [5, 6]", "counts = [5, 6]\nspacing = 1", -1).message, HasSubstr("exclude each other"));
    EXPECT_THAT(refused("target = [6, 24, 1.2]", "target = [2, 21, 1.6]").message, HasSubstr("target is the position"));
    EXPECT_THAT(refused("up = [0, 0, 2]", "up = [4, 3, -0.4]").message, HasSubstr("along the direction"));
    EXPECT_THAT(refused("max = [10, 28, 6]", "max = [10, 28, 0]").message, HasSubstr("max[2] is 0"));
    EXPECT_THAT(refused("[0, 0, 2]]", "[4, 4, 0]]").message, HasSubstr("span no volume"));
    EXPECT_THAT(refused("[2, 22, 1, 0, -2, 0]", "[2, 22, 1, 0, 0, 0]").message, HasSubstr("points[0] has the normal (0, 0, 0)"));
}

TEST_F(ProjectTest, ArraysAreLimited) {
    EXPECT_THAT(refused("count = [2, 3]", "count = [1001, 1000]").message, HasSubstr("at most 1000000"));
    refused("count = [2, 3]", "count = [2, 9223372036854775807]");
    refused("spacing = [1.5, 2]", "spacing = [1.5, 0]");
}

TEST_F(ProjectTest, TheFirstErrorInTheFileIsTold) {
    std::string text = kWhole;
    text.replace(text.find("dimming = 0.5"), 13, "dimming = 5.0");
    text.replace(text.find("scale = 2"), 9, "scale = 0");
    const auto project = load(text);
    ASSERT_FALSE(project);
    EXPECT_THAT(project.error().message, HasSubstr("scale is 0"));
}

TEST_F(ProjectTest, SyntaxErrorsHaveALine) {
    const auto project = load(std::string(kHead) + "[sky]\nkind = \n");
    ASSERT_FALSE(project);
    EXPECT_EQ(project.error().code, ErrorCode::Parse);
    EXPECT_EQ(project.error().where, at(3));
    EXPECT_FALSE(load(std::string("\xFF\xFE\x00\x01 not text", 14)));
    EXPECT_FALSE(load(std::string(100000, '[')));
    std::string deep = std::string(kHead) + "# dots in comments... and strings are text\nx = \"\"\"a\n.\"\"\"\"\na";
    for (int i = 0; i < 100000; ++i) deep += i % 2 == 0 ? ".\"a.\"" : " . b";
    const auto dotted = load(deep + " = 1\n");
    ASSERT_FALSE(dotted) << "a hundred thousand tables within each other overflow the stack when they are cleared";
    EXPECT_EQ(dotted.error().where, at(5));
    EXPECT_EQ(loadProject(folder_ / "none.toml").error().code, ErrorCode::FileNotFound);
    EXPECT_EQ(loadProject(folder_ / "a.ies").error().code, ErrorCode::Unsupported);
}

// A file cut short anywhere (a full disk, an interrupted copy) is read or refused, never more than that.
TEST_F(ProjectTest, EveryPrefixGivesAResult) {
    const std::string whole = kWhole;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto project = load(whole.substr(0, length));
        if (project) continue;
        EXPECT_THAT(project.error().where, HasSubstr("project.toml:")) << project.error().text() << " at " << length;
        EXPECT_NE(project.error().code, ErrorCode::Internal);
    }
}

// Every line taken away, and every value replaced by one that does not belong there.
TEST_F(ProjectTest, EveryDamagedLineGivesAResult) {
    std::vector<std::string> lines;
    std::istringstream in(kWhole);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto equals = lines[i].find(" = ");
        std::vector<std::string> damaged = {""};
        if (equals != std::string::npos)
            for (const auto* value : {"nan", "-1", "1e300", "\"\"", "[]", "{}", "[[0, 0, 0]]", "9223372036854775807", "true"})
                damaged.push_back(lines[i].substr(0, equals + 3) + value);
        for (const auto& line : damaged) {
            std::string text;
            for (std::size_t j = 0; j < lines.size(); ++j) text += (j == i ? line : lines[j]) + "\n";
            const auto project = load(text);
            if (project) continue;
            EXPECT_THAT(project.error().where, HasSubstr("project.toml:")) << line << ": " << project.error().text();
            EXPECT_NE(project.error().code, ErrorCode::Internal) << line;
        }
    }
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

void expectNear(const Vec3& got, const Vec3& expected) {
    EXPECT_LT((got - expected).length(), 1e-6F) << got << " is not " << expected;  // a few roundings of floats near 1
}

TEST(LuminaireFrame, HangsAsDocumented) {
    const auto down = luminaireFrame({0, 0, -1}, 0);
    expectNear(down.tangent, {1, 0, 0});
    expectNear(down.bitangent, {0, 1, 0});
    expectNear(down.normal, {0, 0, 1});
    const auto turned = luminaireFrame({0, 0, -2}, 90);
    expectNear(turned.tangent, {0, 1, 0});
    expectNear(turned.bitangent, {-1, 0, 0});
    const auto east = luminaireFrame({1, 0, 0}, 0);
    expectNear(east.tangent, {0, 0, 1});
    expectNear(east.bitangent, {0, 1, 0});
    const auto north = luminaireFrame({0, 5, 0}, 0);
    expectNear(north.tangent, {1, 0, 0});
    expectNear(north.bitangent, {0, 0, 1});
    const auto up = luminaireFrame({0, 0, 1}, 0);
    expectNear(up.tangent, {-1, 0, 0});
    expectNear(up.bitangent, {0, 1, 0});
    expectNear(up.normal, {0, 0, -1});
}

TEST(LuminaireFrame, IsRightHandedAndOrthonormalForAnyAim) {
    for (int i = 0; i < 2000; ++i) {
        // Points of a spiral over the sphere, and ever closer to straight up.
        const double z = 1.0 - 2.0 * (i + 0.5) / 2000, turn = 2.4 * i, side = i % 2 == 0 ? std::sqrt(1 - z * z) : std::pow(0.99, i);
        const auto f = luminaireFrame({side * std::cos(turn), side * std::sin(turn), i % 2 == 0 ? z : 1.0}, 7.0 * i);
        expectNear(cross(f.tangent, f.bitangent), f.normal);
        EXPECT_NEAR(dot(f.tangent, f.bitangent), 0.0F, 1e-6F);  // float rounding
        EXPECT_NEAR(f.tangent.length(), 1.0F, 1e-6F);
    }
}

TEST(LuminaireFrame, IsContinuousAboutStraightDown) {
    for (int i = 0; i < 12; ++i) {
        const double tilt = 1e-4, turn = 30.0 * i * kDegree;
        const auto f = luminaireFrame({tilt * std::cos(turn), tilt * std::sin(turn), -1}, 0);
        EXPECT_LT((f.tangent - Vec3(1, 0, 0)).length(), 2e-4F);  // no axis turns further than the aim did
    }
}

TEST(DaylightColour, WhiteIsExactAndLuminanceIsOne) {
    EXPECT_EQ(daylightColour(6500), Rgb(1.0F));
    for (double kelvin = 1667; kelvin <= 25000; kelvin *= 1.03) {
        const auto c = daylightColour(kelvin);
        EXPECT_NEAR(luminance(c), 1.0F, 1e-6F) << kelvin;  // float rounding
        EXPECT_GE(c.min(), 0.0F) << kelvin;
    }
}

TEST(DaylightColour, TurnsFromRedToBlueWithoutSteps) {
    auto before = daylightColour(1667);
    for (double kelvin = 1670; kelvin <= 25000; kelvin += 10) {
        const auto c = daylightColour(kelvin);
        EXPECT_LE(c.r, before.r + 1e-3F) << kelvin;  // the fits' pieces meet to 1e-4 in x and y
        EXPECT_GE(c.b, before.b - 1e-3F) << kelvin;
        EXPECT_LT(std::abs(c.r - before.r), 0.02F) << kelvin;  // 10 K at 1700 K is 0.6 %, of a red near 3
        before = c;
    }
}

TEST(DaylightColour, IncandescentLightHasItsKnownChromaticity) {
    // CIE illuminant A (2856 K) has xy 0.4476, 0.4074. The fit of the locus is good to 0.001; white at 6500 K differs
    // from D65 by 0.0005; the matrix below has four digits.
    const auto c = daylightColour(2856);
    const double x = 0.4124 * c.r + 0.3576 * c.g + 0.1805 * c.b;
    const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    const double z = 0.0193 * c.r + 0.1192 * c.g + 0.9505 * c.b;
    EXPECT_NEAR(x / (x + y + z), 0.4476, 0.002);
    EXPECT_NEAR(y / (x + y + z), 0.4074, 0.002);
}

}  // namespace
}  // namespace luxdeck

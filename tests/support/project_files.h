#pragma once

#include "engine/io/project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <unistd.h>

/// A folder with a whole project in it, for the tests of the project reader.
namespace luxdeck::test {

namespace fs = std::filesystem;

inline constexpr const char* kIes = R"(IESNA:LM-63-2002
[TEST] made for a test
[MANUFAC] Luxdeck
TILT=NONE
1 1000 1 3 1 1 2 0 0 0
1 1 30
0 45 90
0
300 200 0
)";

inline constexpr const char* kRoomObj = R"(mtllib room.mtl
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

inline constexpr const char* kRoomMtl = "newmtl floor_paint\nKd 0.2 0.2 0.2\nnewmtl ceiling_paint\nKd 0.7 0.7 0.7\n";

/// Every section, and every key at least once.
inline constexpr const char* kWhole = R"(schema = "luxdeck-project/1"
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

inline constexpr const char* kHead = "schema = \"luxdeck-project/1\"\n";

inline int lineAt(const std::string& text, std::size_t offset) {
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

}  // namespace luxdeck::test

#include "engine/io/project.h"

#include "tests/support/project_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace luxdeck::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

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
    EXPECT_EQ(refused("kind = \"cie-overcast\"", "kind = \"preetham\"").code, ErrorCode::Unsupported);
    EXPECT_THAT(refused("kind = \"plastic\"", "kind = \"plastik\"").message, HasSubstr("did you mean \"plastic\"?"));
    EXPECT_THAT(refused("unit = \"m\"", "unit = \"yd\"").message, HasSubstr("expected one of \"m\", \"cm\""));
    EXPECT_THAT(refused("schema = \"luxdeck-project/1\"", "schema = \"luxdeck-project/2\"").message, HasSubstr("expected \"luxdeck-project/1\""));
}

TEST_F(ProjectTest, WardSurfacesGiveBackAtMostWhatTheyGet) {
    constexpr const char* kPlastic = "kind = \"plastic\"\nreflectance = [0.3, 0.25, 0.2]\nspecular = 0.05\nroughness = 0.4";
    EXPECT_THAT(refused(kPlastic, "kind = \"trans\"\nreflectance = 0.5\ndiffuse_transmittance = 0.6", -1).message,
                HasSubstr("sums to 1.1, expected at most 1"));
    EXPECT_THAT(refused(kPlastic, "kind = \"ward\"\nreflectance = 0.5\nroughness_u = 0.1\nroughness_v = 0", -3).message,
                HasSubstr("expected both 0 or none"));
    EXPECT_THAT(refused(kPlastic, "kind = \"ward\"\nreflectance = 0.5\ndiffuse_transmittance = 0.1", -2).message, HasSubstr("it belongs to trans"));
    EXPECT_THAT(refused(kPlastic, "kind = \"dielectric\"\nior = 1.5\ntransmittance_per_metre = 1.5", -2).message, HasSubstr("expected 0 .. 1"));
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

}  // namespace
}  // namespace luxdeck::test

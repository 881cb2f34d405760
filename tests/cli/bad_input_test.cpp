#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

/// Files that are cut short, empty, of another kind, lie about their size or hold numbers that are none:
/// refused with exit status 3 and a message that names the file, in little memory, never with a crash.
namespace luxdeck::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

/// The program itself maps about 100 MB of libraries; what the bad files claim starts at 1 GB.
constexpr long kMostKilobytes = 500'000;

std::string binaryNoise() {
    std::string bytes(4096, '\0');
    std::uint32_t state = 12345;
    for (auto& c : bytes) c = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
    return bytes;
}

void expectRefused(const Scratch& scratch, const std::vector<std::string>& arguments, const std::string& name, const std::string& what) {
    const auto result = scratch.run(arguments);
    EXPECT_EQ(result.exitStatus, 3) << what << ": signal " << result.signal << "\n" << result.err;
    EXPECT_FALSE(result.timedOut) << what;
    EXPECT_THAT(result.err, HasSubstr(name)) << what;
    EXPECT_LT(result.peakKilobytes, kMostKilobytes) << what;
}

std::string littleEndian(std::uint32_t value) {
    std::string out;
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift);
    return out;
}

std::string glb(std::uint32_t total, const std::string& json, std::uint32_t claimedJson) {
    return "glTF" + littleEndian(2) + littleEndian(total) + littleEndian(claimedJson) + "JSON" + json;
}

struct BadFile {
    std::string name;
    std::string what;
    std::string bytes;
};

std::vector<BadFile> badScenes() {
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    std::string gltf = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":10000000000}],"bufferViews":[{"buffer":0,"byteLength":10000000000}],)"
                       R"("accessors":[{"bufferView":0,"componentType":5126,"count":800000000,"type":"VEC3"}],)"
                       R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})";
    std::vector<BadFile> files{
        {"a.obj", "an index out of range", obj + "f 1 2 4000000000\n"},
        {"a.obj", "a NaN", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"a.obj", "an infinity", "v 1e400 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"a.obj", "cut short", "v 0 0 0\nv 1 0"},
        {"a.gltf", "10 GB", gltf},
        {"a.gltf", "cut short", gltf.substr(0, gltf.size() / 2)},
        {"a.gltf", "NaN", R"({"asset":{"version":"2.0"},"nodes":[{"translation":[NaN,0,0]}]})"},
        {"a.glb", "4 GB", glb(0xffffffffU, "{}  ", 0xfffffff0U)},
        {"a.glb", "cut short", glb(64, "{", 40)},
        {"project.toml", "cut short", Scratch::roomProject().substr(0, 100) + "\nname = \"unfin"},
        {"project.toml", "a NaN", Scratch::roomProject("", "[[view]]\nname = \"n\"\nposition = [nan, 0, 0]\ntarget = [1, 1, 1]\n")},
        {"project.toml", "too many points", Scratch::roomProject("", "[[grid]]\nname = \"g\"\norigin = [0, 0, 0]\nu = [1, 0, 0]\nv = [0, 1, 0]\ncounts = [100000, 100000]\n")},
        {"project.toml", "10^10 luminaires", Scratch::roomProject("", "[[luminaire]]\ntype = \"A\"\nposition = [1, 1, 1]\narray = { count = [100000, 100000], spacing = [1, 1] }\n")},
    };
    for (const std::string name : {"a.obj", "a.gltf", "a.glb", "project.toml"}) {
        files.push_back({name, "binary", binaryNoise()});
        if (name != "a.obj") files.push_back({name, "empty", ""});  // an empty OBJ is a scene without surfaces
    }
    return files;
}

TEST(BadInput, Scenes) {
    for (const auto& file : badScenes()) {
        const Scratch scratch;
        scratch.writeRoom();
        scratch.write(file.name, file.bytes);
        expectRefused(scratch, {"check", file.name}, file.name, file.name + ", " + file.what);
    }
}

TEST(BadInput, Photometry) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto good = scratch.read("lamp.ies");
    auto changed = [&](const std::string& from, const std::string& to) { return std::string(good).replace(good.find(from), from.size(), to); };
    const std::vector<BadFile> files{
        {"a.ies", "empty", ""}, {"a.ldt", "empty", ""},
        {"a.ies", "binary", binaryNoise()}, {"a.ldt", "binary", binaryNoise()},
        {"a.ies", "cut short", good.substr(0, good.size() - 20)},
        {"a.ies", "10 GB", changed("7 1 1 2", "50000 50000 1 2")},
        {"a.ies", "negative counts", changed("7 1 1 2", "-7 1 1 2")},
        {"a.ies", "NaN", changed("866", "nan")},
        {"a.ies", "infinite", changed("866", "1e999")},
        {"a.ldt", "cut short", "Maker\n1\n1\n24\n15\n"},
        {"a.ldt", "10 GB", "Maker\n1\n1\n100000\n0.01\n100000\n0.01\n"},
    };
    for (const auto& file : files) {
        scratch.write(file.name, file.bytes);
        expectRefused(scratch, {"check", file.name}, file.name, file.name + ", " + file.what);
        expectRefused(scratch, {"check", "--json", file.name}, file.name, file.name + ", " + file.what);
    }
}

TEST(BadInput, Pictures) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run({"render", "project.toml", "-o", "good.exr", "--samples", "1"}).exitStatus, 0);
    const auto good = scratch.read("good.exr");
    const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    const std::vector<BadFile> files{
        {"a.exr", "empty", ""}, {"a.exr", "binary", binaryNoise()}, {"a.exr", "cut in its header", good.substr(0, 200)},
        {"a.exr", "cut in its pixels", good.substr(0, good.size() / 2)},
        {"a.hdr", "empty", ""}, {"a.hdr", "binary", binaryNoise()}, {"a.hdr", "cut short", hdr + "-Y 48 +X 64\n\x02\x02"},
        {"a.hdr", "10 GB", hdr + "-Y 50000 +X 50000\n"}, {"a.hdr", "no size", hdr + "-Y nan +X 64\n"},
        {"a.hdr", "exposure that is none", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=nan\n\n-Y 1 +X 1\n\x01\x01\x01\x81"},
    };
    for (const auto& file : files) {
        scratch.write(file.name, file.bytes);
        expectRefused(scratch, {"tonemap", file.name, "-o", "out.png"}, file.name, file.name + ", " + file.what);
        EXPECT_FALSE(scratch.has("out.png")) << file.what;
    }
}

TEST(BadInput, NamesTheLineOfAMissingFile) {
    const Scratch scratch;
    scratch.writeRoom();
    std::filesystem::remove(scratch.path("lamp.ies"));
    const auto result = scratch.run({"solve", "project.toml"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, ContainsRegex("project\\.toml:(8|9):"));  // [[luminaire_type]] or its file =
    EXPECT_THAT(result.err, HasSubstr("lamp.ies"));
}

TEST(BadInput, NamesTheLineOfARequirementThatIsNotThere) {
    const Scratch scratch;
    scratch.writeRoom();
    scratch.write("project.toml", Scratch::roomProject("", "[[grid]]\nname = \"desk\"\norigin = [0, 0, 1]\nu = [1, 0, 0]\nv = [0, 1, 0]\nrequirement = \"nothing\"\n"));
    const auto result = scratch.run({"solve", "project.toml"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, ContainsRegex("project\\.toml:[0-9]+:"));
    EXPECT_THAT(result.err, HasSubstr("\"nothing\""));
}

/// A furniture row names an object; the model has none of that name.
TEST(BadInput, NamesTheLineOfASurfaceThatIsNotThere) {
    const Scratch scratch;
    scratch.writeRoom();
    scratch.write("project.toml", Scratch::roomProject("", "[[furniture]]\nobject = \"desk 17\"\n"));
    const auto result = scratch.run({"solve", "project.toml"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, ContainsRegex("project\\.toml:[0-9]+:"));
    EXPECT_THAT(result.err, HasSubstr("desk 17"));
}

TEST(BadInput, ReportTwinsThatAreNone) {
    const Scratch scratch;
    for (const std::string bytes : {"", "{", "[]", "{\"schema\": \"other/9\"}"}) {
        scratch.write("a.json", bytes);
        const auto result = scratch.run({"report", "--from", "a.json", "-o", "a.pdf"});
        if (result.exitStatus == 2 && result.err.find("report") != std::string::npos) GTEST_SKIP() << "built without reports";
        EXPECT_EQ(result.exitStatus, 3) << bytes;
        EXPECT_THAT(result.err, HasSubstr("a.json"));
        EXPECT_FALSE(scratch.has("a.pdf"));
    }
}

}  // namespace
}  // namespace luxdeck::test

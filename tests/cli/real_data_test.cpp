#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// A walk over real files, which lie outside the repository.
namespace luxdeck::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<fs::path> filesUnder(const fs::path& folder, const std::vector<std::string>& extensions) {
    std::vector<fs::path> found;
    if (!fs::is_directory(folder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        auto extension = entry.path().extension().string();
        std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// What is wrong with the broken models of the collection, by folder or file.
const std::vector<std::pair<std::string, std::string>> kBroken{
    {"BoxWithInfinites", "expected finite numbers"}, {"IncorrectVertexArrays", "lie outside buffer"}, {"IndexOutOfRange", "but there are"},
    {"MissingBin", "no such file"}, {"RecursiveNodes", "recursive"}, {"SchemaFailures", "expected a whole number"}, {"NoScene", "expected no index"},
    {"draco", "KHR_draco_mesh_compression"}, {"wrongTypes", "expected"}};

std::string expectedComplaint(const fs::path& model) {
    for (const auto& [part, complaint] : kBroken)
        if (model.string().find(part) != std::string::npos) return complaint;
    return {};
}

TEST(RealData, EveryModelLoadsAndRendersOrIsRefusedForTheRightReason) {
    if (sharedData().empty()) GTEST_SKIP() << "no ../shared/data";
    const Scratch scratch;
    auto models = filesUnder(sharedData() / "gltf", {".gltf", ".glb"});
    for (const auto& obj : filesUnder(sharedData() / "obj", {".obj"})) models.push_back(obj);
    ASSERT_FALSE(models.empty());
    for (const auto& model : models) {
        const auto complaint = expectedComplaint(model);
        const auto result = scratch.run({"render", model.string(), "-o", "f.exr", "--samples", "4", "--size", "160", "120"});
        EXPECT_EQ(result.exitStatus, complaint.empty() ? 0 : 3) << model << " signal " << result.signal << "\n" << result.err;
        EXPECT_THAT(result.err, HasSubstr(complaint)) << model;
    }
}

TEST(RealData, ModelsCanBeLitAndSolved) {
    if (sharedData().empty()) GTEST_SKIP() << "no ../shared/data";
    const auto lamp = sharedData() / "photometry" / "ldt" / "fluorescent_luminaire.ldt";
    for (const std::string name : {"obj/fireplace_room/scene.obj", "gltf/BoxTextured-glTF-Binary/BoxTextured.glb", "gltf/ClearCoat-glTF/ClearCoatTest.gltf"}) {
        const Scratch scratch;
        const bool obj = name.ends_with(".obj");
        scratch.write("project.toml", "schema = \"luxdeck-project/1\"\n[project]\nname = \"n\"\n[[geometry]]\nfile = \"" + (sharedData() / name).string() + "\"\n" +
                                          (obj ? "unit = \"m\"\nup = \"y\"\n" : "") + "[[luminaire_type]]\nid = \"A\"\nfile = \"" + lamp.string() +
                                          "\"\n[[luminaire]]\ntype = \"A\"\nposition = [1, -1, 2.2]\n[[grid]]\nname = \"g\"\norigin = [0.8, -1.2, 1]\n"
                                          "u = [0.5, 0, 0]\nv = [0, 0.5, 0]\ncounts = [3, 3]\n");
        const auto result = scratch.run({"solve", "project.toml", "--samples", "256", "--json"});
        ASSERT_EQ(result.exitStatus, 0) << name << result.err;
        const auto json = nlohmann::json::parse(result.out);
        EXPECT_GT(json["grids"][0]["mean"]["value"].get<double>(), 0) << name;
    }
}

TEST(RealData, EveryPhotometricFileKeepsItsFluxOrWarns) {
    if (sharedData().empty()) GTEST_SKIP() << "no ../shared/data";
    const Scratch scratch;
    const auto files = filesUnder(sharedData() / "photometry", {".ies", ".ldt"});
    ASSERT_FALSE(files.empty());
    for (const auto& file : files) {
        const auto json = scratch.json({"check", "--json", file.string()});
        ASSERT_FALSE(json.is_discarded()) << file;
        const double declared = json["lumensDeclared"], integrated = json["lumensIntegrated"];
        bool warned = false;
        for (const auto& warning : json["warnings"]) warned = warned || warning.get<std::string>().starts_with("flux:");
        EXPECT_TRUE(warned || std::abs(integrated - declared) <= 0.01 * declared) << file << " " << declared << " " << integrated;
    }
}

}  // namespace
}  // namespace luxdeck::test

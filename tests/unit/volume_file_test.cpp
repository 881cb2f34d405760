// Volumes as files: what comes back, what is refused, what a killed build leaves.
#include "engine/volume/vertex_journal.h"
#include "engine/volume/volume_build.h"
#include "engine/volume/volume_file.h"
#include "engine/volume/volume_header.h"

#include "engine/core/file.h"
#include "engine/core/rng.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace luxdeck::test {
namespace {

namespace fs = std::filesystem;

class VolumeFile : public testing::Test {
protected:
    VolumeFile() : folder_(fs::temp_directory_path() / ("luxdeck_volume_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~VolumeFile() override {
        std::error_code ec;
        fs::remove_all(folder_, ec);
    }
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_ / name; }

    static VolumeSettings settings() {
        VolumeSettings s;
        s.firstLevel = {3, 3, 3}, s.side = 5, s.samplesPerBin = 2;
        return s;
    }
    static IrradianceVolume build(const Lit& lit, VertexStore* store = nullptr, const Progress& progress = {}) {
        BuildOptions options;
        options.store = store;
        return buildVolume(lit.transport(), *lit.estimator("path"), settings(), options, progress).value();
    }
    static std::string read(const fs::path& file) { return readFile(file).value(); }
    static void write(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

private:
    fs::path folder_;
};

void expectSame(const IrradianceVolume& a, const IrradianceVolume& b) {
    EXPECT_EQ(a.lattice.vertices(), b.lattice.vertices());
    EXPECT_EQ(a.direct, b.direct);
    EXPECT_EQ(a.indirect, b.indirect);
    EXPECT_EQ(a.occupied, b.occupied);
    ASSERT_EQ(a.sources.size(), b.sources.size());
    for (std::size_t v = 0; v < a.sources.size(); ++v) {
        ASSERT_EQ(a.sources[v].size(), b.sources[v].size()) << v;
        for (std::size_t i = 0; i < a.sources[v].size(); ++i) {
            EXPECT_EQ(a.sources[v][i].lux, b.sources[v][i].lux);
            EXPECT_EQ(a.sources[v][i].direction, b.sources[v][i].direction);
        }
        EXPECT_EQ(a.quality[v].lux, b.quality[v].lux);
        EXPECT_EQ(a.quality[v].samples, b.quality[v].samples);
        EXPECT_EQ(a.quality[v].usable(), b.quality[v].usable());
    }
    EXPECT_EQ(settingsText(a.settings), settingsText(b.settings));
    EXPECT_EQ(a.sceneHash, b.sceneHash);
    EXPECT_EQ(a.algorithm, b.algorithm);
}

TEST_F(VolumeFile, ComesBackAsItWas) {
    const Lit lit(furnishedRoom());
    const auto volume = build(lit);
    ASSERT_TRUE(writeVolume(path("v.vtu"), volume));
    const auto again = readVolume(path("v.vtu"));
    ASSERT_TRUE(again) << again.error().text();
    expectSame(volume, *again);
    EXPECT_DOUBLE_EQ(volume.relativeError(), again->relativeError());
    EXPECT_TRUE(checkVolumeIsOf(*again, lit.scene));
}

// Invariant: no cut and no changed byte of the data goes unnoticed, and none ends the process. The file is 40 kB of data.
TEST_F(VolumeFile, RefusesWhatIsCutOffOrChanged) {
    const Lit lit(cubeRoom(0.5F, 1000));
    ASSERT_TRUE(writeVolume(path("v.vtu"), build(lit)));
    const auto bytes = read(path("v.vtu"));
    RandomStream random(4);
    for (int i = 0; i < 200; ++i) {
        const auto cut = parseVolume(bytes.substr(0, random.below(bytes.size() - 40)), "cut.vtu");  // the closing tags may be missing
        ASSERT_FALSE(cut);
        ASSERT_EQ(cut.error().where, "cut.vtu");
        auto changed = bytes;
        const auto at = bytes.find("<AppendedData") + 40 + random.below(bytes.size() - bytes.find("<AppendedData") - 100);
        changed[at] = static_cast<char>(changed[at] ^ (1 << random.below(8)));
        ASSERT_FALSE(parseVolume(changed, "changed.vtu"));
        (void)parseVolume(changed, "changed.vtu", Checksum::Ignored).has_value();  // must not crash
    }
    EXPECT_THAT(parseVolume("<VTKFile/>", "other.vtu").error().message, testing::HasSubstr("luxdeck-volume/1"));
    EXPECT_EQ(readVolume(path("none.vtu")).error().code, ErrorCode::FileNotFound);
}

TEST_F(VolumeFile, NamesWhatChangedInTheScene) {
    auto scene = furnishedRoom();
    scene.objects[0].name = "walls";
    scene.objects.push_back({"desk", true});
    scene.meshes.back().object = static_cast<std::uint32_t>(scene.objects.size() - 1);
    scene.luminaires[1].name = "B";
    const Lit lit(scene);
    const auto volume = build(lit);
    auto moved = scene;
    for (auto& p : moved.meshes.back().positions) p.x += 0.1F;
    moved.luminaires[1].dimming = 0.5;
    const auto changes = sceneChanges(volume, moved);
    EXPECT_THAT(changes, testing::UnorderedElementsAre("object desk changed", "luminaire B changed"));
    EXPECT_THAT(checkVolumeIsOf(volume, moved).error().message, testing::HasSubstr("object desk changed"));
    EXPECT_THAT(sceneChanges(volume, scene), testing::IsEmpty());
}

// Invariant: a build that was stopped anywhere and goes on is the build that was not, bit for bit.
TEST_F(VolumeFile, GoesOnWhereItStopped) {
    const Lit lit(furnishedRoom());
    const auto whole = build(lit);
    const auto identity = buildIdentity(whole.sceneHash, "path", 1, settings());
    int sessions = 0;
    std::size_t known = 0;
    for (bool complete = false; !complete; ++sessions) {
        ASSERT_LT(sessions, 100);
        auto journal = VertexJournal::open(path("v.part"), identity);
        ASSERT_TRUE(journal) << journal.error().text();
        EXPECT_GE((*journal)->found(), known);
        known = (*journal)->found();
        Progress* heard = nullptr;
        Progress progress([&](const ProgressState&) { heard->cancel(); });  // after the first slice
        heard = &progress;
        const auto volume = build(lit, journal->get(), progress);
        complete = volume.complete;
        if (complete) expectSame(whole, volume);
    }
    EXPECT_GT(sessions, 1);
}

// A record that was cut off anywhere is dropped, those before it are kept.
TEST_F(VolumeFile, JournalDropsWhatWasCutOff) {
    const Lit lit(cubeRoom(0.5F, 1000));
    const auto identity = buildIdentity(sceneHash(lit.scene), "path", 1, settings());
    {
        auto journal = VertexJournal::open(path("v.part"), identity);
        ASSERT_TRUE(journal);
        build(lit, journal->get());
    }
    const auto bytes = read(path("v.part"));
    const auto all = VertexJournal::open(path("v.part"), identity).value()->found();
    RandomStream random(9);
    for (int i = 0; i < 50; ++i) {
        write(path("v.part"), bytes.substr(0, random.below(bytes.size())));
        const auto journal = VertexJournal::open(path("v.part"), identity);
        ASSERT_TRUE(journal) << journal.error().text();
        EXPECT_LT((*journal)->found(), all);
    }
    write(path("v.part"), bytes);
    const auto other = VertexJournal::open(path("v.part"), buildIdentity(sceneHash(lit.scene), "path", 2, settings()));
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().message, testing::HasSubstr("belongs to another build"));
    EXPECT_EQ(read(path("v.part")), bytes);  // untouched
}

}  // namespace
}  // namespace luxdeck::test

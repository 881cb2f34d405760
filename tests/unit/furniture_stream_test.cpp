// Models that are not in the scene: read, lit and written piece by piece.
#include "analysis/furniture/shaded_file.h"
#include "analysis/furniture/stream_shade.h"

#include "engine/core/parallel.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace luxdeck::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

struct Folder {
    Folder() {
        auto name = (fs::temp_directory_path() / "luxdeck_stream_XXXXXX").string();
        path = ::mkdtemp(name.data());
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] fs::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return path / name;
    }
    fs::path path;
};

std::string stl(const std::vector<TriangleStream::Triangle>& triangles) {
    std::string out(80, ' ');
    const auto count = static_cast<std::uint32_t>(triangles.size());
    out.append(reinterpret_cast<const char*>(&count), 4);
    for (const auto& t : triangles) {
        out.append(12, '\0');
        for (const auto& p : t) out.append(reinterpret_cast<const char*>(&p), 12);
        out.append(2, '\0');
    }
    return out;
}

/// Light that grows with x: 100 lx upwards at x = 0, 300 at x = 2.
IrradianceVolume gradient() {
    IrradianceVolume v;
    v.settings.side = 9;
    v.lattice = Lattice::create({{0, 0, 0}, {2, 1, 1}}, {1, 1, 1}, 2, 1).value();
    v.quality.resize(8), v.sources.resize(8), v.occupied.resize(1);
    for (auto& q : v.quality) q.samples = 1;
    for (const auto& p : v.lattice.vertices())
        for (std::size_t i = 0; i < v.binCount(); ++i) v.direct.push_back(Rgb{}), v.indirect.push_back(Rgb((100 + 100 * p.x) / kPi));
    return v;
}

VolumeField fieldOf(const IrradianceVolume& v) {
    FieldSettings settings;
    settings.blendBins = true;
    return VolumeField::make(v, settings).value();
}

TEST(TriangleStream, ReadsObjPolygonsAndNegativeIndices) {
    const Folder folder;
    const auto file = folder.write("a.obj", "# a square and a triangle\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -4/1 -3/2 -1/3");
    const auto stream = TriangleStream::open(file).value();
    std::vector<TriangleStream::Triangle> got;
    ASSERT_TRUE(stream->next(got, 100));
    ASSERT_EQ(got.size(), 3U);
    EXPECT_EQ(got[1][2], Vec3(0, 1, 0));
    EXPECT_EQ(got[2][1], Vec3(1, 0, 0));
}

TEST(TriangleStream, RefusesWhatIsBroken) {
    const Folder folder;
    std::vector<TriangleStream::Triangle> got;
    for (const auto& [text, wrong] : {std::pair{"v 0 0 0\nf 1 2 3\n", "uses vertex 2 of 1"}, {"v 0 x 0\n", "three numbers"}, {"v 0 0 0\nf 1 1\n", "fewer than three"}, {"v 0 0 0\nf 1 0 1\n", "uses vertex 0"}}) {
        const auto read = TriangleStream::open(folder.write("a.obj", text)).value()->next(got, 10);
        ASSERT_FALSE(read) << text;
        EXPECT_THAT(read.error().message, HasSubstr(wrong));
    }
    EXPECT_FALSE(TriangleStream::open(folder.write("a.stl", "short")));
    EXPECT_FALSE(TriangleStream::open(folder.write("b.stl", stl({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}) + "more")));
    EXPECT_FALSE(TriangleStream::open(folder.path / "none.stl"));
    EXPECT_FALSE(TriangleStream::open(folder.write("a.txt", "")));
}

// Invariant: a flat piece takes the field's value at each vertex; what has no area or is not finite is counted and left out.
TEST(ShadeStream, LightsAGradientAndLeavesOutWhatIsNotFinite) {
    const Folder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto file = folder.write("a.stl", stl({{Vec3(0, 0, 0.5F), Vec3(2, 0, 0.5F), Vec3(1, 1, 0.5F)}, {Vec3(nan, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(0, 1, 0)}}));
    const auto volume = gradient();
    const auto field = fieldOf(volume);
    std::vector<Rgb> got;
    const Progress progress;
    const auto counts = shadeStream(*TriangleStream::open(file).value(), field, nullptr, {}, [&](std::span<const Vec3>, std::span<const Rgb> lux) {
        got.assign(lux.begin(), lux.end());
        return Result<void>();
    }, progress).value();
    EXPECT_EQ(counts.triangles, 3U);
    EXPECT_EQ(counts.skipped, 2U);
    ASSERT_EQ(got.size(), 3U);
    EXPECT_NEAR(got[0].g, 100, 0.1F);
    EXPECT_NEAR(got[1].g, 300, 0.3F);
    EXPECT_NEAR(got[2].g, 200, 0.2F);
}

// Invariant: many blocks, one or all threads: the same bits, in the file's order.
// Bug: a chunk of 65,536 triangles that ends in a polygon of many corners was lit beyond the end of the list of blocks.
TEST(ShadeStream, APolygonMayCarryAChunkBeyondItsSize) {
    const Folder folder;
    constexpr int kCorners = 4000, kTriangles = 65'000;
    std::string text, face = "f";
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * kPiD * i / kCorners;
        text += fmt::format("v {:.9f} {:.9f} 0.5\n", 1 + 0.9 * std::cos(angle), 1 + 0.9 * std::sin(angle));
        face += fmt::format(" {}", i + 1);
    }
    for (int i = 0; i < kTriangles; ++i) text += "f 1 1001 2001\n";
    const auto file = folder.write("disc.obj", text + face + "\n");
    const auto volume = gradient();
    const auto field = fieldOf(volume);
    std::size_t got = 0;
    const auto counts = shadeStream(*TriangleStream::open(file).value(), field, nullptr, {}, [&](std::span<const Vec3>, std::span<const Rgb> lux) {
        got += lux.size();
        return Result<void>();
    }, Progress()).value();
    EXPECT_EQ(counts.triangles, static_cast<std::uint64_t>(kTriangles + kCorners - 2));
    EXPECT_EQ(got, 3 * (counts.triangles - counts.skipped));
}

TEST(ShadeStream, DoesNotDependOnTheNumberOfThreads) {
    const Folder folder;
    std::vector<TriangleStream::Triangle> many;
    for (int i = 0; i < 9000; ++i) {
        const float x = static_cast<float>(i % 190) * 0.01F, y = static_cast<float>(i / 190) * 0.02F;
        many.push_back({Vec3(x, y, 0.3F), Vec3(x + 0.01F, y, 0.3F), Vec3(x, y + 0.01F, 0.35F)});
    }
    const auto file = folder.write("a.stl", stl(many));
    const auto volume = gradient();
    const auto field = fieldOf(volume);
    const auto run = [&] {
        std::vector<Rgb> got;
        const Progress progress;
        EXPECT_TRUE(shadeStream(*TriangleStream::open(file).value(), field, nullptr, {}, [&](std::span<const Vec3>, std::span<const Rgb> lux) {
            got.insert(got.end(), lux.begin(), lux.end());
            return Result<void>();
        }, progress));
        return got;
    };
    const auto all = run();
    const ThreadLimit one(1);
    const auto alone = run();
    ASSERT_EQ(all.size(), 27000U);
    EXPECT_EQ(std::memcmp(all.data(), alone.data(), all.size() * sizeof(Rgb)), 0);
}

TEST(ShadedFile, HasTheSizeThatItsHeadSays) {
    const Folder folder;
    auto file = ShadedFile::create(folder.path / "a.ply", ".ply", {{1000, 0, 0}, {}, 500}).value();
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Rgb> lux{Rgb(100), Rgb(200), Rgb(std::numeric_limits<float>::quiet_NaN())};
    file.vertices(positions, lux);
    file.trianglesInOrder();
    ASSERT_TRUE(file.finish());
    std::ostringstream bytes;
    bytes << std::ifstream(folder.path / "a.ply", std::ios::binary).rdbuf();
    const auto text = bytes.str();
    EXPECT_THAT(text, HasSubstr("element vertex 3\n"));
    EXPECT_THAT(text, HasSubstr("element face 1\n"));
    const auto body = text.find("end_header\n") + 11;
    ASSERT_EQ(text.size() - body, 3 * 43U + 13U);
    double x = 0;
    std::memcpy(&x, text.data() + body + 43, 8);
    EXPECT_EQ(x, 1001);
    float y = 0;
    std::memcpy(&y, text.data() + body + 43 + 27, 4);
    EXPECT_FLOAT_EQ(y, 200);
}

}  // namespace
}  // namespace luxdeck::test

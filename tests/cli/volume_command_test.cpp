#include "engine/volume/volume_file.h"
#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <random>
#include <sstream>
#include <unistd.h>

/// `luxdeck volume`: what people do with it, what is refused, and what a kill at any moment leaves.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kSmall{"volume", "build", "project.toml", "-o", "v.vtu", "--grid", "3", "3", "3", "--quiet"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::vector<double> numbers(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> out;
    for (std::string word; in >> word;) out.push_back(std::strtod(word.c_str(), nullptr));
    return out;
}

TEST(VolumeCommand, BuildsAndAnswers) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run(with(kSmall, {"--bins", "5"})).exitStatus, 0);
    EXPECT_FALSE(scratch.has("v.vtu.part"));
    EXPECT_THAT(scratch.run({"volume", "info", "v.vtu"}).out, HasSubstr("3 x 3 x 3 in the first level"));
    const std::string lines = "2 2.5 0.8 0 0 1\n\n2 2.5 0.8 0 0 -1\nrubbish\n";
    const auto total = scratch.run({"volume", "query", "v.vtu", "--scene", "project.toml"}, lines);
    EXPECT_EQ(total.exitStatus, 3);
    EXPECT_THAT(total.err, HasSubstr("stdin:4"));
    const auto direct = scratch.run({"volume", "query", "v.vtu", "--scene", "project.toml", "--part", "direct"}, lines);
    const auto indirect = scratch.run({"volume", "query", "v.vtu", "--scene", "project.toml", "--part", "indirect"}, lines);
    const auto t = numbers(total.out), d = numbers(direct.out), i = numbers(indirect.out);
    ASSERT_EQ(t.size(), 12U);
    EXPECT_GT(t[3], 0);
    EXPECT_NEAR(d[3] + i[3], t[3], 2e-5 * t[3]);  // six digits each
    EXPECT_NEAR(d[7] + i[7], t[7], 2e-5 * t[7]);
    // Order 10^4 is a number, and radiance too.
    EXPECT_GT(numbers(scratch.run({"volume", "query", "v.vtu", "--moment", "10000"}, "2 2.5 0.8 0 0 1\n").out).at(3), 0);
    EXPECT_GE(numbers(scratch.run({"volume", "query", "v.vtu", "--moment", "0"}, "2 2.5 0.8 0 0 -1\n").out).at(3), 0);
}

TEST(VolumeCommand, ExportsTablesAndPanoramas) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run(with(kSmall, {"--bins", "15"})).exitStatus, 0);
    EXPECT_EQ(scratch.run({"volume", "export", "v.vtu", "-o", "v.csv"}).exitStatus, 0);
    EXPECT_THAT(scratch.read("v.csv"), HasSubstr("x_m,y_m,z_m,usable,ci95_lx,facing_+x"));
    EXPECT_EQ(scratch.run({"volume", "export", "v.vtu", "-o", "v.exr", "--at", "2", "2", "1", "--moment", "0", "--height", "64"}).exitStatus, 0);
    EXPECT_EQ(scratch.run({"volume", "export", "v.vtu", "-o", "v.exr"}).exitStatus, 3);  // of which point?
    // A panorama is what a volume can be built from again. In it the lamp fills a bin of 9.5 degrees: where vertices see it
    // at 60 degrees from the normal, half a bin is 14 % of the cosine, and of their part of the light.
    scratch.write("nodes.toml", "default = 1\n[[node]]\nposition = [2, 2, 1]\npicture = \"v.exr\"\n");
    ASSERT_EQ(scratch.run({"volume", "build", "--pictures", "nodes.toml", "-o", "p.vtu", "--bins", "15"}).exitStatus, 0);
    const auto from = numbers(scratch.run({"volume", "query", "v.vtu"}, "2 2 1 0 0 1\n").out), back = numbers(scratch.run({"volume", "query", "p.vtu"}, "2 2 1 0 0 1\n").out);
    EXPECT_NEAR(back.at(3), from.at(3), 0.1 * from.at(3));
}

TEST(VolumeCommand, RefusesAnotherStateOfTheScene) {
    const Scratch scratch;
    scratch.writeRoom();
    ASSERT_EQ(scratch.run(with(kSmall, {"--bins", "5"})).exitStatus, 0);
    auto project = scratch.read("project.toml");
    const auto at = project.find("position");
    ASSERT_NE(at, std::string::npos);
    const auto digit = project.find_first_of("0123456789", at);
    project[digit] = project[digit] == '1' ? '2' : '1';
    scratch.write("project.toml", project);
    const auto result = scratch.run({"volume", "query", "v.vtu", "--scene", "project.toml"}, "2 2 1 0 0 1\n");
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, HasSubstr("changed"));
    EXPECT_THAT(result.err, HasSubstr("v.vtu"));
}

TEST(VolumeCommand, RefusesWhatIsNoVolume) {
    const Scratch scratch;
    scratch.writeRoom();
    scratch.write("no.vtu", "<VTKFile/>");
    EXPECT_EQ(scratch.run({"volume", "info", "no.vtu"}).exitStatus, 3);
    EXPECT_EQ(scratch.run({"volume", "info", "none.vtu"}).exitStatus, 3);
    EXPECT_EQ(scratch.run({"volume", "build", "-o", "v.vtu"}).exitStatus, 2);
    EXPECT_EQ(scratch.run({"volume"}).exitStatus, 2);
    EXPECT_EQ(scratch.run({"volume", "build", "project.toml", "-o", "v.vtu", "--ignore", "nothing"}).exitStatus, 3);
    scratch.write("v.vtu.part", "somebody else's\n");
    const auto foreign = scratch.run(with(kSmall, {"--bins", "5"}));
    EXPECT_EQ(foreign.exitStatus, 3);
    EXPECT_THAT(foreign.err, HasSubstr("belongs to another build"));
    EXPECT_EQ(scratch.read("v.vtu.part"), "somebody else's\n");
}

// Killed with -9 at 100 random moments of one build, each session going on where the last one stopped: no file is ever
// corrupt, what was finished stays finished, and the volume is the one of an undisturbed build, bit for bit but for its time.
TEST(VolumeCommand, SurvivesAHundredKills) {
    const Scratch scratch;
    scratch.writeRoom();
    const auto build = with(kSmall, {"--bins", "5", "--samples", "64"});
    std::mt19937 random(11);
    std::uintmax_t kept = 0;
    for (int i = 0; i < 100; ++i) {
        Process process(scratch.command(build));
        ::usleep(static_cast<useconds_t>(std::uniform_int_distribution<>(0, 120)(random)) * 1000);
        process.signal(SIGKILL);
        (void)process.wait();
        const bool readable = !scratch.has("v.vtu") || readVolume(scratch.path("v.vtu")).has_value();
        ASSERT_TRUE(readable) << i;
        if (!scratch.has("v.vtu.part")) {
            kept = 0;  // whole: the next one begins anew
            continue;
        }
        const auto size = std::filesystem::file_size(scratch.path("v.vtu.part"));
        // A cut-off record may go; it is less than 4 kB here.
        EXPECT_GE(size + 4096, kept) << i;
        kept = size;
    }
    ASSERT_EQ(scratch.run(build).exitStatus, 0);
    const auto survived = readVolume(scratch.path("v.vtu"));
    std::filesystem::remove(scratch.path("v.vtu"));
    ASSERT_EQ(scratch.run(build).exitStatus, 0);
    const auto undisturbed = readVolume(scratch.path("v.vtu"));
    ASSERT_TRUE(survived && undisturbed);
    EXPECT_EQ(survived->indirect, undisturbed->indirect);
    EXPECT_EQ(survived->direct, undisturbed->direct);
}

}  // namespace
}  // namespace luxdeck::test

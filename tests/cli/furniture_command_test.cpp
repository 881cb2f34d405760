#include "tests/cli/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// `luxdeck furniture` and `luxdeck shade`: warnings, what is refused and how it says what to do.
namespace luxdeck::test {
namespace {

using ::testing::HasSubstr;

/// The room with a board of 1 x 0.5 m at 0.7 m, which may be moved, and the volume of the room without it.
struct FurnishedRoom {
    Scratch scratch;

    FurnishedRoom() {
        scratch.writeRoom();
        scratch.write("board.obj", "o board\nv 1.5 2.25 0.7\nv 2.5 2.25 0.7\nv 2.5 2.75 0.7\nv 1.5 2.75 0.7\nf 1 2 3 4\n");
        scratch.write("project.toml", Scratch::roomProject({}, "[[geometry]]\nfile = \"board.obj\"\nunit = \"m\"\n[[furniture]]\nobject = \"board\"\n"));
        const auto built = scratch.run({"volume", "build", "project.toml", "--without", "board", "-o", "v.vtu", "--grid", "4", "4", "4", "--bins", "7", "--quiet"});
        EXPECT_EQ(built.exitStatus, 0) << built.err;
    }
    [[nodiscard]] ProcessResult furniture(std::vector<std::string> more) const {
        std::vector<std::string> all{"furniture", "project.toml", "--volume", "v.vtu", "--object", "board", "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return scratch.run(all);
    }
};
const FurnishedRoom& furnishedRoom() {
    static const FurnishedRoom room;
    return room;
}

TEST(FurnitureCommand, ExitsByItsVerdict) {
    const auto& room = furnishedRoom();
    const auto met = room.furniture({"--required", "20"});
    EXPECT_EQ(met.exitStatus, 0) << met.err;
    EXPECT_THAT(met.out, HasSubstr("  met\n"));
    const auto under = room.furniture({"--required", "5000"});
    EXPECT_EQ(under.exitStatus, 1);
    EXPECT_THAT(under.out, HasSubstr("too little light"));
    const auto over = room.furniture({"--limit", "5"});
    EXPECT_EQ(over.exitStatus, 1);
    EXPECT_THAT(over.out, HasSubstr("too much light"));
}

TEST(FurnitureCommand, MovesAndWrites) {
    const auto& room = furnishedRoom();
    const auto moved = room.furniture({"--move", "-1", "-1.5", "0", "--rotate", "90", "-o", "board.csv"});
    EXPECT_EQ(moved.exitStatus, 0) << moved.err;
    EXPECT_THAT(moved.out, HasSubstr("board at 1.00 1.00 0.70, turned 90°"));
    EXPECT_THAT(room.scratch.read("board.csv"), testing::StartsWith("x,y,z,lux,lux_r,lux_g,lux_b\n"));
}

TEST(FurnitureCommand, RefusesAndSaysWhatToDo) {
    const auto& room = furnishedRoom();
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"furniture", "project.toml", "--volume", "v.vtu", "--object", "desk"}, "movable are \"board\""},
        {{"furniture", "project.toml", "--volume", "v.vtu", "--object", "room"}, "is not movable"},
        {{"furniture", "project.toml", "--volume", "board.obj", "--object", "board"}, "board.obj"},
        {{"furniture", "project.toml", "--volume", "v.vtu", "--model", "none.obj"}, "none.obj"},
        {{"furniture", "project.toml", "--volume", "v.vtu", "--model", "board.obj"}, "board"},  // the volume is not of the scene as it is
        {{"shade", "project.toml", "--volume", "v.vtu", "--model", "board.obj", "-o", "s.ply"}, "board"},
        {{"volume", "build", "project.toml", "--without", "desk", "-o", "w.vtu"}, "no object \"desk\""},
    };
    for (const auto& [arguments, says] : cases) {
        const auto result = room.scratch.run(arguments);
        EXPECT_EQ(result.exitStatus, 3) << arguments[0] << " " << says;
        EXPECT_THAT(result.err, HasSubstr(says));
    }
    EXPECT_EQ(room.scratch.run({"furniture", "project.toml", "--volume", "v.vtu"}).exitStatus, 2);
    EXPECT_EQ(room.furniture({"-o", "f.png"}).exitStatus, 2);
}

// Invariant: a volume of the scene with the object in it is refused, with the command that makes the right one.
TEST(FurnitureCommand, WantsTheVolumeWithoutTheObject) {
    const auto& room = furnishedRoom();
    ASSERT_EQ(room.scratch.run({"volume", "build", "project.toml", "-o", "with.vtu", "--grid", "2", "2", "2", "--bins", "3", "--quiet"}).exitStatus, 0);
    const auto result = room.scratch.run({"furniture", "project.toml", "--volume", "with.vtu", "--object", "board"});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, HasSubstr("--without \"board\""));
    const auto shaded = room.scratch.run({"shade", "project.toml", "--volume", "with.vtu", "--model", "board.obj", "-o", "s.ply"});
    EXPECT_EQ(shaded.exitStatus, 0) << shaded.err;
    EXPECT_THAT(shaded.out, HasSubstr("2 triangles lit"));
}

}  // namespace
}  // namespace luxdeck::test

// What designers change, on the sample office: the new project has it, the text keeps its comments, undo takes it back.
#include "gui/session/edits.h"

#include "analysis/furniture/movable_object.h"
#include "engine/core/file.h"
#include "engine/io/project_edit.h"
#include "tests/gui/open_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <cmath>
#include <string>

namespace luxdeck::gui {
namespace {

using test::OpenSession;
using test::OwnFolder;
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::size_t lines(const std::string& text, const std::string& holding) {
    std::size_t count = 0;
    for (auto at = text.find(holding); at != std::string::npos; at = text.find(holding, at + 1)) ++count;
    return count;
}

class Edits : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(open_.open(folder_.sample("office"))) << open_.errors(); }

    [[nodiscard]] const Project& project() const { return open_.session.project()->project; }
    [[nodiscard]] const std::string& text() const { return open_.session.document().text(); }
    /// Does an edit and waits for its project; what went wrong.
    std::string done(const edits::Edit& edit) {
        if (const auto accepted = open_.session.edit("Edit", edit); !accepted) return accepted.error().text();
        EXPECT_TRUE(open_.untilIdle());
        return open_.errors();
    }
    [[nodiscard]] std::size_t luminaire(const std::string& name) const {
        const auto& all = project().scene.luminaires;
        return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), [&](const Luminaire& l) { return l.name == name; }) - all.begin());
    }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> out;
        for (const auto& l : project().scene.luminaires) out.push_back(l.name);
        return out;
    }
    /// Corners of an object's bounds [m].
    [[nodiscard]] Box3d bounds(const std::string& name) const {
        Box3d box;
        for (const auto& mesh : project().scene.meshes)
            if (project().scene.objects[mesh.object].name == name)
                for (const auto& p : mesh.positions) box.extendBy(project().scene.toUser(p));
        return box;
    }

    OwnFolder folder_;
    OpenSession open_;
};

TEST_F(Edits, OneLuminaireOfRowsIsDimmedAndAllKeepTheirNames) {
    const auto before = names();
    const auto b3 = luminaire("B3");
    ASSERT_LT(b3, before.size());
    const auto was = project().scene.luminaires;
    edits::LuminaireChange change;
    change.dimming = 0.25;
    ASSERT_THAT(done(edits::changeLuminaires(open_.session.project(), {b3}, change)), IsEmpty());
    EXPECT_EQ(names(), before);
    for (std::size_t i = 0; i < was.size(); ++i) {
        EXPECT_EQ(project().scene.luminaires[i].dimming, i == b3 ? 0.25 : 1.0) << before[i];
        EXPECT_LT((project().scene.luminaires[i].position - was[i].position).length(), 1e-5F) << before[i];
    }
    EXPECT_THAT(text(), HasSubstr("over the benches, their length along y"));
    EXPECT_THAT(text(), HasSubstr("[[luminaire]] # lounge\ntype = \"C\"\nposition = [12.3, 1.5, 2.891]\narray = { count = [2, 3], spacing = [1.2, 1.2] }\n"));
    open_.session.undo();
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(project().scene.luminaires[b3].dimming, 1.0);
    EXPECT_FALSE(open_.session.document().modified());
}

TEST_F(Edits, DimmingIsFollowedWithoutANewSolve) {
    SolveSettings settings;
    settings.byLuminaire = true;
    settings.samples = 64;
    open_.session.solving.start(settings);
    ASSERT_TRUE(open_.untilIdle());
    ASSERT_TRUE(open_.session.solving.current());
    const double full = open_.session.solving.result()->grids[0].mean.interval.value;
    std::vector<std::size_t> all(project().scene.luminaires.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    edits::LuminaireChange half;
    half.dimming = 0.5;
    ASSERT_THAT(done(edits::changeLuminaires(open_.session.project(), all, half)), IsEmpty());
    ASSERT_TRUE(open_.session.solving.current());
    EXPECT_NEAR(open_.session.solving.result()->grids[0].mean.interval.value, full / 2, 1e-3 * full);
    // One of a row: the row becomes single luminaires, and the layers still know each.
    ASSERT_THAT(done(edits::switchLuminaires(open_.session.project(), {luminaire("B1")}, false)), IsEmpty());
    EXPECT_TRUE(open_.session.solving.current());
    EXPECT_LT(open_.session.solving.result()->grids[0].mean.interval.value, full / 2);
}

// Rows with a name are numbered after it: what is left of them keeps the numbers.
TEST_F(Edits, RowsWithANameKeepTheirNumbers) {
    const auto d = luminaire("D1");
    ASSERT_THAT(done([](const std::string& text) -> Result<std::string> {
        auto edit = ProjectEdit::of(text);
        edit->set({"luminaire", 8}, "name", "wall");
        return edit->text();
    }), IsEmpty());
    ASSERT_EQ(luminaire("wall-1"), d);
    ASSERT_THAT(done(edits::removeLuminaires(open_.session.project(), {luminaire("wall-2")})), IsEmpty());
    EXPECT_EQ(luminaire("wall-1"), d);
    EXPECT_EQ(luminaire("wall-3"), d + 1);
    EXPECT_EQ(luminaire("wall-2"), names().size());
}

TEST_F(Edits, AllOfATypeAreDimmedWithoutTakingRowsApart) {
    const auto type = project().scene.luminaires[luminaire("C1")].type;
    const auto all = edits::luminairesOfType(project(), type);
    ASSERT_EQ(all.size(), 12U);
    ASSERT_THAT(done(edits::switchLuminaires(open_.session.project(), all, false)), IsEmpty());
    for (const auto i : all) EXPECT_EQ(project().scene.luminaires[i].dimming, 0);
    EXPECT_EQ(lines(text(), "[[luminaire]]"), 10U);
    EXPECT_EQ(lines(text(), "dimming = 0\n"), 2U);
}

TEST_F(Edits, LuminairesAreMovedAimedAndTurned) {
    edits::LuminaireChange change;
    change.position = Vec3d(5, 4, 2.5);
    change.aim = Vec3d(1, 0, -1);
    change.rotationDeg = 30;
    ASSERT_THAT(done(edits::changeLuminaires(open_.session.project(), {luminaire("A2")}, change)), IsEmpty());
    const auto& moved = project().scene.luminaires[luminaire("A2")];
    EXPECT_LT((project().scene.toUser(moved.position) - Vec3d(5, 4, 2.5)).length(), 1e-5);
    EXPECT_NEAR(-moved.frame.normal.x, std::sqrt(0.5), 1e-5);
    const auto placed = edits::placedLuminaire(project(), text(), luminaire("A2"));
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->position, Vec3d(5, 4, 2.5));
    EXPECT_EQ(placed->rotationDeg, 30);
    EXPECT_FALSE(placed->inArray);
    edits::LuminaireChange shift;
    shift.moveBy = Vec3d(0.1, 0, -0.2);
    const auto washers = edits::luminairesOfType(project(), project().scene.luminaires[luminaire("D1")].type);
    ASSERT_THAT(done(edits::changeLuminaires(open_.session.project(), washers, shift)), IsEmpty());
    EXPECT_THAT(text(), HasSubstr("position = [3.4, 8.1, 2.691]\narray = { count = [3, 1]"));
}

/// A luminaire that the text aims by LM-72's angles shows where it points, and is aimed in the window's own way.
TEST_F(Edits, LuminairesAimedByLm72AreTurned) {
    ASSERT_THAT(done([](const std::string& text) -> Result<std::string> {
        return text + "\n[[luminaire]]\ntype = \"A\"\nname = \"flood\"\nposition = [1, 1, 2]\norient = 90\ntilt = 90\n";
    }), IsEmpty());
    const auto placed = edits::placedLuminaire(project(), text(), luminaire("flood"));
    ASSERT_TRUE(placed);
    EXPECT_NEAR(placed->aim.y, 1, 1e-6);
    EXPECT_NEAR(placed->rotationDeg, 90, 1e-4);  // C0 up, where the smallest turn has it east; floats in degrees
    edits::LuminaireChange change;
    change.aim = Vec3d(1, 0, 0);
    ASSERT_THAT(done(edits::changeLuminaires(open_.session.project(), {luminaire("flood")}, change)), IsEmpty());
    EXPECT_NEAR(-project().scene.luminaires[luminaire("flood")].frame.normal.x, 1, 1e-6);
    EXPECT_THAT(text(), testing::Not(HasSubstr("orient")));
}

TEST_F(Edits, LuminairesAreAddedDoubledAndRemoved) {
    const auto before = names();
    ASSERT_THAT(done(edits::addLuminaire("C", Vec3d(1, 1, 2.8))), IsEmpty());
    EXPECT_EQ(names().size(), before.size() + 1);
    EXPECT_EQ(names().back(), "C13");
    ASSERT_THAT(done(edits::duplicateLuminaire(open_.session.project(), luminaire("B2"), Vec3d(0, 0.5, 0))), IsEmpty());
    EXPECT_EQ(names().back(), "B9");
    EXPECT_EQ(names().size(), before.size() + 2);
    const auto third = project().scene.luminaires[luminaire("A3")].position;
    const auto panels = edits::luminairesOfType(project(), project().scene.luminaires[luminaire("A1")].type).size();
    ASSERT_THAT(done(edits::removeLuminaires(open_.session.project(), {luminaire("A4"), luminaire("A1"), luminaire("A2")})), IsEmpty());
    EXPECT_EQ(names().size(), before.size() - 1);
    // Numbered anew: what was A3 is the first.
    EXPECT_EQ(edits::luminairesOfType(project(), project().scene.luminaires[luminaire("A1")].type).size(), panels - 3);
    EXPECT_EQ(project().scene.luminaires[luminaire("A1")].position, third);
}

TEST_F(Edits, AnImpossibleDimmingIsToldWithItsLineAndTakenBack) {
    const auto before = text();
    edits::LuminaireChange change;
    change.dimming = 1.5;
    EXPECT_THAT(done(edits::changeLuminaires(open_.session.project(), {luminaire("A1")}, change)), testing::ContainsRegex("project.toml:[0-9]+: .*dimming is 1.5, expected 0 .. 1"));
    EXPECT_EQ(text(), before);
}

TEST_F(Edits, APhotometricFileFromElsewhereIsCopiedAndExchanged) {
    const auto elsewhere = folder_.path() / "downloads";
    fs::create_directories(elsewhere);
    fs::copy_file(folder_.path() / "office/luminaires/c_downlight.ies", elsewhere / "a_panel.ies");  // another's name
    const auto file = folder_.path() / "office/project.toml";
    const auto placed = edits::photometryForProject(file, elsewhere / "a_panel.ies");
    ASSERT_TRUE(placed) << placed.error().text();
    EXPECT_TRUE(placed->copied);
    EXPECT_EQ(placed->shown, "luminaires/a_panel 2.ies");
    EXPECT_EQ(edits::photometryForProject(file, elsewhere / "a_panel.ies")->shown, "luminaires/a_panel 2.ies") << "the same again";
    const auto own = edits::photometryForProject(file, folder_.path() / "office/luminaires/b_pendant.ldt");
    ASSERT_TRUE(own);
    EXPECT_FALSE(own->copied);
    EXPECT_EQ(own->shown, "luminaires/b_pendant.ldt");
    ASSERT_THAT(done(edits::exchangePhotometry("A", placed->shown)), IsEmpty());
    const auto& types = project().scene.luminaireTypes;
    const auto type = [&](const std::string& id) { return *std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.id == id; }); };
    EXPECT_EQ(type("A").photometry.fileHash, type("C").photometry.fileHash);
    ASSERT_THAT(done(edits::addLuminaireType(own->shown, "Another")), IsEmpty());
    EXPECT_EQ(types.size(), 4U);
    EXPECT_EQ(project().scene.luminaireTypes.back().id, "E");
}

TEST_F(Edits, ABrokenPhotometricFileIsRefusedAndNothingIsLost) {
    ASSERT_TRUE(writeFileAtomically(folder_.path() / "office/luminaires/broken.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 zwei\n"));
    const auto before = text();
    EXPECT_THAT(done(edits::exchangePhotometry("A", "luminaires/broken.ies")), HasSubstr("broken.ies:3"));
    EXPECT_EQ(text(), before);
    EXPECT_EQ(project().scene.luminaires.size(), names().size());
}

TEST_F(Edits, FurnitureIsMovedAsLiveFurnitureShowsIt) {
    const auto before = open_.session.project();
    const auto object = makeMovableObject(before->project.scene, "Desk 03");
    ASSERT_TRUE(object) << object.error().text();
    const Pose first{{1.5, -0.25, 0}, 30}, second{{-0.5, 0.75, 0}, 75};
    ASSERT_THAT(done(edits::moveObject(before, "Desk 03", first)), IsEmpty());
    EXPECT_THAT(text(), HasSubstr("[[furniture]]\nobject = \"Desk 03\"\nmove = [1.5, -0.25, 0]\nturn_deg = 30\n"));

    const auto expectSame = [&](const Scene& moved) {
        Box3d live;
        std::uint32_t last = static_cast<std::uint32_t>(moved.objects.size()) - 1;
        for (const auto& mesh : moved.meshes)
            if (mesh.object == last)
                for (const auto& p : mesh.positions) live.extendBy(moved.toUser(p));
        // The text rounds to the micrometre.
        EXPECT_LT((bounds("Desk 03").min - live.min).length(), 1e-5);
        EXPECT_LT((bounds("Desk 03").max - live.max).length(), 1e-5);
    };
    expectSame(withObjectAt(*withoutObject(before->project.scene, "Desk 03"), before->project.scene, "Desk 03", *object, first));

    // A second time: about the pivot of what is seen, whose bounds are others now that it is askew.
    const auto between = open_.session.project();
    const auto again = makeMovableObject(between->project.scene, "Desk 03");
    ASSERT_TRUE(again);
    ASSERT_THAT(done(edits::moveObject(between, "Desk 03", second)), IsEmpty());
    EXPECT_EQ(lines(text(), "object = \"Desk 03\""), 1U);
    expectSame(withObjectAt(*withoutObject(between->project.scene, "Desk 03"), between->project.scene, "Desk 03", *again, second));
    EXPECT_NE(project().scene.hash, before->project.scene.hash);
    open_.session.undo();
    ASSERT_TRUE(open_.untilIdle());
    open_.session.undo();
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(project().scene.hash, before->project.scene.hash);
}

TEST_F(Edits, FurnitureOfAFileOfItsOwnIsMovedToo) {
    ASSERT_TRUE(writeFileAtomically(folder_.path() / "office/box.obj", "o b\nv 0 0 0\nv 2 0 0\nv 2 1 0.5\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"));
    ASSERT_THAT(done(edits::addFurniture("box.obj", {"m", ""}, Vec3d(6, 5, 0))), IsEmpty());
    EXPECT_LT((bounds("box 1").max - Vec3d(8, 6, 0.5)).length(), 1e-5);
    ASSERT_THAT(done(edits::moveObject(open_.session.project(), "box 1", {{1, 0, 0}, 90})), IsEmpty());
    // 2 x 1 m about (7, 5.5), turned to 1 x 2 m about (8, 5.5).
    EXPECT_LT((bounds("box 1").min - Vec3d(7.5, 4.5, 0)).length(), 1e-5);
    EXPECT_LT((bounds("box 1").max - Vec3d(8.5, 6.5, 0.5)).length(), 1e-5);
    ASSERT_THAT(done(edits::setMovable(open_.session.project(), "box 1", false)), IsEmpty());
    EXPECT_FALSE(project().scene.objects.back().movable);
}

TEST_F(Edits, MovingADeskChangesTheLightOnItsTaskArea) {
    SolveSettings settings;
    settings.samples = 64;
    const auto meanOf = [&](const std::string& grid) {
        open_.session.solving.start(settings);
        EXPECT_TRUE(open_.untilIdle());
        for (const auto& g : open_.session.solving.result()->grids)
            if (g.name == grid) return g.mean.interval.value;
        return -1.0;
    };
    const double before = meanOf("Meeting table");
    ASSERT_GT(before, 0);
    // The table's top 0.4 m above the points that are measured: they are in its shade.
    ASSERT_THAT(done(edits::moveObject(open_.session.project(), "Meeting table", {{0, 0, 0.4}, 0})), IsEmpty());
    EXPECT_FALSE(open_.session.solving.current());
    EXPECT_LT(meanOf("Meeting table"), 0.5 * before);
}

TEST_F(Edits, GridsViewsAndWords) {
    const auto grids = project().grids.size(), views = project().views.size();
    edits::GridChange grid;
    grid.name = "Reception";
    grid.origin = Vec3d(1, 2, 0.75), grid.u = Vec3d(2, 0, 0), grid.v = Vec3d(0, 1, 0), grid.spacingM = 0.25, grid.requirement = "meeting";
    ASSERT_THAT(done(edits::addGrid(grid)), IsEmpty());
    ASSERT_EQ(project().grids.size(), grids + 1);
    EXPECT_EQ(project().grids.back().name, "Reception");
    EXPECT_EQ(project().grids.back().requirements.size(), 1U);
    EXPECT_EQ(edits::requirementId(text(), grids), "meeting");
    EXPECT_THAT(edits::requirementIds(text()), testing::Contains("office-task"));
    edits::GridChange change;
    change.counts = std::array{4, 3}, change.requirement = "", change.name = "Desk at the door";
    ASSERT_THAT(done(edits::changeGrid(grids, change)), IsEmpty());
    EXPECT_EQ(project().grids.back().counts, (std::array{4, 3}));
    EXPECT_FALSE(project().grids.back().spacingM);
    EXPECT_TRUE(project().grids.back().requirements.empty());
    ASSERT_THAT(done(edits::removeGrid(grids)), IsEmpty());
    EXPECT_EQ(project().grids.size(), grids);

    auto view = project().views[0];
    view.name = "From \"here\"";
    view.position += Vec3d(0, 0, 0.5);
    ASSERT_THAT(done(edits::addView(open_.session.project(), view)), IsEmpty());
    ASSERT_EQ(project().views.size(), views + 1);
    EXPECT_EQ(project().views.back().name, "From \"here\"");
    EXPECT_LT((project().views.back().direction - view.direction).length(), 1e-5);
    ASSERT_THAT(done(edits::changeView(1, view)), testing::HasSubstr("is taken"));
    ASSERT_THAT(open_.session.document().canUndo(), true);
    EXPECT_TRUE(open_.session.edit("Rename", edits::renameView(views, "there")));
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(project().views.back().name, "there");
    EXPECT_TRUE(open_.session.edit("Remove", edits::removeView(views)));
    EXPECT_TRUE(open_.session.edit("Client", edits::setInfo("client", "Müller & Co")));
    EXPECT_TRUE(open_.session.edit("Place", edits::setInfo("location", "")));
    ASSERT_TRUE(open_.untilIdle());
    EXPECT_EQ(project().views.size(), views);
    EXPECT_EQ(project().info.client, "Müller & Co");
    EXPECT_THAT(project().info.location, IsEmpty());
    EXPECT_THAT(text(), HasSubstr("# Metres, z up. The origin is"));
}

// The reader writes nothing of a model's cameras: the first view that is added must not make them vanish.
TEST(EditsOfCameras, StayWhenTheFirstViewIsAdded) {
    const OwnFolder folder;
    fs::copy_file(fs::path(LUXDECK_SOURCE_DIR) / "projects/office/office.glb", folder.path() / "office.glb");
    ASSERT_TRUE(writeFileAtomically(folder.path() / "project.toml", "schema = \"luxdeck-project/1\"\n[[geometry]]\nfile = \"office.glb\"\n"));
    OpenSession open;
    ASSERT_TRUE(open.open(folder.path() / "project.toml")) << open.errors();
    const auto cameras = open.session.project()->project.views.size();
    View view;
    view.name = "mine";
    ASSERT_TRUE(open.session.edit("Add view", edits::addView(open.session.project(), view)));
    ASSERT_TRUE(open.untilIdle());
    EXPECT_THAT(open.errors(), IsEmpty());
    EXPECT_EQ(open.session.project()->project.views.size(), cameras + 1);
}

// ---- saving where it cannot be ----

TEST_F(Edits, AFullDiskLosesNothing) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    ASSERT_THAT(done(edits::setInfo("client", "Somebody")), IsEmpty());
    const auto file = open_.session.document().file();
    const auto saved = open_.session.saveAs("/dev/full");
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().text(), HasSubstr("/dev/full"));
    EXPECT_TRUE(open_.session.document().modified());
    EXPECT_EQ(open_.session.document().file(), file);
    EXPECT_TRUE(open_.session.save());
    EXPECT_THAT(*readFile(file), HasSubstr("Somebody"));
}

TEST_F(Edits, AFolderThatIsGoneLosesNothing) {
    ASSERT_THAT(done(edits::setInfo("client", "Somebody")), IsEmpty());
    const auto folder = folder_.path() / "office", away = folder_.path() / "away";
    fs::rename(folder, away);
    const auto saved = open_.session.save();
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().text(), HasSubstr("office"));
    EXPECT_TRUE(open_.session.document().modified());
    open_.session.autosave();
    open_.session.autosave();
    EXPECT_EQ(lines(open_.errors(), "autosave"), 1U) << "told once: " << open_.errors();
    fs::rename(away, folder);
    EXPECT_TRUE(open_.session.save());
    EXPECT_FALSE(open_.session.document().modified());
}

// /proc: a folder in which not even root may make a file.
TEST_F(Edits, AFolderWithoutRightsLosesNothing) {
    if (!fs::exists("/proc/self")) GTEST_SKIP() << "no /proc";
    ASSERT_THAT(done(edits::setInfo("client", "Somebody")), IsEmpty());
    const auto file = open_.session.document().file();
    const auto saved = open_.session.saveAs("/proc/project.toml");
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().text(), HasSubstr("/proc/project.toml"));
    EXPECT_TRUE(open_.session.document().modified());
    EXPECT_EQ(open_.session.document().file(), file);
}

}  // namespace
}  // namespace luxdeck::gui

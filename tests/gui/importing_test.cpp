// What files are that are dropped on the window.
#include "gui/session/importing.h"

#include "engine/core/file.h"
#include "tests/gui/open_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace luxdeck::gui {
namespace {

using test::OpenSession;
using test::OwnFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

TEST(Importing, TellsWhatFilesAreAndChangesNothing) {
    const OwnFolder folder;
    OpenSession open;
    ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors();
    const auto text = open.session.document().text();
    ASSERT_TRUE(writeFileAtomically(folder.path() / "box.OBJ", "o b\nv 0 0 0\nv 200 0 0\nv 200 100 50\nf 1 2 3\n"));
    auto& importing = open.session.importing;
    importing.look({folder.path() / "office/luminaires/b_pendant.ldt", folder.path() / "box.OBJ", folder.path() / "office/office.glb", folder.path() / "office/project.toml"});
    EXPECT_TRUE(importing.looking());
    ASSERT_TRUE(open.untilIdle());
    const auto& found = importing.found();
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].kind, ImportKind::Photometry);
    EXPECT_THAT(found[0].what, HasSubstr("EULUMDAT"));
    EXPECT_THAT(found[0].facts, Contains(HasSubstr("lm/W")));
    ASSERT_NE(found[0].photometry, nullptr);
    EXPECT_EQ(found[0].photometry->facts.lumens, measure(found[0].photometry->photometry).lumens);
    EXPECT_EQ(found[1].kind, ImportKind::Geometry);
    EXPECT_TRUE(found[1].needsUnit);
    EXPECT_EQ(found[1].triangles, 1U);
    EXPECT_THAT(found[1].facts, Contains("200 x 100 x 50 in its own unit, which it does not say"));
    EXPECT_EQ(found[2].triangles, open.session.project()->project.scene.triangleCount());
    EXPECT_FALSE(found[2].needsUnit);
    EXPECT_EQ(found[3].kind, ImportKind::Project);
    EXPECT_THAT(open.errors(), IsEmpty());
    EXPECT_EQ(open.session.document().text(), text);
    importing.clear();
    EXPECT_TRUE(importing.found().empty());
}

TEST(Importing, ABrokenFileSaysWhereAndWhat) {
    const OwnFolder folder;
    OpenSession open;
    const auto file = folder.path() / "broken.ies";
    ASSERT_TRUE(writeFileAtomically(file, "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 drei 1 1 2 0 0 0\n1 1 10\n"));
    open.session.importing.look({file, folder.path() / "picture.bmp", folder.path() / "gone.glb"});
    ASSERT_TRUE(open.untilIdle());
    const auto& found = open.session.importing.found();
    ASSERT_EQ(found.size(), 3U);
    ASSERT_TRUE(found[0].refused);
    EXPECT_THAT(found[0].refused->text(), HasSubstr("broken.ies:3"));
    EXPECT_THAT(found[0].refused->text(), HasSubstr("drei"));
    ASSERT_TRUE(found[1].refused);
    EXPECT_THAT(found[1].refused->text(), HasSubstr("expected a photometric file (.ies, .ldt)"));
    ASSERT_TRUE(found[2].refused);
    EXPECT_THAT(open.errors(), HasSubstr("gone.glb"));
    EXPECT_EQ(open.session.project(), nullptr);
}

}  // namespace
}  // namespace luxdeck::gui

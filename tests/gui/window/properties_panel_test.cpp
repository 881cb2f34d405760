// What is selected is shown and changed by typing.
#include "gui/panels/properties_panel.h"
#include "tests/gui/window/open_window.h"
#include "tests/gui/window/panel_support.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::found;
using testing::HasSubstr;

class PropertiesPanelTest : public testing::Test {
protected:
    void SetUp() override {
        applyTheme(*qApp, Theme::Light);
        ASSERT_TRUE(open_.open(folder_.sample("office"))) << open_.errors();
        panel_ = std::make_unique<PropertiesPanel>(open_.session);
        panel_->resize(360, 780);
        panel_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel_.get()));
    }
    void select(Thing thing, std::size_t index) {
        open_.session.select({thing, index});
        QTest::qWait(20);
    }
    /// Waits for the project of an edit, and for the panel that shows it.
    void settle() {
        ASSERT_TRUE(open_.untilIdle());
        QTest::qWait(20);
    }
    void type(const char* field, const QString& text) {
        auto* edit = found<QWidget>(*panel_, field);
        edit->setFocus();
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
        settle();
    }
    [[nodiscard]] const Project& project() const { return open_.session.project()->project; }
    void picture(const char* name) {
        if (const char* to = std::getenv("LUXDECK_PICTURES")) panel_->grab().save(QString::fromLatin1(to) + "/" + name + ".png");
    }

    test::OwnFolder folder_;
    test::OpenSession open_;
    std::unique_ptr<PropertiesPanel> panel_;
};

TEST_F(PropertiesPanelTest, ALuminaireIsMovedAndDimmedByTyping) {
    select(Thing::Luminaire, 0);
    picture("properties_luminaire");
    type("luminairePositionX", "1.25");
    EXPECT_NEAR(project().scene.toUser(project().scene.luminaires[0].position).x, 1.25, 1e-5);
    EXPECT_EQ(open_.session.document().undoName(), "Move " + project().scene.luminaires[0].name);
    EXPECT_EQ(found<QDoubleSpinBox>(*panel_, "luminairePositionX")->value(), 1.25);
    QTest::mouseClick(found<QCheckBox>(*panel_, "luminaireOn"), Qt::LeftButton, {}, {8, found<QCheckBox>(*panel_, "luminaireOn")->height() / 2});
    settle();
    EXPECT_EQ(project().scene.luminaires[0].dimming, 0);
    EXPECT_FALSE(found<QCheckBox>(*panel_, "luminaireOn")->isChecked());
    open_.session.undo();
    settle();
    EXPECT_TRUE(found<QCheckBox>(*panel_, "luminaireOn")->isChecked());
}

TEST_F(PropertiesPanelTest, ARefusedNameIsSaidAndTheOldOneShown) {
    select(Thing::Grid, 1);
    picture("properties_grid");
    const auto before = project().grids[1].name;
    type("gridName", QString::fromStdString(project().grids[0].name));
    const auto* message = found<QLabel>(*panel_, "propertyMessage");
    EXPECT_TRUE(message->isVisible());
    EXPECT_THAT(message->text().toStdString(), HasSubstr("is taken"));
    EXPECT_EQ(found<QLineEdit>(*panel_, "gridName")->text().toStdString(), before);
    type("gridName", "Reception");
    EXPECT_FALSE(found<QLabel>(*panel_, "propertyMessage")->isVisible());
    EXPECT_EQ(project().grids[1].name, "Reception");
}

TEST_F(PropertiesPanelTest, EachKindHasItsFields) {
    select(Thing::LuminaireType, 1);
    EXPECT_TRUE(found<QWidget>(*panel_, "polarCurve")->isVisible());
    picture("properties_type");
    panel_->exchange(1, (folder_.path() / "office/luminaires/a_panel.ies").string());
    settle();
    EXPECT_EQ(project().scene.luminaireTypes[1].photometry.fileHash, project().scene.luminaireTypes[0].photometry.fileHash);
    select(Thing::View, 0);
    type("viewFov", "60");
    EXPECT_EQ(project().views[0].verticalFovDeg, 60);
    for (std::size_t i = 0; i < project().scene.objects.size(); ++i)
        if (project().scene.objects[i].movable) {
            select(Thing::Object, i);
            break;
        }
    EXPECT_TRUE(found<QWidget>(*panel_, "moveWithLight")->isVisible());
    const auto hash = project().scene.hash;
    type("objectTurn", "90");
    EXPECT_NE(project().scene.hash, hash);
    picture("properties_object");
    select(Thing::Material, 0);
    select(Thing::Project, 0);
    type("projectClient", "Somebody");
    EXPECT_EQ(project().info.client, "Somebody");
    picture("properties_project");
    open_.session.close();
    QTest::qWait(20);
    EXPECT_THAT(found<QLabel>(*panel_, "propertyTitle")->text().toStdString(), HasSubstr("Nothing is open"));
}

}  // namespace
}  // namespace luxdeck::gui

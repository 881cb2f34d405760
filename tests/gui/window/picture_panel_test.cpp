// The picture panel under real clicks.
#include "gui/panels/picture_panel.h"
#include "gui/panels/picture_view.h"
#include "tests/gui/open_session.h"
#include "tests/gui/window/panel_support.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::click;
using test::found;
using test::OpenSession;
using test::OwnFolder;

class PicturePanelTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors();
        panel.resize(1280, 800);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
        found<QSpinBox>(panel, "renderWidth")->setValue(300);
        found<QSpinBox>(panel, "renderHeight")->setValue(200);
        found<QDoubleSpinBox>(panel, "renderTarget")->setValue(60);
    }
    PictureView& view() { return *found<PictureView>(panel, "pictureView"); }

    OwnFolder folder;
    OpenSession open;
    PicturePanel panel{open.session};
};

TEST_F(PicturePanelTest, RendersReadsAndSwipes) {
    EXPECT_FALSE(view().isVisible());
    click(panel, "pictureFirst");
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(view().isVisible());
    test::picture(panel, "picture_panel");

    QTest::mouseMove(&view(), view().rect().center());
    QTest::qWait(50);
    const auto under = found<QLabel>(panel, "pictureUnder")->text();
    EXPECT_TRUE(under.contains("cd/m²") && under.contains("RGB")) << under.toStdString();

    found<QComboBox>(panel, "renderAlgorithm")->setCurrentText("direct");
    click(panel, "renderButton");
    ASSERT_TRUE(open.untilIdle());
    ASSERT_EQ(open.session.pictures.all().size(), 2u);
    EXPECT_EQ(open.session.pictures.shown(0)->algorithm, "direct");
    open.session.pictures.show(1, open.session.pictures.all().front().number);
    ASSERT_TRUE(open.untilIdle());
    ASSERT_TRUE(view().compares());
    const QPoint middle(view().width() / 2, view().height() / 2);
    QTest::mousePress(&view(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(&view(), middle - QPoint(120, 0));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle - QPoint(120, 0));
    EXPECT_LT(view().divider(), 0.45);
    test::picture(panel, "picture_panel_swipe");
}

TEST_F(PicturePanelTest, EachPartOfTheEyeCanBeSwitched) {
    click(panel, "renderButton");
    ASSERT_TRUE(open.untilIdle());
    const auto before = open.session.pictures.developed(0)->image.rgb;
    found<QComboBox>(panel, "look_veil")->setCurrentIndex(2);
    ASSERT_TRUE(open.untilIdle());
    EXPECT_NE(open.session.pictures.developed(0)->image.rgb, before);
    const auto& effects = open.session.pictures.developed(0)->record->effects;
    EXPECT_EQ(effects.front().effect, "veil");
    EXPECT_FALSE(effects.front().applied);
    click(panel, "lookFalseColour");
    ASSERT_TRUE(open.untilIdle());
    EXPECT_FALSE(open.session.pictures.developed(0)->record);
    test::picture(panel, "picture_panel_false_colour");
}

TEST_F(PicturePanelTest, ZoomsAboutTheCursorAndFitsAgain) {
    click(panel, "renderButton");
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(view().fits());
    click(panel, "pictureOneToOne");
    EXPECT_DOUBLE_EQ(view().zoom(), 1);
    click(panel, "pictureFit");
    EXPECT_TRUE(view().fits());
    EXPECT_GT(view().zoom(), 1);
}

}  // namespace
}  // namespace luxdeck::gui

// The panel of irradiance volumes under real clicks and drags.
#include "gui/panels/volume_panel.h"
#include "tests/gui/made_volume.h"
#include "tests/gui/open_session.h"
#include "tests/gui/window/panel_support.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

using test::click;
using test::found;
using test::madeVolume;
using test::OpenSession;
using test::OwnFolder;

class VolumePanelTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(open.open(folder.sample("office"))) << open.errors();
        panel.resize(340, 900);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }
    const ViewSettings& view(std::size_t index = 0) { return open.session.views()[index]; }
    static VolumeState grey(const std::string& name) {
        return madeVolume(name, [](const Vec3&) { return 1.0F; });
    }

    OwnFolder folder;
    OpenSession open;
    VolumePanel panel{open.session};
};

TEST_F(VolumePanelTest, BuildsWhatTheProjectAsksForAndListsIt) {
    EXPECT_TRUE(found<QLabel>(panel, "volumeEmpty")->isVisible());
    EXPECT_EQ(found<QSpinBox>(panel, "volumeFirstX")->value(), 7);
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(found<QLabel>(panel, "volumeEstimate")->text().contains("vertices"));
    test::picture(panel, "volume_panel_empty");
    found<QSpinBox>(panel, "volumeSecond")->setValue(2);
    found<QSpinBox>(panel, "volumeBins")->setValue(4);
    found<QDoubleSpinBox>(panel, "volumeTime")->setValue(5);
    click(panel, "volumeBuild");
    EXPECT_TRUE(found<QPushButton>(panel, "volumeStop")->isVisible());
    ASSERT_TRUE(open.untilIdle()) << open.errors();
    const auto* state = open.session.volumes.shown();
    ASSERT_NE(state, nullptr) << open.errors();
    EXPECT_EQ(state->name, "room");
    EXPECT_EQ(state->volume->vertexCount(), 343u);
    auto* list = found<QTreeWidget>(panel, "volumeList");
    ASSERT_EQ(list->topLevelItemCount(), 1);
    EXPECT_EQ(list->topLevelItem(0)->text(1), "343");
    EXPECT_FALSE(found<QLabel>(panel, "volumeEmpty")->isVisible());
    EXPECT_FALSE(found<QPushButton>(panel, "volumeStop")->isVisible());
}

TEST_F(VolumePanelTest, TheEstimateIsWhatIsBuilt) {
    found<QSpinBox>(panel, "volumeFirstX")->setValue(4);
    found<QSpinBox>(panel, "volumeSecond")->setValue(2);
    QTest::qWait(400);
    ASSERT_TRUE(open.untilIdle());
    EXPECT_TRUE(found<QLabel>(panel, "volumeEstimate")->text().startsWith("196 vertices")) << found<QLabel>(panel, "volumeEstimate")->text().toStdString();
}

TEST_F(VolumePanelTest, SlidersAndSwitchesSetTheView) {
    open.session.volumes.add(grey("a"));
    found<QCheckBox>(panel, "showGlyphs")->setChecked(true);
    EXPECT_TRUE(view().glyphs);
    auto* order = found<QSlider>(panel, "volumeOrder");
    order->setFocus();
    QTest::keyClick(order, Qt::Key_Home);
    EXPECT_EQ(view().order, 0);
    EXPECT_EQ(found<QLabel>(panel, "volumeOrderText")->text(), "radiance");
    QTest::keyClick(order, Qt::Key_Right);
    EXPECT_EQ(found<QLabel>(panel, "volumeOrderText")->text(), "irradiance");
    QTest::keyClick(order, Qt::Key_Right);
    EXPECT_EQ(found<QLabel>(panel, "volumeOrderText")->text(), "moment 2");
    QTest::keyClick(found<QSlider>(panel, "glyphRadius"), Qt::Key_End);
    EXPECT_NEAR(view().glyphRadiusM, 0.3, 1e-9);
    found<QCheckBox>(panel, "sliceOn")->setChecked(true);
    EXPECT_TRUE(view().slice.on);
    EXPECT_EQ(found<QLabel>(panel, "sliceOffsetText")->text(), "0.80 m") << "a slice begins at desk height";
    QTest::keyClick(found<QComboBox>(panel, "sliceAxis"), Qt::Key_Down);
    EXPECT_EQ(view().slice.normal, Vec3d(1, 0, 0));
    QTest::keyClick(found<QComboBox>(panel, "sliceFacing"), Qt::Key_Down);
    EXPECT_EQ(view().sliceFacing, Vec3d(0, 0, -1));
    found<QCheckBox>(panel, "isosurfaceOn")->setChecked(true);
    found<QDoubleSpinBox>(panel, "isosurfaceLevel")->setValue(450);
    EXPECT_TRUE(view().isosurface);
    EXPECT_EQ(view().isosurfaceLux, 450);
    test::picture(panel, "volume_panel");
}

TEST_F(VolumePanelTest, DirectAgainstIndirectInTwoLinkedViews) {
    open.session.volumes.add(grey("a"));
    click(panel, "directIndirect");
    ASSERT_EQ(open.session.views().size(), 2u);
    EXPECT_EQ(view(0).part, LightPart::Direct);
    EXPECT_EQ(view(1).part, LightPart::Indirect);
    EXPECT_TRUE(view(0).glyphs && view(1).glyphs);
    EXPECT_TRUE(open.session.display().linkedCameras);
}

TEST_F(VolumePanelTest, EachViewMayShowAVolumeOfItsOwn) {
    open.session.volumes.add(grey("a"));
    EXPECT_FALSE(found<QPushButton>(panel, "twoVolumes")->isEnabled());
    open.session.volumes.add(grey("b"));
    click(panel, "twoVolumes");
    EXPECT_EQ(view(0).volume, "b");
    EXPECT_EQ(view(1).volume, "a");
    panel.setView(1);
    EXPECT_EQ(found<QComboBox>(panel, "viewVolume")->currentText(), "a");
    auto* list = found<QTreeWidget>(panel, "volumeList");
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->topLevelItem(0)).center());
    EXPECT_EQ(open.session.volumes.shown()->name, "a");
    click(panel, "volumeRemove");
    ASSERT_EQ(open.session.volumes.all().size(), 1u);
    EXPECT_EQ(open.session.volumes.shown()->name, "b");
}

}  // namespace
}  // namespace luxdeck::gui

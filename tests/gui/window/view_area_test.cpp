// The views with real mouse events: what is clicked is selected, what is dragged moves.
#include "gui/app/theme.h"
#include "gui/view3d/legend_bar.h"
#include "gui/view3d/scene_view.h"
#include "gui/view3d/view_area.h"
#include "tests/gui/open_session.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace luxdeck::gui {
namespace {

using test::OpenSession;
using test::OwnFolder;

/// A project in views of 1000 x 700.
class Views : public testing::Test {
protected:
    void open(const std::string& sample = "office") {
        ASSERT_TRUE(open_.open(folder_.sample(sample))) << open_.errors();
        area_ = std::make_unique<ViewArea>(session());
        ASSERT_TRUE(open_.untilIdle());  // what is drawn has been made
        area_->resize(1000, 700);
        area_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(area_.get()));
        area_->lookFrom(Side::Iso);
        settle();
    }
    /// Renders and texts are done.
    static void settle() { QTest::qWait(200); }
    Session& session() { return open_.session; }
    SceneView& view(std::size_t index = 0) { return area_->view(index); }
    const Scene& scene() { return session().project()->project.scene; }
    void solve(std::uint32_t samples = 64) {
        SolveSettings settings;
        settings.samples = samples;
        session().solving.start(settings);
        ASSERT_TRUE(open_.untilIdle());
        settle();
    }
    QPoint pixel(const Vec3d& point, std::size_t index = 0) { return view(index).pixelOf(point).value().toPoint(); }
    std::size_t object(const std::string& name) {
        const auto& objects = scene().objects;
        const auto at = std::find_if(objects.begin(), objects.end(), [&](const SceneObject& o) { return o.name == name; });
        return static_cast<std::size_t>(at - objects.begin());
    }
    /// For looking at, when LUXDECK_PICTURES names a folder.
    void keep(const std::string& name) {
        if (const char* folder = std::getenv("LUXDECK_PICTURES")) area_->picture().save(QString::fromStdString(std::string(folder) + "/" + name + ".png"));
    }

    OwnFolder folder_;
    OpenSession open_;
    std::unique_ptr<ViewArea> area_;
};

TEST_F(Views, AreLookedAt) {
    if (std::getenv("LUXDECK_PICTURES") == nullptr) GTEST_SKIP() << "pictures to be looked at: LUXDECK_PICTURES=FOLDER";
    for (const std::string sample : {"office", "classroom", "gallery"}) {
        open(sample);
        for (const auto theme : {Theme::Light, Theme::Dark}) {
            applyTheme(*qApp, theme);
            const std::string suffix = theme == Theme::Light ? "" : "-dark";
            area_->lookFrom(Side::Iso);
            settle();
            keep(sample + "-iso" + suffix);
            area_->goTo(session().project()->project.views.front());
            settle();
            keep(sample + "-inside" + suffix);
        }
        solve();
        keep(sample + "-lux-inside-dark");
        applyTheme(*qApp, Theme::Light);
        area_->lookFrom(Side::Iso);
        settle();
        keep(sample + "-lux-iso");
        if (sample == "office") {
            session().select({Thing::Object, object("Armchair 01")});
            settle();
            keep("office-object");
            session().select({Thing::Luminaire, 9});
            session().setViewCount(4);
            auto solids = session().views()[1];
            solids.candelaSolids = true, solids.grids = false, solids.surfaces = SurfaceLook::Plain;
            session().setView(1, solids);
            solids.candelaSolids = false, solids.surfaces = SurfaceLook::Wireframe;
            session().setView(2, solids);
            solids.surfaces = SurfaceLook::Materials, solids.section = {true, {1, 0, 0}, 1};
            session().setView(3, solids);
            settle();
            keep("office-four");
            session().setViewCount(1);
            settle();
        }
        area_->lookFrom(Side::Top);
        auto settings = session().views().front();
        settings.values = true;
        session().setView(0, settings);
        session().select({Thing::Grid, 7});
        settle();
        keep(sample + "-lux-top");
        area_.reset();
    }
}

/// A place well over an object's foot that nothing else hides from the camera.
Vec3d middleOf(const SceneParts& parts, std::size_t object) { return Vec3d(parts.bounds(static_cast<std::uint32_t>(object)).center()); }

TEST_F(Views, AClickSelectsWhatIsUnderTheCursorAndAnotherWhatLiesBehind) {
    open();
    const SceneParts parts(scene());
    const auto sofa = object("Sofa");
    QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel(middleOf(parts, sofa)));
    EXPECT_EQ(session().selection(), (Selection{Thing::Object, sofa}));
    const auto behind = session().selection();
    QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel(middleOf(parts, sofa)));
    EXPECT_NE(session().selection(), behind);
    // The background.
    QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(5, 5));
    EXPECT_EQ(session().selection(), Selection{});
}

TEST_F(Views, AClickOnALuminaireSelectsItThroughTheOpenCeiling) {
    open();
    for (std::size_t i = 0; i < scene().luminaires.size(); i += 7) {
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel(Vec3d(scene().luminaires[i].position)));
        EXPECT_EQ(session().selection(), (Selection{Thing::Luminaire, i})) << scene().luminaires[i].name;
    }
}

TEST_F(Views, TheCeilingIsThereFromInsideAndGoneFromAbove) {
    open();
    const SceneParts parts(scene());
    const auto fromAbove = parts.sidesInTheWay(view().pose());
    area_->goTo(session().project()->project.views.front());
    const auto fromInside = parts.sidesInTheWay(view().pose());
    EXPECT_NE(fromAbove >> static_cast<unsigned>(ShellSide::Ceiling) & 1U, 0U);
    EXPECT_EQ(fromInside, 0U);
    EXPECT_EQ(parts.sideOfObject(static_cast<std::uint32_t>(object("Ceiling grid"))), ShellSide::Ceiling);
    EXPECT_EQ(parts.sideOfObject(static_cast<std::uint32_t>(object("Wall west"))), ShellSide::West);
    EXPECT_EQ(parts.sideOfObject(static_cast<std::uint32_t>(object("Window pane 01"))), ShellSide::South);
    EXPECT_EQ(parts.sideOfObject(static_cast<std::uint32_t>(object("Floor slab"))), ShellSide::Floor);
    EXPECT_EQ(parts.sideOfObject(static_cast<std::uint32_t>(object("Sofa"))), ShellSide::None);
    EXPECT_EQ(parts.sideOfObject(static_cast<std::uint32_t>(object("Glass wall west"))), ShellSide::None);
}

TEST_F(Views, DraggingTheArrowMovesTheObjectAlongItInSteps) {
    open();
    session().select({Thing::Object, object("Armchair 01")});
    settle();
    std::vector<Vec3d> moves;
    bool finished = false;
    QObject::connect(area_.get(), &ViewArea::objectDragged, [&](const QString& name, const Vec3d& moveM, double turnDeg, bool done) {
        EXPECT_EQ(name, "Armchair 01");
        EXPECT_EQ(turnDeg, 0);
        moves.push_back(moveM);
        finished = done;
    });
    const QPoint from = view().gizmo().placeOf(Handle::X).value().toPoint();
    const Vec3d centre = view().gizmo().target()->centre;
    const QPoint step = pixel(centre + Vec3d(0.62, 0, 0)) - pixel(centre);
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&view(), from + step / 2);
    QTest::mouseMove(&view(), from + step);
    settle();
    keep("office-gizmo");
    ASSERT_FALSE(moves.empty());
    EXPECT_FALSE(finished);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, from + step);
    EXPECT_TRUE(finished);
    EXPECT_NEAR(moves.back().x, 0.6, 1e-9);
    EXPECT_EQ(moves.back().y, 0);
    EXPECT_EQ(moves.back().z, 0);
}

TEST_F(Views, TheRingTurnsAndEscapePutsBack) {
    open();
    session().select({Thing::Object, object("Armchair 01")});
    settle();
    double turned = 0;
    QObject::connect(area_.get(), &ViewArea::objectDragged, [&](const QString&, const Vec3d&, double turnDeg, bool) { turned = turnDeg; });
    const QPoint from = view().gizmo().placeOf(Handle::Turn).value().toPoint();
    ASSERT_EQ(view().gizmo().handleAt(from), Handle::Turn);
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&view(), from + QPoint(-8, 60));
    EXPECT_NE(turned, 0);
    EXPECT_NEAR(std::remainder(turned, 15), 0, 1e-9);
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_EQ(turned, 0);
    EXPECT_FALSE(view().gizmo().dragging());
}

TEST_F(Views, WhatCannotBeMovedHasNoHandles) {
    open();
    session().select({Thing::Object, object("Sofa")});
    EXPECT_FALSE(view().gizmo().target());
    session().select({Thing::Luminaire, 3});
    ASSERT_TRUE(view().gizmo().target());
    EXPECT_TRUE(view().gizmo().target()->vertical);
}

TEST_F(Views, TheWheelComesCloserToWhatIsUnderTheCursor) {
    open();
    const SceneParts parts(scene());
    const auto at = pixel(middleOf(parts, object("Sofa")));
    const auto point = view().pickedAt(at).point;
    const double before = (view().pose().position - point).length();
    QWheelEvent wheel(QPointF(at), view().mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view(), &wheel);
    EXPECT_LT((view().pose().position - point).length(), 0.9 * before);
    EXPECT_LE((pixel(point) - at).manhattanLength(), 2);  // both are rounded to pixels
}

TEST_F(Views, FitShowsEverything) {
    open();
    area_->goTo(session().project()->project.views.front());
    QTest::keyClick(&view(), Qt::Key_F);
    const auto box = SceneParts(scene()).sceneBounds();
    for (int i = 0; i < 8; ++i) {
        const Vec3d corner(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
        const auto at = view().pixelOf(corner);
        ASSERT_TRUE(at);
        EXPECT_TRUE(QRectF(view().rect()).contains(*at)) << i;
    }
}

TEST_F(Views, TheLegendHasTheUnitOfTheSessionAndIsThereWithTheLightAlone) {
    open();
    auto* legend = area_->findChild<LegendBar*>();
    ASSERT_NE(legend, nullptr);
    EXPECT_FALSE(legend->isVisible());
    solve();
    EXPECT_TRUE(legend->isVisible());
    EXPECT_EQ(legend->unit(), "lx");
    const auto lux = legend->numbers().last().remove(' ').toDouble();
    EXPECT_NEAR(lux, area_->scale().high, 0.3 * area_->scale().high);
    auto display = session().display();
    display.units.light = LightUnit::Footcandle;
    session().setDisplay(display);
    EXPECT_EQ(legend->unit(), "fc");
    EXPECT_LT(legend->numbers().last().toDouble(), 0.2 * lux);
}

TEST_F(Views, TheCursorReadsTheIlluminanceOfTheSurfaceUnderIt) {
    open();
    solve(256);
    area_->lookFrom(Side::Top);
    const auto& grid = session().solving.result()->grids[7];
    ASSERT_EQ(grid.name, "Whole room, work plane");
    const auto& point = grid.points[static_cast<std::size_t>(grid.columns) + 9];
    QString reading;
    QObject::connect(area_.get(), &ViewArea::probed, [&](const QString& text) { reading = text; });
    QTest::mouseMove(&view(), pixel(point.position - scene().origin));
    EXPECT_TRUE(reading.contains("Whole room, work plane")) << reading.toStdString();
    // Pixels are near the point, not on it.
    const double read = reading.section("·", 1, 1).section("±", 0, 0).trimmed().section(' ', 0, 0).toDouble();
    EXPECT_NEAR(read, point.total.value, 0.05 * point.total.value) << reading.toStdString();
}

TEST_F(Views, LinkedViewsMoveTogetherAndOthersAlone) {
    open();
    session().setViewCount(2);
    ASSERT_EQ(area_->viewCount(), 2U);
    area_->setActiveView(1);
    area_->lookFrom(Side::Top);
    EXPECT_EQ(view(0).pose(), view(1).pose());
    auto display = session().display();
    display.linkedCameras = false;
    session().setDisplay(display);
    area_->lookFrom(Side::Left);
    EXPECT_FALSE(view(0).pose() == view(1).pose());
    QTest::mouseClick(&view(0), Qt::LeftButton, {}, QPoint(5, 5));
    EXPECT_EQ(area_->activeView(), 0U);
}

TEST_F(Views, TheCameraBecomesAViewOfTheProject) {
    open();
    const auto& cover = session().project()->project.views.front();
    area_->goTo(cover);
    const auto view = area_->cameraAsView("mine");
    EXPECT_EQ(view.name, "mine");
    EXPECT_LT((view.position - cover.position).length(), 1e-5);
    EXPECT_LT((view.direction - cover.direction).length(), 1e-6);
    EXPECT_EQ(view.verticalFovDeg, cover.verticalFovDeg);
}

TEST_F(Views, WalkingGoesAheadWhileTheKeyIsHeld) {
    open();
    auto display = session().display();
    display.navigation = Navigation::Walk;
    session().setDisplay(display);
    const auto before = view().pose();
    EXPECT_NEAR(before.position.z, 1.6, 0.3);
    QTest::keyPress(&view(), Qt::Key_W);
    QTest::qWait(300);
    QTest::keyRelease(&view(), Qt::Key_W);
    const Vec3d went = view().pose().position - before.position;
    EXPECT_GT(went.length(), 0.1);
    EXPECT_NEAR(went.z, 0, 1e-9);
    const auto after = view().pose();
    QTest::qWait(150);
    EXPECT_EQ(view().pose(), after);
}

}  // namespace
}  // namespace luxdeck::gui

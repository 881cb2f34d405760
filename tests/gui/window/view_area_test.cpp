// The views with real mouse events: what is clicked is selected, what is dragged moves.
#include "gui/app/theme.h"
#include "gui/view3d/scene_view.h"
#include "gui/view3d/view_area.h"
#include "tests/gui/open_session.h"

#include <QApplication>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
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

}  // namespace
}  // namespace luxdeck::gui

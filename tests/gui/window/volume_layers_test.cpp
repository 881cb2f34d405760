// What views show of an irradiance volume, pixel by pixel.
#include "gui/view3d/glyph_layer.h"
#include "gui/view3d/lattice_layer.h"
#include "gui/view3d/slice_layer.h"
#include "tests/gui/made_volume.h"
#include "tests/gui/open_session.h"
#include "tests/gui/window/picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace luxdeck::gui {
namespace {

using test::madeVolume;
using test::OpenSession;
using test::Picture;

const ResolvedScale kScale{0, 100, false, tonemap::ColourMap::Dusk};

struct Glyphs {
    OpenSession open;
    Picture picture;
    GlyphLayer layer{*picture.renderer};
    ViewSettings view;

    Glyphs() {
        view.glyphs = true;
        view.glyphRadiusM = 0.15;  // the others do not hide the one that is looked at
    }
    /// What is in the middle of the picture, looking from `from` at the vertex (1, 1, 1).
    Picture::Colour seenFrom(const Vec3d& from) {
        layer.update(open.session, view, kScale);
        open.untilIdle();
        layer.update(open.session, view, kScale);
        const Vec3d eye = Vec3d(1) + from.normalized() * 6;
        picture.look({eye.x, eye.y, eye.z}, {1, 1, 1}, 20);
        picture.render();
        return picture.at(200, 150);
    }
};

void expectColour(const Picture::Colour& seen, const tonemap::Colour8& expected, int tolerance, const std::string& what) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], tolerance) << what << ", channel " << c;
}

TEST(GlyphLayer, LightFromOneSideMakesThatSideBright) {
    Glyphs glyphs;
    const auto state = madeVolume("x", [](const Vec3& d) { return d.x > 0 ? 30.0F : 0.0F; }, 8);
    glyphs.open.session.volumes.add(state);
    const auto bins = state.volume->bins();
    for (const Vec3d& from : {Vec3d(1, 0.1, 0.1), Vec3d(-1, 0.1, 0.1), Vec3d(0.1, 1, 0.2)}) {
        // A hemisphere of radiance L gives pi L (1 + cos) / 2; directions share their bin's value.
        const double cosine = bins.centre(bins.binOf(Vec3(from.normalized()))).x;
        expectColour(glyphs.seenFrom(from), LightColours(kScale).colour(30 * kPiD * (1 + cosine) / 2), 5, fmt::format("from x = {}", from.x));
    }
}

TEST(GlyphLayer, EachDirectionShowsItsOwnBin) {
    Glyphs glyphs;
    glyphs.view.order = 0;
    const auto radiance = [](const Vec3& d) { return 50 + 20 * d.x + 15 * d.y + 10 * d.z; };
    const auto state = madeVolume("slopes", radiance);
    glyphs.open.session.volumes.add(state);
    for (const Vec3d& from : {Vec3d(1, 0.1, 0.2), Vec3d(-0.3, 1, 0.4), Vec3d(0.2, -1, -0.3), Vec3d(0.1, 0.2, 1), Vec3d(-0.2, 0.1, -1), Vec3d(-1, -1, 0.5)}) {
        const auto bins = state.volume->bins();
        const double value = radiance(bins.centre(bins.binOf(Vec3(from.normalized()))));
        expectColour(glyphs.seenFrom(from), LightColours(kScale).colour(value), 3, fmt::format("from {} {} {}", from.x, from.y, from.z));
    }
}

TEST(GlyphLayer, PartsViewsVolumesAndUnusableVertices) {
    Glyphs glyphs;
    auto& session = glyphs.open.session;
    session.volumes.add(madeVolume("bright", [](const Vec3&) { return 20.0F; }));
    auto dark = madeVolume("inside", [](const Vec3&) { return 1.0F; });
    auto changed = std::make_shared<IrradianceVolume>(*dark.volume);
    for (auto& quality : changed->quality) quality.inside = true;
    dark.volume = changed;
    session.volumes.add(dark);
    glyphs.view.volume = "bright";
    expectColour(glyphs.seenFrom({1, 0, 0}), LightColours(kScale).colour(20 * kPiD), 4, "the volume that the view names");
    glyphs.view.part = LightPart::Indirect;
    expectColour(glyphs.seenFrom({1, 0, 0}), LightColours(kScale).colour(0), 4, "there is no indirect light");
    glyphs.view.volume = "inside";
    glyphs.view.part = LightPart::Total;
    const auto cross = glyphs.seenFrom({1, 0.3, 0.3});
    EXPECT_NEAR(cross[0], 0.55 * 255, 12) << "a cross marks a vertex that nothing is known of";
    glyphs.view.glyphs = false;
    expectColour(glyphs.seenFrom({1, 0, 0}), {0, 0, 0}, 0, "switched off");
}

TEST(GlyphLayer, RangeIsThatOfTheLightAndNothingChangesTwice) {
    Glyphs glyphs;
    auto& session = glyphs.open.session;
    EXPECT_TRUE(glyphs.layer.lightRange(session, glyphs.view).empty()) << "no volume";
    session.volumes.add(madeVolume("x", [](const Vec3& d) { return d.x > 0 ? 30.0F : 0.0F; }));
    EXPECT_TRUE(glyphs.layer.lightRange(session, glyphs.view).empty()) << "not made yet";
    ASSERT_TRUE(glyphs.open.untilIdle());
    EXPECT_NEAR(glyphs.layer.lightRange(session, glyphs.view).high, 30 * kPiD, 4);
    EXPECT_TRUE(glyphs.layer.update(session, glyphs.view, kScale));
    EXPECT_FALSE(glyphs.layer.update(session, glyphs.view, kScale));
    glyphs.view.glyphRadiusM = 0.1;
    EXPECT_TRUE(glyphs.layer.update(session, glyphs.view, kScale));
}

TEST(LatticeLayer, LevelsAreDrawnWhenAskedFor) {
    OpenSession open;
    auto state = madeVolume("x", [](const Vec3&) { return 1.0F; });
    auto divided = std::make_shared<IrradianceVolume>(*state.volume);
    divided->lattice = *Lattice::create(Box3(Vec3(-1), Vec3(1)), {1, 1, 1}, 2, 1);
    divided->lattice.divide(0);
    state.volume = divided;
    open.session.volumes.add(state);
    Picture picture;
    LatticeLayer layer(*picture.renderer);
    ViewSettings view;
    const auto coloured = [&] {
        layer.update(open.session, view, kScale);
        picture.look({0, 0, 8}, {0, 0.001, 0}, 20);
        picture.render();
        int count = 0;
        for (int x = 0; x < 400; x += 1)
            for (int y = 100; y < 200; y += 9) count += picture.at(x, y) != Picture::Colour{0, 0, 0} ? 1 : 0;
        return count;
    };
    EXPECT_EQ(coloured(), 0);
    view.firstLevelGrid = true;
    const int first = coloured();
    EXPECT_GT(first, 0);
    view.secondLevelGrid = true;
    EXPECT_GT(coloured(), first);
}

/// Light that depends on the height alone: 10 lx at z = -1 to 90 lx at z = 1, on surfaces that face up.
VolumeState lighterAbove() {
    auto state = madeVolume("slope", [](const Vec3& d) { return d.z > 0 ? 1.0F : 0.0F; }, 8);
    auto volume = std::make_shared<IrradianceVolume>(*state.volume);
    for (std::size_t v = 0; v < volume->vertexCount(); ++v)
        for (std::size_t bin = 0; bin < volume->binCount(); ++bin)
            volume->direct[v * volume->binCount() + bin] *= (50 + 40 * volume->lattice.vertices()[v].z) / kPi;
    state.volume = volume;
    return state;
}

TEST(SliceLayer, PlaneAndIsosurfaceLieWhereTheLightIs) {
    OpenSession open;
    open.session.volumes.add(lighterAbove());
    Picture picture;
    SliceLayer layer(*picture.renderer);
    ViewSettings view;
    view.isolines = false;
    const auto middle = [&] {
        open.until([&] {
            layer.lightRange(open.session, view);
            return open.session.place.jobs.idle();
        });
        layer.update(open.session, view, kScale);
        picture.look({0.03, -8, 0.02}, {0.03, 0, 0.02}, 20);
        picture.render();
        return picture.at(200, 150);
    };
    EXPECT_EQ(middle(), (Picture::Colour{0, 0, 0})) << "nothing is asked for";
    view.slice = {true, {0, 1, 0}, 0};
    // Bins are blended, a hundredth of the light: some steps of colour.
    expectColour(middle(), LightColours(kScale).colour(50), 6, "an upright plane at half height");
    EXPECT_NEAR(layer.lightRange(open.session, view).high, 90, 3);
    view.sliceFacing = {0, 0, -1};
    expectColour(middle(), LightColours(kScale).colour(0), 6, "of surfaces that face down");
    view.slice.on = false;
    view.sliceFacing = {0, 0, 1};
    view.isosurface = true;
    view.isosurfaceLux = 50;
    middle();
    picture.look({0, -3, 4}, {0, 0, 0}, 20);
    picture.render();
    EXPECT_NE(picture.at(200, 150), (Picture::Colour{0, 0, 0})) << "a level plane in the middle";
    view.isosurfaceLux = 500;
    middle();
    picture.look({0, -3, 4}, {0, 0, 0}, 20);
    picture.render();
    EXPECT_EQ(picture.at(200, 150), (Picture::Colour{0, 0, 0})) << "nowhere so bright";
}

}  // namespace
}  // namespace luxdeck::gui

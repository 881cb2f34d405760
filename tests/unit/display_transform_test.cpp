#include "tonemap/display_transform.h"
#include "engine/core/file.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace luxdeck::tonemap {
namespace {

namespace fs = std::filesystem;

class Display : public ::testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("luxdeck_ocio_" + std::to_string(::getpid()));
        fs::create_directories(folder);
        ::unsetenv("OCIO");
    }
    void TearDown() override {
        ::unsetenv("OCIO");
        fs::remove_all(folder);
    }
    fs::path folder;
};

Image ramp() {
    Image image(256, 1, {"R", "G", "B"});
    for (std::size_t x = 0; x < 256; ++x) {
        image.channel("R")[x] = static_cast<float>(x) / 255;
        image.channel("G")[x] = static_cast<float>(255 - x) / 255;
        image.channel("B")[x] = 0.18F;
    }
    return image;
}

double srgb(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

TEST_F(Display, OurDefaultOnlyEncodes) {
    const auto transform = DisplayTransform::create({});
    ASSERT_TRUE(transform) << transform.error().text();
    EXPECT_EQ(transform->view(), kToneMappedView);
    EXPECT_EQ(transform->sourceSpace(), "Linear Rec.709");
    const auto shown = transform->apply(ramp());
    ASSERT_TRUE(shown);
    for (std::size_t x = 0; x < 256; ++x)  // a rounding border may fall either way
        for (std::size_t c = 0; c < 3; ++c) {
            const double linear = c == 0 ? x / 255.0 : c == 1 ? (255 - x) / 255.0 : 0.18;
            EXPECT_NEAR(shown->rgb[3 * x + c], 255 * srgb(linear), 0.6) << x << " " << c;
        }
}

TEST_F(Display, ListsWhatCanBeChosen) {
    const auto displays = displaysOf();
    ASSERT_TRUE(displays);
    ASSERT_FALSE(displays->empty());
    for (const auto& each : *displays)
        for (const auto& view : each.views) EXPECT_TRUE(DisplayTransform::create({{}, each.display, view})) << each.display << " " << view;
    EXPECT_EQ(displays->front().views.front(), DisplayTransform::create({})->view());
    EXPECT_EQ(displaysOf((folder / "none.ocio").string()).error().code, ErrorCode::FileNotFound);
}

TEST_F(Display, TheConfigInsideIsTheFileThatIsInstalled) {
    const auto file = readFile(fs::path(LUXDECK_SOURCE_DIR) / "tonemap/luxdeck.ocio");
    ASSERT_TRUE(file);
    EXPECT_EQ(*file, builtinConfig());
}

TEST_F(Display, AcesRollsOffAndRawDoesNothing) {
    DisplayTransformSettings settings;
    settings.view = kAcesView;
    const auto aces = DisplayTransform::create(settings);
    ASSERT_TRUE(aces) << aces.error().text();
    Image bright(1, 1, {"R", "G", "B"});
    for (const char* c : {"R", "G", "B"}) bright.channel(c)[0] = 2;  // beyond white
    const auto shown = aces->apply(bright);
    ASSERT_TRUE(shown);
    EXPECT_LT(shown->rgb[1], 255);
    EXPECT_GT(shown->rgb[1], 200);
    settings.view = "Raw";
    const auto raw = DisplayTransform::create(settings);
    ASSERT_TRUE(raw);
    EXPECT_EQ(raw->apply(ramp())->rgb[3 * 100], 100);
}

TEST_F(Display, UnknownNamesAreListed) {
    DisplayTransformSettings settings;
    settings.view = "Filmic";
    auto transform = DisplayTransform::create(settings);
    ASSERT_FALSE(transform);
    EXPECT_EQ(transform.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(transform.error().text().find("'ACES SDR'"), std::string::npos) << transform.error().text();
    settings = {};
    settings.display = "HDR";
    EXPECT_EQ(DisplayTransform::create(settings).error().code, ErrorCode::InvalidArgument);
}

TEST_F(Display, TheEnvironmentsConfigIsHonoured) {
    ASSERT_TRUE(writeFileAtomically(folder / "other.ocio",
                                    "ocio_profile_version: 2\nroles: {default: plain, scene_linear: plain}\ndisplays:\n"
                                    "  Wall:\n    - !<View> {name: As it is, colorspace: plain}\n"
                                    "colorspaces:\n  - !<ColorSpace> {name: plain}\n"));
    ::setenv("OCIO", (folder / "other.ocio").c_str(), 1);
    const auto transform = DisplayTransform::create({});
    ASSERT_TRUE(transform) << transform.error().text();
    EXPECT_EQ(transform->display(), "Wall");
    EXPECT_EQ(transform->view(), "As it is");
    EXPECT_EQ(transform->sourceSpace(), "plain");
    EXPECT_EQ(transform->apply(ramp())->rgb[3 * 77], 77);
}

TEST_F(Display, BrokenConfigsAreErrors) {
    ASSERT_TRUE(writeFileAtomically(folder / "broken.ocio", "ocio_profile_version: [2\nthis is: not yaml"));
    ::setenv("OCIO", (folder / "broken.ocio").c_str(), 1);
    auto transform = DisplayTransform::create({});
    ASSERT_FALSE(transform);
    EXPECT_EQ(transform.error().code, ErrorCode::Parse);
    EXPECT_NE(transform.error().text().find("$OCIO"), std::string::npos) << transform.error().text();
    DisplayTransformSettings settings;
    settings.config = (folder / "none.ocio").string();
    EXPECT_EQ(DisplayTransform::create(settings).error().code, ErrorCode::FileNotFound);
}

TEST_F(Display, DitherKeepsTheMean) {
    DisplayTransformSettings settings;
    settings.view = "Raw";
    settings.dither = true;
    const auto transform = DisplayTransform::create(settings);
    ASSERT_TRUE(transform);
    Image flat(64, 64, {"R", "G", "B"});
    for (const char* c : {"R", "G", "B"}) std::ranges::fill(flat.channel(c), 100.3F / 255);
    const auto shown = transform->apply(flat);
    ASSERT_TRUE(shown);
    double sum = 0;
    for (const auto v : shown->rgb) {
        EXPECT_TRUE(v == 100 || v == 101);
        sum += v;
    }
    EXPECT_NEAR(sum / static_cast<double>(shown->rgb.size()), 100.3, 1.0 / 64);  // 64 thresholds
}

TEST_F(Display, BrokenPixelsAreBlackAndChannelsAreNeeded) {
    const auto transform = DisplayTransform::create({});
    ASSERT_TRUE(transform);
    Image image(1, 1, {"R", "G", "B"});
    image.channel("R")[0] = std::numeric_limits<float>::quiet_NaN();
    image.channel("G")[0] = 1e30F;
    EXPECT_EQ(transform->apply(image)->rgb, (std::vector<std::uint8_t>{0, 0, 0}));
    EXPECT_FALSE(transform->apply(Image(1, 1, {"Y"})));
}

}  // namespace
}  // namespace luxdeck::tonemap

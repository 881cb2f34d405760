// One scale of colours for all views and the legend.
#include "gui/view3d/light_colours.h"

#include <gtest/gtest.h>
#include <vtkLookupTable.h>

#include <cmath>
#include <limits>

namespace luxdeck::gui {
namespace {

TEST(LightColours, AutomaticRangeIsRoundAndHoldsWhatIsShown) {
    const auto linear = resolved(LegendScale{}, 37, 613);
    EXPECT_LE(linear.low, 37);
    EXPECT_GE(linear.high, 613);
    EXPECT_LT(linear.high, 1300);
    LegendScale legend;
    legend.logarithmic = true;
    const auto logarithmic = resolved(legend, 0, 613);
    EXPECT_GT(logarithmic.low, 0);
    EXPECT_GE(logarithmic.high, 613);
}

TEST(LightColours, RangesThatAreEmptyBecomeUsable) {
    EXPECT_GT(resolved(LegendScale{}, 5, 5).high, resolved(LegendScale{}, 5, 5).low);
    LegendScale legend{false, 0, 0, true, tonemap::ColourMap::Heat};
    const auto scale = resolved(legend, 1, 2);
    EXPECT_GT(scale.low, 0);
    EXPECT_GT(scale.high, scale.low);
}

TEST(LightColours, TheTableHasTheSameColours) {
    for (const bool logarithmic : {false, true}) {
        const LightColours colours(ResolvedScale{10, 1000, logarithmic, tonemap::ColourMap::Dusk});
        const auto table = colours.table();
        for (const double lux : {1.0, 10.0, 55.0, 300.0, 999.0, 5000.0}) {
            const unsigned char* rgba = table->MapValue(lux);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgba[c], colours.colour(lux)[static_cast<std::size_t>(c)], 2) << lux;
        }
    }
}

TEST(LightColours, EndsAreTheMapsEndsAndNothingKnownIsNeither) {
    const LightColours colours(ResolvedScale{10, 1000, false, tonemap::ColourMap::Dusk});
    EXPECT_EQ(colours.colour(-5), tonemap::colourAt(tonemap::ColourMap::Dusk, 0));
    EXPECT_EQ(colours.colour(1e9), tonemap::colourAt(tonemap::ColourMap::Dusk, 1));
    EXPECT_EQ(colours.colour(std::numeric_limits<double>::quiet_NaN()), tonemap::kNotANumber);
}

}  // namespace
}  // namespace luxdeck::gui

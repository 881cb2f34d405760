#pragma once

#include <span>
#include <vector>

namespace luxdeck::tonemap {

/// What the picture is shown on.
struct DisplayModel {
    double maxCdM2 = 100;  ///< of white
    double minCdM2 = 1;    ///< of black, above 0: light that the screen and the room add
};

/// Which contrast the picture may have at most.
enum class Ceiling {
    Linear,  ///< no contrast stronger than in the scene (a camera)
    Human    ///< none that the scene's adapted eye would not see
};

/// Counts of log luminance ("brightness", natural logarithm) in equal bins.
struct LogHistogram {
    double minLog = 0;
    double maxLog = 0;
    std::vector<double> counts;  ///< #B

    [[nodiscard]] double binWidth() const { return (maxLog - minLog) / static_cast<double>(counts.size()); }
    [[nodiscard]] double centre(std::size_t bin) const {
        return minLog + (static_cast<double>(bin) + 0.5) * binWidth();
    }
    [[nodiscard]] double total() const;
};

/// The histogram of luminances [cd/m^2] from the darkest to the brightest that are at least kDarkestVisible
/// (darker ones are not counted). Without bins when fewer than two different ones are.
///
/// source  Larson et al. 1997, section 4.2: 100 bins
LogHistogram logHistogram(std::span<const double> luminances, int bins = 100);

/// World luminance to display luminance [cd/m^2]: monotone, within the display's range.
class ToneCurve {
public:
    /// Proportional: display = factor * world.
    static ToneCurve linear(double factor, const DisplayModel& display);
    /// Histogram equalisation of the brightnesses counted.
    static ToneCurve fromHistogram(const LogHistogram& histogram, const DisplayModel& display);

    [[nodiscard]] double displayLuminance(double worldCdM2) const;
    [[nodiscard]] bool isLinear() const { return edges_.empty(); }
    /// Display over world luminance of a linear curve; 0 for another.
    [[nodiscard]] double factor() const { return isLinear() ? factor_ : 0; }

private:
    DisplayModel display_;
    double factor_ = 1;
    double minLog_ = 0, maxLog_ = 0;
    std::vector<double> edges_;  // #B + 1: the fraction counted below each bin's edge
};

/// A histogram whose equalisation is below the ceiling, or the news that there is none.
struct AdjustedHistogram {
    LogHistogram histogram;
    bool useful = false;       ///< false: nearly all counts were above the ceiling; map linearly
    int passes = 0;
    double keptFraction = 1;   ///< of the counts
};

/// The slope dBd/dBw that the ceiling allows where world luminance shows as display luminance.
double ceilingSlope(Ceiling ceiling, double worldCdM2, double displayCdM2);

/// Cuts counts that would give more contrast than the ceiling, again and again, until a pass cuts at most
/// `tolerance` of the original counts. Counts are cut, never handed to other bins.
///
/// source  Larson et al. 1997, sections 4.3 and 4.4: the tolerance is of the *original* total, where Radiance's
///         pcond takes the current one
AdjustedHistogram adjustHistogram(LogHistogram histogram, const DisplayModel& display, Ceiling ceiling,
                                  double tolerance = 0.025);

/// The mapping for these luminances: linear when their range is no wider than the display's or the histogram
/// cannot be adjusted, else its adjusted equalisation. `adjusted` (may be null) receives how it went.
ToneCurve toneCurve(std::span<const double> luminances, const DisplayModel& display, Ceiling ceiling,
                    AdjustedHistogram* adjusted);

}  // namespace luxdeck::tonemap

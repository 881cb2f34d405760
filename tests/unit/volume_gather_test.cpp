// The algorithm that reads the irradiance volume, beside `path`.
#include "engine/algorithms/registry.h"

#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luxdeck::test {
namespace {

/// Root mean square of the relative differences to `path` over a grid at table height, whose own noise of 0.3 % is little.
double rmsAgainstPath(const Lit& lit, const AlgorithmSettings& settings) {
    const auto gather = lit.estimator("volume_gather", settings), path = lit.estimator("path");
    double sum = 0;
    int count = 0;
    for (int i = 0; i < 12; ++i) {
        const auto sensor = facing({0.4F + 1.7F * static_cast<float>(i % 4), 0.5F + 1.4F * static_cast<float>(i / 4), 0.8F}, {0, 0, 1});
        const double a = illuminance(lit, *gather, sensor, 0.006).indirect.value, b = illuminance(lit, *path, sensor, 0.006).indirect.value;
        sum += (a / b - 1) * (a / b - 1), ++count;
    }
    return std::sqrt(sum / count);
}

// Its indirect light is the paths' within the bias that the registry states, point by point.
TEST(VolumeGather, IsAsNearToPathAsItSays) {
    const Lit lit(furnishedRoom());
    EXPECT_LT(rmsAgainstPath(lit, {}), algorithmNamed("volume_gather")->bias);
}

TEST(VolumeGather, IsTheSameAtAnyEffortWhereNothingReflects) {
    SceneBuilder b;
    const Lit lit(b.isotropic({0, 0, 3}, 10000).build());
    const auto gather = lit.estimator("volume_gather");
    EXPECT_NEAR(illuminance(lit, *gather, facing({0, 0, 0}, {0, 0, 1}), 0.01).total.value, 10000 / (4 * kPiD) / 9, 1e-3);
}

TEST(VolumeGather, IsCancelledWhileItsVolumeIsBuilt) {
    const Lit lit(furnishedRoom());
    Progress progress;
    progress.cancel();
    AlgorithmSettings settings;
    settings.progress = &progress;
    const auto gather = makeEstimator("volume_gather", lit.transport(), settings);
    ASSERT_FALSE(gather);
    EXPECT_EQ(gather.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace luxdeck::test

#include "engine/sampling/alias_table.h"

#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace luxdeck {
namespace {

/// The part of [0, 1) that draws each index, by a lattice of 2^20 midpoints, and whether what is left of u is
/// uniform over it.
struct Measured {
    std::vector<double> share;
    std::vector<double> meanRest;
};
constexpr int kLattice = 1 << 20;

Measured measure(const AliasTable& table) {
    Measured m{std::vector<double>(table.size()), std::vector<double>(table.size())};
    for (int i = 0; i < kLattice; ++i) {
        const auto draw = table.draw((static_cast<float>(i) + 0.5F) / kLattice);
        EXPECT_EQ(draw.probability, table.probability(draw.index));
        EXPECT_TRUE(draw.rest >= 0 && draw.rest < 1);
        m.share[draw.index] += 1.0 / kLattice;
        m.meanRest[draw.index] += draw.rest / kLattice;
    }
    for (std::size_t i = 0; i < table.size(); ++i)
        if (m.share[i] > 0) m.meanRest[i] /= m.share[i];
    return m;
}

void expectDraws(const std::vector<double>& weights) {
    const AliasTable table(weights);
    const auto m = measure(table);
    double sum = 0;
    for (const double w : weights) sum += w;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double p = sum > 0 ? weights[i] / sum : 1.0 / static_cast<double>(weights.size());
        EXPECT_FLOAT_EQ(table.probability(static_cast<std::uint32_t>(i)), static_cast<float>(p));
        // Each of #N slots has two borders that fall between lattice points, and keeps its share as a float.
        const double slack = 2.0 * static_cast<double>(weights.size()) / kLattice + 1e-6;
        EXPECT_NEAR(m.share[i], p, slack) << "index " << i;
        if (weights[i] == 0 && sum > 0) { EXPECT_EQ(m.share[i], 0) << "drawn with probability 0: " << i; }
        if (p > 0.01) { EXPECT_NEAR(m.meanRest[i], 0.5, slack / p) << "index " << i; }
    }
}

TEST(AliasTable, DrawsWithTheGivenProbabilities) {
    expectDraws({1, 2, 3, 4});
    expectDraws({5, 0, 0, 1, 0, 10, 0.001, 2});
    expectDraws({1e-30, 1e-30, 2e-30});
    expectDraws({1e30, 1, 1e30});
}

TEST(AliasTable, AllZeroIsUniform) { expectDraws({0, 0, 0}); }

TEST(AliasTable, OneEntryIsAlwaysDrawn) {
    for (const double weight : {0.0, 1e-300, 7.0}) expectDraws({weight});
    const std::vector<double> one{3.0};
    const auto draw = AliasTable(one).draw(0.625F);
    EXPECT_EQ(draw.probability, 1.0F);
    EXPECT_FLOAT_EQ(draw.rest, 0.625F);
}

TEST(AliasTable, ManyRandomWeights) {
    RandomStream random(1);
    std::vector<double> weights;
    for (int i = 0; i < 1000; ++i) weights.push_back(i % 7 == 0 ? 0.0 : std::pow(random.uniform(), 4));
    const AliasTable table(weights);
    double sum = 0, total = 0;
    for (const double w : weights) sum += w;
    for (std::uint32_t i = 0; i < 1000; ++i) total += table.probability(i);
    EXPECT_NEAR(total, 1, 1e-5);  // a thousand float roundings of 6e-8
    const auto m = measure(table);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        // Few slots touch one index: those that alias to it, each with a border of a lattice step.
        EXPECT_NEAR(m.share[i], weights[i] / sum, 30.0 / kLattice) << i;
        if (weights[i] == 0) { EXPECT_EQ(m.share[i], 0) << i; }
    }
}

TEST(AliasTable, EmptyIsEmpty) {
    EXPECT_TRUE(AliasTable().empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{}).empty());
}

}  // namespace
}  // namespace luxdeck

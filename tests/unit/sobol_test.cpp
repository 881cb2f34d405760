#include "engine/sampling/sobol.h"

#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

namespace luxdeck {
namespace {

/// The definition, bit by bit: direction numbers of the polynomial x + 1.
std::uint32_t byDirectionNumbers(std::uint32_t index) {
    std::uint32_t value = 0, v = 0x80000000U;
    for (; index != 0; index >>= 1, v ^= v >> 1)
        if ((index & 1) != 0) value ^= v;
    return value;
}

TEST(Sobol, SecondDimensionIsThatOfItsDirectionNumbers) {
    for (std::uint32_t i = 0; i < 1U << 16; ++i) ASSERT_EQ(sobolSecond(i), byDirectionNumbers(i)) << i;
    RandomStream random(1);
    for (int i = 0; i < 1 << 16; ++i) {
        const auto index = static_cast<std::uint32_t>(random.next64());
        ASSERT_EQ(sobolSecond(index), byDirectionNumbers(index)) << index;
    }
}

TEST(Sobol, ReversedBitsAreReversed) {
    for (int bit = 0; bit < 32; ++bit) EXPECT_EQ(reverseBits(1U << bit), 0x80000000U >> bit);
}

// Owen's nested scrambling: what two numbers have in common at the top they keep in common, no more and no less.
TEST(Sobol, ScramblingIsNested) {
    RandomStream random(2);
    for (int i = 0; i < 100'000; ++i) {
        const auto seed = static_cast<std::uint32_t>(random.next64()), x = static_cast<std::uint32_t>(random.next64());
        const auto y = x ^ (static_cast<std::uint32_t>(random.next64()) >> random.below(32));
        ASSERT_EQ(std::countl_zero(owenScramble(x, seed) ^ owenScramble(y, seed)), std::countl_zero(x ^ y));
    }
}

/// The pairs (or single numbers) of one dimension of the first `count` samples.
std::vector<Vec2> pairs(std::uint64_t seed, int dimension, std::uint32_t count) {
    std::vector<Vec2> out;
    for (std::uint32_t i = 0; i < count; ++i) {
        SamplePath path(seed, i);
        for (int d = 0; d < dimension; ++d) path.next1D();
        out.push_back(path.next2D());
    }
    return out;
}

/// Whether every one of the 2^a x 2^b cells holds exactly one of the 2^(a + b) points.
bool onePointACell(const std::vector<Vec2>& points, int a, int b) {
    std::vector<bool> taken(points.size(), false);
    for (const auto& p : points) {
        const auto x = static_cast<std::size_t>(p.x * static_cast<float>(1 << a)), y = static_cast<std::size_t>(p.y * static_cast<float>(1 << b));
        const auto cell = (x << b) + y;
        if (cell >= taken.size() || taken[cell]) return false;
        taken[cell] = true;
    }
    return true;
}

TEST(SamplePath, PairsAreNets) {
    for (std::uint64_t seed = 0; seed < 8; ++seed)
        for (const int dimension : {0, 1, 7, 50})
            for (int m = 0; m <= 10; ++m) {
                const auto points = pairs(streamSeed(3, seed), dimension, 1U << m);
                for (int a = 0; a <= m; ++a)
                    ASSERT_TRUE(onePointACell(points, a, m - a)) << "seed " << seed << " dimension " << dimension << " 2^" << a << " x 2^" << m - a;
            }
}

TEST(SamplePath, SingleNumbersAreStratified) {
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        for (int m = 0; m <= 12; ++m) {
            std::vector<Vec2> points;
            for (std::uint32_t i = 0; i < 1U << m; ++i) {
                SamplePath path(seed, i);
                path.next2D();
                points.emplace_back(path.next1D(), 0.0F);
            }
            ASSERT_TRUE(onePointACell(points, m, 0)) << "seed " << seed << " 2^" << m;
        }
}

TEST(SamplePath, SameSeedAndIndexGiveTheSameNumbers) {
    SamplePath a(7, 9), b(7, 9);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(a.next2D(), b.next2D());
}

/// chi^2 of pairs of numbers against the uniform square of 16 x 16 cells.
template <class Draw>
double squareZ(Draw draw) {
    constexpr int kSide = 16, kCount = 1 << 16;
    std::vector<double> counts(kSide * kSide), expected(kSide * kSide, double{kCount} / (kSide * kSide));
    for (int i = 0; i < kCount; ++i) {
        const Vec2 u = draw(i);
        ++counts[static_cast<std::size_t>(u.x * kSide) * kSide + static_cast<std::size_t>(u.y * kSide)];
    }
    return test::chiSquareZ(counts, expected);
}

// Over many seeds, two streams, two dimensions or the two numbers of a pair must have nothing in common. z < 4 on 255 degrees of freedom: false alarm 3e-5 a line; the seeds are fixed.
TEST(SamplePath, SeedsDimensionsAndPairsAreIndependent) {
    const auto seed = [](int i) { return streamSeed(11, static_cast<std::uint64_t>(i)); };
    EXPECT_LT(squareZ([&](int i) { return SamplePath(seed(i), 0).next2D(); }), 4);
    EXPECT_LT(squareZ([&](int i) { return Vec2(SamplePath(seed(i), 5).next1D(), SamplePath(seed(i + 1), 5).next1D()); }), 4);
    EXPECT_LT(squareZ([&](int i) {
        SamplePath path(seed(i), 3);
        const float first = path.next1D();
        return Vec2(first, path.next1D());
    }), 4);
    EXPECT_LT(squareZ([&](int i) {
        SamplePath path(seed(i), 3);
        const float first = path.next2D().x;
        return Vec2(first, path.next2D().y);
    }), 4);
    // Items and purposes of one seed, as grids and replicates use them.
    EXPECT_LT(squareZ([&](int i) { return Vec2(SamplePath(streamSeed(1, 4, static_cast<std::uint64_t>(i)), 0).next1D(),
                                               SamplePath(streamSeed(1, 5, static_cast<std::uint64_t>(i)), 0).next1D()); }), 4);
}

}  // namespace
}  // namespace luxdeck

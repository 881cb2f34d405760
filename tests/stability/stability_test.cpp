// Every registered algorithm on every stiff and extreme case (analysis/stability): a new algorithm or case joins by
// being registered. Seeds are fixed, so a pass stays a pass; false alarms of a new seed: 2e-4 a case (Student's t, 31 degrees of freedom).

#include "analysis/stability/stability.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <set>

namespace luxdeck::test {
namespace {

struct Pair {
    StabilityCase one;
    Algorithm algorithm;
};

void PrintTo(const Pair& p, std::ostream* out) { *out << p.one.name << " by " << p.algorithm.name; }

std::vector<Pair> pairs() {
    std::vector<Pair> all;
    for (const auto& one : stabilityCases())
        for (const auto& algorithm : algorithms()) all.push_back({one, algorithm});
    return all;
}

class Stability : public testing::TestWithParam<Pair> {};

TEST_P(Stability, CriterionIsMet) {
    const auto r = runStabilityCase(GetParam().one, GetParam().algorithm, 1, Progress{});
    EXPECT_TRUE(r.verdict == StabilityVerdict::Met || r.verdict == StabilityVerdict::KnownLimit)
        << r.lux.value << " +- " << r.lux.ci95 << " lx, expected " << (r.expected.lux ? std::to_string(*r.expected.lux) : r.expected.refusal) << " within "
        << r.expected.slackLux << " lx and four standard errors (" << r.expected.why << ")\n"
        << "rejected " << r.counters.rejected << ", truncated " << r.truncatedFraction() << "\n" << r.refused;
}

std::string nameOf(const testing::TestParamInfo<Pair>& info) {
    std::string name;
    for (const char c : info.param.one.name + " by " + info.param.algorithm.name) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
        else if (!name.empty() && name.back() != '_') name += '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Stability, testing::ValuesIn(pairs()), nameOf);

TEST(StabilityCases, HaveNamesOfTheirOwnAndSaySomeWhy) {
    std::set<std::string> names;
    for (const auto& one : stabilityCases()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_FALSE(one.exact.why.empty() || one.straight.why.empty()) << one.name;
        EXPECT_FALSE(one.sensors.empty()) << one.name;
    }
}

// A limit that is registered for no case would hide nothing and say nothing.
TEST(StabilityCases, AreNamedByEveryLimit) {
    std::set<std::string> names;
    for (const auto& one : stabilityCases()) names.insert(one.name);
    for (const auto& algorithm : algorithms())
        for (const auto& [name, why] : algorithm.limits) {
            EXPECT_TRUE(names.contains(name)) << algorithm.name << ": " << name;
            EXPECT_FALSE(why.empty()) << algorithm.name << ": " << name;
        }
}

// A harness that cannot fail proves nothing: a wrong expectation, a wanted refusal that does not come, noise.
TEST(StabilityCases, FailWhenTheyShould) {
    const auto& path = algorithms().front();
    const auto verdict = [&](const StabilityCase& one) { return runStabilityCase(one, path, 1, Progress{}).verdict; };
    auto one = stabilityCases().front();
    ASSERT_EQ(verdict(one), StabilityVerdict::Met);
    auto wrong = one;
    wrong.exact.lux = *one.exact.lux * 1.1;  // the interval is 2 % at most
    EXPECT_EQ(verdict(wrong), StabilityVerdict::Missed);
    auto accepted = one;
    accepted.exact = {{}, 0, "never lost", ""};
    EXPECT_EQ(verdict(accepted), StabilityVerdict::Missed);
    auto noisy = one;
    noisy.precision = 1e-4, noisy.mostPaths = 512;
    EXPECT_EQ(verdict(noisy), StabilityVerdict::TooNoisy);
    auto refused = one;
    refused.scene = [] { return Result<Scene>(Error{ErrorCode::InvalidArgument, "no", "here"}); };
    EXPECT_EQ(verdict(refused), StabilityVerdict::Missed);
}

// As everywhere: the same bits at any number of threads.
TEST(StabilityCases, DoNotDependOnThreads) {
    const auto& one = stabilityCases().front();
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return runStabilityCase(one, algorithms().front(), 1, Progress{}).lux.value;
    };
    EXPECT_EQ(with(1), with(2));
}

}  // namespace
}  // namespace luxdeck::test

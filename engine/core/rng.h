#pragma once

#include <cstdint>

namespace luxdeck {

/// A well-mixed 64-bit hash. Source: SplitMix64's finaliser (Stafford's variant 13).
constexpr std::uint64_t mix64(std::uint64_t x) {
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9ULL;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

/// The seed of one item's own stream: streams of different items are independent whichever thread
/// computes them, so a result depends on (seed, item) alone.
constexpr std::uint64_t streamSeed(std::uint64_t seed, std::uint64_t item, std::uint64_t purpose = 0) {
    return mix64(mix64(mix64(seed + 0x9e3779b97f4a7c15ULL) ^ (item * 0xd1342543de82ef95ULL + 1)) + purpose);
}

/// A small random stream for work that is not quasi-random (bootstrap, jitter).
class RandomStream {
public:
    explicit constexpr RandomStream(std::uint64_t seed) : state_(mix64(seed)) {}

    constexpr std::uint64_t next64() { return mix64(state_ += 0x9e3779b97f4a7c15ULL); }
    /// Uniform in [0, 1), 53 bits.
    constexpr double uniform() { return static_cast<double>(next64() >> 11) * 0x1.0p-53; }
    /// Uniform in 0 .. count-1, count > 0; bias below 2^-32 for count < 2^32.
    constexpr std::uint64_t below(std::uint64_t count) {
        return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
    }
    /// A standard normal variate.
    double normal();

private:
    std::uint64_t state_;
};

}  // namespace luxdeck

#pragma once

#include "engine/core/rng.h"
#include "engine/core/vec.h"

#include <cstdint>

namespace luxdeck {

constexpr std::uint32_t reverseBits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
    x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
    x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
    x = ((x >> 8) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8);
    return (x >> 16) | (x << 16);
}

/// The second Sobol' dimension of `index`, as a 32-bit fraction. Its generator matrix is Pascal's triangle
/// mod 2, whose product factors into five shifts; the bit-by-bit definition is checked in the tests.
constexpr std::uint32_t sobolSecond(std::uint32_t index) {
    index ^= (index & 0xaaaaaaaaU) >> 1;  // x |-> x + 1 over GF(2), one factor (1 + x)^(2^k) per line
    index ^= (index & 0xccccccccU) >> 2;
    index ^= (index & 0xf0f0f0f0U) >> 4;
    index ^= (index & 0xff00ff00U) >> 8;
    index ^= (index & 0xffff0000U) >> 16;
    return reverseBits(index);
}

/// Nested uniform (Owen) scrambling by hashing: each bit is flipped depending on the seed and all higher
/// bits. Source: Laine & Karras 2011, with the constants of Burley 2020, "Practical Hash-based Owen Scrambling".
constexpr std::uint32_t owenScramble(std::uint32_t x, std::uint32_t seed) {
    x = reverseBits(x);
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return reverseBits(x);
}

constexpr float unitFloat(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1.0p-24F; }

/// One sample path's numbers: padded Owen-scrambled Sobol' pairs. Sample `index` of the set `seed`; every
/// call takes the next pair of dimensions, decorrelated from the others by shuffling the index and
/// scrambling anew. Sets of 2^k consecutive indices from 0 are (0, 2)-nets in every pair.
/// Source: Burley 2020; the structure is pbrt-v4's PaddedSobolSampler.
class SamplePath {
public:
    SamplePath() = default;
    SamplePath(std::uint64_t seed, std::uint32_t index) : seed_(seed), index_(index) {}

    Vec2 next2D() {
        const std::uint64_t h = mix64(seed_ + 0x9e3779b97f4a7c15ULL * ++dimension_);
        const auto low = static_cast<std::uint32_t>(h), high = static_cast<std::uint32_t>(h >> 32);
        const std::uint32_t shuffled = owenScramble(index_, low);
        return {unitFloat(owenScramble(reverseBits(shuffled), high)),
                unitFloat(owenScramble(sobolSecond(shuffled), low ^ (high * 0x9e3779b9U)))};
    }
    float next1D() {
        const std::uint64_t h = mix64(seed_ + 0x9e3779b97f4a7c15ULL * ++dimension_);
        const std::uint32_t shuffled = owenScramble(index_, static_cast<std::uint32_t>(h));
        return unitFloat(owenScramble(reverseBits(shuffled), static_cast<std::uint32_t>(h >> 32)));
    }

    /// The i-th of m samples that together take this one's place in a set of their own.
    [[nodiscard]] SamplePath finer(std::uint32_t m, std::uint32_t i) const {
        return {mix64(seed_ ^ 0x5bd1e9955bd1e995ULL), index_ * m + i};
    }

private:
    std::uint64_t seed_ = 0;
    std::uint32_t index_ = 0;
    std::uint32_t dimension_ = 0;
};

}  // namespace luxdeck

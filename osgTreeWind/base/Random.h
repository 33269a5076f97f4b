// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// The SplitMix64 random number generator (Steele, Lea, Flood 2014). A seed gives the same sequence on every
/// machine, which std::*_distribution does not guarantee.
class Random {
public:
    explicit Random(std::uint64_t seed) : _state(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (_state += 0x9e3779b97f4a7c15ull);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    /// Uniform in [0, 1), 24 bits: exact in a float.
    float uniform() { return static_cast<float>(next() >> 40) * (1.0f / 16777216.0f); }
    /// Uniform in [0, 1), 53 bits: precise enough for map coordinates.
    double uniformDouble() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    /// Uniform in [-1, 1).
    float symmetric() { return 2.0f * uniform() - 1.0f; }

private:
    std::uint64_t _state;
};

} // namespace osgTreeWind

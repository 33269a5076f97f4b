// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace osgTreeWind {

/// The part of a wind's turbulence that is too large for a canopy to make, and lasts minutes: nearly Gaussian
/// noise of mean 0 and variance 1 that travels with the wind. The same seed gives the same noise.
class SlowGusts {
public:
    /// @param mean wind that carries the gusts, m/s, horizontal.
    SlowGusts(std::uint32_t seed, const glm::vec3& mean) : _seed(seed), _mean(mean) {}

    /// The gusts at one time; they can be sampled at any number of places.
    class Now {
    public:
        /// @param place metres. Places within some metres of each other have the same value.
        float at(const glm::vec2& place);

    private:
        friend class SlowGusts;
        static constexpr int octaves = 3;
        std::uint32_t _seed = 0;
        std::array<glm::dvec2, octaves> _offsets; ///< In the lattice of each octave.
        glm::vec2 _cell{0.0f};                    ///< The last place, and its value.
        float _value = 0.0f;
        bool _isKnown = false;
    };
    /// @param time seconds.
    Now at(double time) const;

private:
    std::uint32_t _seed;
    glm::dvec3 _mean;
};

} // namespace osgTreeWind

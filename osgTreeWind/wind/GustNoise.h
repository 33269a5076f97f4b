// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// Three components of noise, and a fourth for the processor's sake.
struct alignas(16) NoisePoint {
    float values[4];
};

/// The turbulence of a wind before it has a size: at each place three numbers of mean 0 and variance 1,
/// nearly Gaussian.
///
/// A sum of octaves of smooth noise, each half as large as the one before, in its own orientation, so that
/// nothing repeats visibly. Its spectrum along a line is flat below the length scale and falls with frequency
/// to the power -5/3 above (Kolmogorov), over two decades with all octaves. One seed gives one noise.
/// Immutable.
class GustNoise {
public:
    static constexpr std::size_t block = 64; ///< The most places at once.
    static constexpr std::size_t mostOctaves = 8;

    /// @param lengthScale integral length scale, metres. @param stretch taken of places before, for scales
    /// that differ with direction.
    /// @param octaves 1 to mostOctaves, the large ones first.
    GustNoise(std::uint32_t seed, double lengthScale, const glm::dmat3& stretch = glm::dmat3(1.0),
              std::size_t octaves = mostOctaves);

    /// The octaves where the noise has travelled to.
    class At;
    At at(const glm::dvec3& travelled) const;

private:
    struct Octave {
        glm::dmat3 toCells; ///< From metres to cells of the noise.
        glm::dvec3 offset;
        float amplitude;
    };

    std::vector<Octave> _octaves;
    struct Lattice;
    std::shared_ptr<const Lattice> _lattice; ///< All noises of one seed share it.
};

/// It, once it has travelled; not longer than that lives.
class GustNoise::At {
public:
    At(const GustNoise& noise, const glm::dvec3& travelled);

    /// @param count at most `block`. @param out one for each place.
    void sample(const WindPlace* places, std::size_t count, NoisePoint* out) const;

private:
    /// From a place in metres, and 1, to each axis of an octave's cells, in floats.
    struct Frame {
        glm::vec4 toCells[3];
        float amplitude;
    };

    const GustNoise& _noise;
    std::array<Frame, mostOctaves> _frames;
};

} // namespace osgTreeWind

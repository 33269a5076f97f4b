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

/// Three components of noise, padded to four for SIMD.
struct alignas(16) NoisePoint {
    float values[4];
};

/// Normalized turbulence: a nearly Gaussian noise field of three components, each of mean 0 and variance 1.
///
/// A sum of octaves of smooth noise, each half as large as the previous one and rotated differently to hide
/// repetition. The spectrum at a place that the noise passes is flat below the wavenumber of the length scale
/// and falls with the power -5/3 above it (Kolmogorov), over two decades with all octaves. Coherence across
/// the wind decays as exp(-8.8 f d / U). Each octave drifts to another side on its way, so that the noise
/// changes as it travels. The same seed gives the same noise. Immutable.
class GustNoise {
public:
    static constexpr std::size_t blockSize = 64; ///< Maximum number of places per Advected::sample().
    static constexpr std::size_t maxOctaves = 8;

    /// @param lengthScale integral length scale along the wind, metres.
    /// @param along horizontal direction of the wind that carries the noise, of length 1; 0: isotropic noise,
    /// which does not change. @param intensity standard deviation of the velocity vector over the speed of
    /// travel. @param octaves 1 to maxOctaves, largest eddies first.
    GustNoise(std::uint32_t seed, double lengthScale, const glm::dvec3& along, double intensity,
              std::size_t octaves = maxOctaves);

    class Advected;
    /// The noise after it has been carried by `travelled`, metres. Keep the GustNoise alive meanwhile.
    Advected advected(const glm::dvec3& travelled) const;

private:
    struct Octave {
        glm::dmat3 toCells; ///< From metres to lattice cells.
        glm::dmat3 passing; ///< From metres travelled to lattice cells passed.
        glm::dvec3 offset;
        float amplitude;
    };

    std::vector<Octave> _octaves;
    struct Lattice;
    std::shared_ptr<const Lattice> _lattice; ///< Shared by all noises of the same seed.
};

/// A GustNoise displaced by the wind that carries it. Must not outlive the GustNoise.
class GustNoise::Advected {
public:
    Advected(const GustNoise& noise, const glm::dvec3& travelled);

    /// @param count at most blockSize. @param out one value for each place.
    void sample(const WindPlace* places, std::size_t count, NoisePoint* out) const;

private:
    /// A displaced octave. Row i of `toCells` maps (x, y, height, 1) in metres to lattice axis i.
    struct Frame {
        glm::vec4 toCells[3];
        float amplitude;
    };

    const GustNoise& _noise;
    std::array<Frame, maxOctaves> _frames;
};

} // namespace osgTreeWind

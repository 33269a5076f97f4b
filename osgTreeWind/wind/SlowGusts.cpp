// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/SlowGusts.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/ValueNoise.h>
#include <osgTreeWind/wind/FiniteVelocity.h>

#include <glm/common.hpp>
#include <glm/mat2x2.hpp>

#include <cmath>

namespace osgTreeWind {

namespace {

/// Integral length, metres. That of the spectrum of ISO 19901-1 (Andersen and Lovseth 2006) at 10 m/s is 1.1
/// km at 10 m above the sea and 1.9 km at 20 m.
constexpr double integralLength = 1500.0;
/// Over the integral length of three octaves, whose variances fall as size^(2/3) (Kolmogorov).
constexpr double largestCell = 2.13 * integralLength;
constexpr float octaveVariances[] = {1.0f, 0.630f, 0.397f};
/// Variance of valueNoise(): a uniform number, interpolated by smoothstep along two axes.
constexpr float noiseVariance = (26.0f / 35.0f) * (26.0f / 35.0f) / 12.0f;
constexpr int period = 256;   // cells
constexpr float step = 32.0f; // places are rounded to it, metres; the speed differs by a hundredth at most

/// From metres to the lattice of an octave; lattices are turned against each other to hide their axes.
glm::dmat2 toLattice(int octave) {
    const double turn = 0.4 + octave, cells = math::pow(2.0, octave) / largestCell;
    return cells * glm::dmat2(math::cos(turn), math::sin(turn), -math::sin(turn), math::cos(turn));
}

/// 0 for a place that no forest reaches.
float cellOf(float place) {
    return std::abs(place) < 1e7f ? std::round(place / step) : 0.0f;
}

const std::array<glm::dmat2, 3> lattices = {toLattice(0), toLattice(1), toLattice(2)};

} // namespace

SlowGusts::Now SlowGusts::at(double time) const {
    Now now;
    now._seed = _seed;
    for (std::size_t i = 0; i < lattices.size(); ++i) {
        const glm::dvec2 offset = lattices[i] * glm::dvec2(_mean * -clampedTime(time, 1e12));
        now._offsets[i] = offset - glm::floor(offset / double(period)) * double(period);
    }
    return now;
}

float SlowGusts::Now::at(const glm::vec2& place) {
    const glm::vec2 cell(cellOf(place.x), cellOf(place.y));
    if (_isKnown && cell == _cell)
        return _value;
    float sum = 0.0f, variance = 0.0f;
    for (std::size_t i = 0; i < lattices.size(); ++i) {
        const glm::vec2 at(lattices[i] * glm::dvec2(cell * step) + _offsets[i]);
        sum += std::sqrt(octaveVariances[i]) *
               (valueNoise(at, glm::ivec2(period), _seed + static_cast<std::uint32_t>(i)) - 0.5f);
        variance += octaveVariances[i];
    }
    _cell = cell;
    _value = sum / std::sqrt(variance * noiseVariance);
    _isKnown = true;
    return _value;
}

} // namespace osgTreeWind

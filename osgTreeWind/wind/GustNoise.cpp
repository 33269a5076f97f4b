// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GustNoise.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/SharedValues.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr int side = 32; // of the lattice, a power of two
constexpr int stride =
    side + 1; // the first points are repeated at the end, so that every cell has all corners
constexpr std::size_t block = GustNoise::blockSize;
constexpr float maxCoordinateOfNoise = 1e7f;
constexpr double octaveRatio = 2.03; // not a simple fraction, so that octaves do not align
/// Mean variance of noise interpolated by smoothstep between two lattice points.
constexpr double smoothVariance = 26.0 / 35.0;
/// Length of eddies over their width: 2 in isotropic turbulence (Batchelor 1953). Coherence across the wind
/// then decays as exp(-8.8 f d / U) (IEC 61400-1:1999; Davenport 1961). The largest eddies are wider, so that
/// this holds up to a separation d of one length scale.
constexpr double lengthOverWidth = 2.0, largestLengthOverWidth = 1.5;
constexpr double halfCoherence = 0.085;           // f d / U at which half of this coherence remains
constexpr double goldenAngle = 2.399963229728653; // spreads the directions of drift

std::vector<NoisePoint> latticeNoise(Random& random) {
    std::vector<NoisePoint> noise(side * side * side), padded;
    for (int component = 0; component < 3; ++component) {
        double sum = 0.0, squares = 0.0;
        for (NoisePoint& point : noise) {
            point.values[component] = random.symmetric();
            sum += point.values[component];
            squares += static_cast<double>(point.values[component]) * point.values[component];
        }
        const double count = static_cast<double>(noise.size()), mean = sum / count;
        const double deviation = std::sqrt(squares / count - mean * mean);
        for (NoisePoint& point : noise)
            point.values[component] = static_cast<float>((point.values[component] - mean) / deviation);
    }
    for (int z = 0; z < stride; ++z)
        for (int y = 0; y < stride; ++y)
            for (int x = 0; x < stride; ++x)
                padded.push_back(
                    noise[static_cast<std::size_t>(((z % side) * side + y % side) * side + x % side)]);
    return padded;
}

/// A uniformly random rotation (Shoemake).
glm::dmat3 randomRotation(Random& random) {
    constexpr double turn = 6.283185307179586;
    const double share = random.uniform(), a = turn * random.uniform(), b = turn * random.uniform();
    const double low = std::sqrt(1.0 - share), high = std::sqrt(share);
    return glm::mat3_cast(
        glm::dquat(high * math::cos(b), low * math::sin(a), low * math::cos(a), high * math::sin(b)));
}

/// Drift of eddies across the wind over the speed of travel. After travelling d, their squared coherence is
/// exp(-a f d / U), a = 8.4 intensity + 0.05 (Simley and Pao 2015): half of the coherence remains at the
/// frequency at which half of it remains across the drift.
double driftOf(double intensity) {
    constexpr double ln2 = 0.6931471805599453;
    return halfCoherence / (2.0 * ln2) * (8.4 * intensity + 0.05);
}

NoisePoint lerp(const NoisePoint& low, const NoisePoint& high, float share) {
    NoisePoint result;
    for (int i = 0; i < 4; ++i)
        result.values[i] = low.values[i] + (high.values[i] - low.values[i]) * share;
    return result;
}

/// A block of places as one array per axis (x, y, height), for SIMD.
struct Positions {
    float axis[3][block];
};

/// Positions in the lattice of one octave.
struct Cells {
    int corner[3][block];  ///< Lower corner of the cell.
    float share[3][block]; ///< Weight of the upper corner, by smoothstep.
};

/// Computes one axis of the Cells.
void locate(const Positions& near, std::size_t count, const glm::vec4& toCells, int* corner, float* share) {
    const float *x = near.axis[0], *y = near.axis[1], *z = near.axis[2];
    const float a = toCells.x, b = toCells.y, c = toCells.z, offset = toCells.w;
    for (std::size_t n = 0; n < count; ++n) {
        const float place = a * x[n] + b * y[n] + c * z[n] + offset;
        const int towardZero = static_cast<int>(place);
        const int cell = towardZero - (place < static_cast<float>(towardZero) ? 1 : 0);
        const float t = place - static_cast<float>(cell);
        corner[n] = cell & (side - 1);
        share[n] = t * t * (3.0f - 2.0f * t);
    }
}

/// Adds the noise at these positions, times a factor.
void addNoise(const NoisePoint* noise, const Cells& cells, std::size_t count, float factor,
              NoisePoint* sums) {
    for (std::size_t n = 0; n < count; ++n) {
        const NoisePoint* corner =
            noise + (cells.corner[2][n] * stride + cells.corner[1][n]) * stride + cells.corner[0][n];
        const float x = cells.share[0][n], y = cells.share[1][n], z = cells.share[2][n];
        constexpr int north = stride, up = stride * stride;
        const NoisePoint low =
            lerp(lerp(corner[0], corner[1], x), lerp(corner[north], corner[north + 1], x), y);
        const NoisePoint high =
            lerp(lerp(corner[up], corner[up + 1], x), lerp(corner[up + north], corner[up + north + 1], x), y);
        const NoisePoint all = lerp(low, high, z);
        for (int i = 0; i < 4; ++i)
            sums[n].values[i] += factor * all.values[i];
    }
}

float clampedCoordinate(float x) {
    return x >= -maxCoordinateOfNoise ? std::min(x, maxCoordinateOfNoise)
           : x < 0.0f                 ? -maxCoordinateOfNoise
                                      : 0.0f;
}

} // namespace

struct GustNoise::Lattice {
    explicit Lattice(std::uint32_t seed) : random(seed), points(latticeNoise(random)) {}

    Random random;                  ///< State after the points were drawn.
    std::vector<NoisePoint> points; ///< Mean 0 and variance 1 in each component.

    static std::shared_ptr<const Lattice> shared(std::uint32_t seed) {
        static SharedConstants<std::uint32_t, Lattice> lattices;
        return lattices.get(seed, [&] { return std::make_shared<const Lattice>(seed); });
    }
};

GustNoise::GustNoise(std::uint32_t seed, double lengthScale, const glm::dvec3& along, double intensity,
                     std::size_t octaves)
    : _lattice(Lattice::shared(seed)) {
    Random random = _lattice->random;

    // Variance is proportional to cell size^(2/3). The length scale of an octave is its cell size /
    // (2 smoothVariance).
    double variance = 0.0, lengths = 0.0;
    for (int i = 0; i < static_cast<int>(octaves); ++i) {
        variance += math::pow(octaveRatio, -2.0 / 3.0 * i);
        lengths += math::pow(octaveRatio, -5.0 / 3.0 * i);
    }
    const double largest = lengthScale * 2.0 * smoothVariance * variance / lengths;
    const bool isIsotropic = along == glm::dvec3(0.0);
    // Eddies drift aside. They are shorter and slower for that, so that neither the spectrum at a place nor
    // the delay between places along the wind changes.
    const double slant = lengthOverWidth * driftOf(intensity), shorter = std::sqrt(1.0 + slant * slant);
    const double firstAngle = 6.283185307179586 * random.uniform();
    for (int i = 0; i < static_cast<int>(octaves); ++i) {
        Octave& octave = _octaves.emplace_back();
        const double width = i == 0 ? largestLengthOverWidth : lengthOverWidth;
        const double angle = firstAngle + goldenAngle * i;
        const glm::dvec3 aside(-along.y * math::cos(angle), along.x * math::cos(angle), math::sin(angle));
        const glm::dmat3 scale = randomRotation(random) * (math::pow(octaveRatio, i) / largest);
        if (isIsotropic) {
            octave.toCells = octave.passing = scale;
        } else {
            octave.toCells =
                scale * (glm::dmat3(width) + (shorter - width) * glm::outerProduct(along, along));
            octave.passing = scale * glm::outerProduct((along + slant * aside) / shorter, along);
        }
        octave.offset = {side * random.uniform(), side * random.uniform(), side * random.uniform()};
        octave.amplitude = static_cast<float>(math::pow(octaveRatio, -1.0 / 3.0 * i) /
                                              std::sqrt(variance * math::pow(smoothVariance, 3)));
    }
}

GustNoise::Advected GustNoise::advected(const glm::dvec3& travelled) const {
    return Advected(*this, travelled);
}

GustNoise::Advected::Advected(const GustNoise& noise, const glm::dvec3& travelled) : _noise(noise) {
    for (std::size_t i = 0; i < noise._octaves.size(); ++i) {
        const Octave& octave = noise._octaves[i];
        const glm::dvec3 start = octave.offset - octave.passing * travelled;
        const glm::dvec3 offset = start - glm::floor(start / double(side)) * double(side);
        const glm::dmat3 axes = glm::transpose(octave.toCells);
        for (int axis = 0; axis < 3; ++axis)
            _frames[i].toCells[axis] = glm::vec4(axes[axis], offset[axis]);
        _frames[i].amplitude = octave.amplitude;
    }
}

void GustNoise::Advected::sample(const WindPlace* places, std::size_t count, NoisePoint* out) const {
    Positions near = {};
    Cells cells;
    for (std::size_t n = 0; n < count; ++n) {
        near.axis[0][n] = clampedCoordinate(places[n].position.x);
        near.axis[1][n] = clampedCoordinate(places[n].position.y);
        near.axis[2][n] = clampedCoordinate(places[n].height);
        out[n] = {};
    }
    for (std::size_t i = 0; i < _noise._octaves.size(); ++i) {
        const Frame& frame = _frames[i];
        for (int axis = 0; axis < 3; ++axis)
            locate(near, count, frame.toCells[axis], cells.corner[axis], cells.share[axis]);
        addNoise(_noise._lattice->points.data(), cells, count, frame.amplitude, out);
    }
}

} // namespace osgTreeWind

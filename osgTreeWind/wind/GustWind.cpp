// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GustWind.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr int side = 32; // of the lattice, a power of two
constexpr float farthest = 1e7f;
constexpr double octaveRatio = 2.03; // not a fraction of small numbers
/// Mean variance of noise between two lattice points, under smoothstep.
constexpr double smoothVariance = 26.0 / 35.0;

std::vector<NoisePoint> latticeNoise(Random& random) {
    std::vector<NoisePoint> noise(side * side * side);
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
    return noise;
}

/// A uniformly random rotation (Shoemake).
glm::dmat3 randomRotation(Random& random) {
    constexpr double turn = 6.283185307179586;
    const double share = random.uniform(), a = turn * random.uniform(), b = turn * random.uniform();
    const double low = std::sqrt(1.0 - share), high = std::sqrt(share);
    return glm::mat3_cast(
        glm::dquat(high * std::cos(b), low * std::sin(a), low * std::cos(a), high * std::sin(b)));
}

/// One octave at one time: from a place in metres to cells, in floats.
struct Frame {
    glm::mat3 toCells;
    glm::vec3 offset;
    float amplitude;
};

glm::vec3 smooth(const glm::vec3& t) {
    return t * t * (3.0f - 2.0f * t);
}

NoisePoint lerp(const NoisePoint& low, const NoisePoint& high, float share) {
    NoisePoint result;
    for (int i = 0; i < 4; ++i)
        result.values[i] = low.values[i] + (high.values[i] - low.values[i]) * share;
    return result;
}

/// Adds the noise at a place in cells, times a factor.
void addNoise(const NoisePoint* noise, const glm::vec3& place, float factor, NoisePoint& sum) {
    glm::ivec3 cell(place);
    cell -= glm::ivec3(place.x < static_cast<float>(cell.x), place.y < static_cast<float>(cell.y),
                       place.z < static_cast<float>(cell.z));
    const glm::vec3 w = smooth(place - glm::vec3(cell));
    constexpr int mask = side - 1;
    const int x0 = cell.x & mask, x1 = (cell.x + 1) & mask;
    const int y0 = (cell.y & mask) * side, y1 = ((cell.y + 1) & mask) * side;
    const int z0 = (cell.z & mask) * side * side, z1 = ((cell.z + 1) & mask) * side * side;
    const NoisePoint a = lerp(noise[z0 + y0 + x0], noise[z0 + y0 + x1], w.x);
    const NoisePoint b = lerp(noise[z0 + y1 + x0], noise[z0 + y1 + x1], w.x);
    const NoisePoint c = lerp(noise[z1 + y0 + x0], noise[z1 + y0 + x1], w.x);
    const NoisePoint d = lerp(noise[z1 + y1 + x0], noise[z1 + y1 + x1], w.x);
    const NoisePoint all = lerp(lerp(a, b, w.y), lerp(c, d, w.y), w.z);
    for (int i = 0; i < 4; ++i)
        sum.values[i] += factor * all.values[i];
}

glm::vec3 held(const glm::vec3& position) {
    const auto one = [](float x) {
        return x >= -farthest ? std::min(x, farthest) : x < 0.0f ? -farthest : 0.0f;
    };
    return {one(position.x), one(position.y), one(position.z)};
}

} // namespace

Result<std::shared_ptr<const GustWind>> GustWind::create(const Parameters& parameters) {
    Diagnostics problems;
    const auto check = [&](const char* key, double value, double low, double high, const char* what) {
        if (!(value >= low && value <= high))
            problems.push_back(
                {{}, 0, 0, key, std::string("expected ") + what + ", found " + numberText(value)});
    };
    check("mean", glm::length(glm::dvec3(parameters.mean)), 0.0, maxMeasuredSpeed, "at most 200 m/s");
    check("mean", parameters.mean.z, 0.0, 0.0, "a horizontal wind");
    check("intensity", parameters.intensity, 0.0, 1.0, "0 to 1");
    check("lengthScale", parameters.lengthScale, 1.0, 1e5, "1 to 100000 m");
    if (parameters.profile && !parameters.profile->valid())
        problems.push_back({{}, 0, 0, "profile", "expected 0 < roughness < height in metres"});
    if (!problems.empty())
        return problems;
    return std::shared_ptr<const GustWind>(new GustWind(parameters));
}

GustWind::GustWind(const Parameters& parameters) : _parameters(parameters) {
    Random random(parameters.seed);
    _noise = latticeNoise(random);

    // Variance falls with the cell to the power 2/3. An octave's own length scale is cell / (2
    // smoothVariance).
    double variance = 0.0, lengths = 0.0;
    for (int i = 0; i < octaves; ++i) {
        variance += std::pow(octaveRatio, -2.0 / 3.0 * i);
        lengths += std::pow(octaveRatio, -5.0 / 3.0 * i);
    }
    const double largest = parameters.lengthScale * 2.0 * smoothVariance * variance / lengths;
    for (int i = 0; i < octaves; ++i) {
        Octave& octave = _octaves[static_cast<std::size_t>(i)];
        octave.toCells = randomRotation(random) * (std::pow(octaveRatio, i) / largest);
        octave.offset = {side * random.uniform(), side * random.uniform(), side * random.uniform()};
        octave.amplitude = static_cast<float>(std::pow(octaveRatio, -1.0 / 3.0 * i) /
                                              std::sqrt(variance * std::pow(smoothVariance, 3)));
    }

    const float speed = glm::length(parameters.mean);
    const glm::vec3 along = speed > 0.0f ? parameters.mean / speed : glm::vec3(0.0f);
    const float deviation = static_cast<float>(parameters.intensity) * speed;
    _axes = {along * deviation, glm::vec3(-along.y, along.x, 0.0f) * (0.8f * deviation),
             glm::vec3(0.0f, 0.0f, 0.5f * deviation)};
}

glm::vec3 GustWind::velocity(const glm::vec3& position, double time) const {
    glm::vec3 result;
    sample(&position, 1, time, &result);
    return result;
}

void GustWind::sample(const glm::vec3* positions, std::size_t count, double time, glm::vec3* out) const {
    const glm::dvec3 travelled =
        glm::dvec3(_parameters.mean) * (std::isfinite(time) ? glm::clamp(time, -1e12, 1e12) : 0.0);
    std::array<Frame, octaves> frames;
    for (std::size_t i = 0; i < octaves; ++i) {
        const glm::dvec3 cells = _octaves[i].offset - _octaves[i].toCells * travelled;
        frames[i] = {_octaves[i].toCells, cells - glm::floor(cells / double(side)) * double(side),
                     _octaves[i].amplitude};
    }
    for (std::size_t n = 0; n < count; ++n) {
        const glm::vec3 place = held(positions[n]);
        NoisePoint turbulence{};
        for (const Frame& frame : frames)
            addNoise(_noise.data(), frame.toCells * place + frame.offset, frame.amplitude, turbulence);
        const float* u = turbulence.values;
        const float factor =
            _parameters.profile ? static_cast<float>(_parameters.profile->factor(place.z)) : 1.0f;
        out[n] = (_parameters.mean + _axes * glm::vec3(u[0], u[1], u[2])) * factor;
    }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/CanopyFlow.h>

#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/SwingingWind.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr float maxSpeedAbove = 1e4f; // m/s

} // namespace

/// The horizontal part of a wind. NaN and more than 10 km/s count as calm; a calm points east.
struct CanopyFlow::HorizontalWind {
    float speed = 0.0f;
    glm::vec3 along{1.0f, 0.0f, 0.0f};

    HorizontalWind() = default;
    explicit HorizontalWind(const glm::vec3& wind) : speed(std::sqrt(wind.x * wind.x + wind.y * wind.y)) {
        if (!(speed <= maxSpeedAbove))
            speed = 0.0f;
        if (speed > 1e-6f)
            along = glm::vec3(wind.x / speed, wind.y / speed, 0.0f);
    }
};

namespace {

/// Gusts travel at 1.8 U(h) (Raupach, Finnigan and Brunet 1996); those 1.8 h long take h / U(h) to pass.
constexpr float gustSpeedRatio = 1.8f;
/// Down to 1/17 of the largest gusts: a quarter of the tree height along the wind.
constexpr std::size_t octaves = 5;
/// Standard deviation over u* of the gusts that are too large for a canopy to make: that of the surface layer
/// less that at the canopy top, sqrt(2.4^2 - 1.8^2). They scale the smaller ones (Perret and Patton 2021).
constexpr float slowDeviation = 1.5875f;
/// Correlation of the components along the wind and down within the canopy: that at the top, without slow
/// gusts.
constexpr float uwInCanopy = 1.0f / (1.8f * 1.1f);

WindPlace raisedTo(const WindPlace& place, float height) {
    WindPlace raised = place;
    raised.position.z += height - place.height;
    raised.height = height;
    return raised;
}

/// Horizontal mean over an hour.
glm::vec3 hourlyMean(const WindField& wind, float reference) {
    constexpr int samples = 60;
    glm::vec3 sum(0.0f);
    for (int i = 0; i < samples; ++i) {
        const glm::vec3 velocity = wind.velocity(WindPlace(0.0f, 0.0f, reference), 60.0 * i);
        if (glm::length(glm::vec2(velocity)) <= maxSpeedAbove)
            sum += glm::vec3(velocity.x, velocity.y, 0.0f);
    }
    return sum / static_cast<float>(samples);
}

/// Slow gusts over the mean wind, at twice the height of the canopy.
float slowIntensity(const CanopyProfile& profile) {
    const float above = profile.friction > 0.0f ? profile.mean(2.0f * profile.height) : 1.0f;
    return slowDeviation * profile.friction / above;
}

/// Standard deviation of the velocity vector at the top over the speed of gusts.
double intensityOfGusts(const CanopyProfile& profile) {
    const WindSpread top = profile.spread(profile.height);
    return static_cast<double>(glm::length(glm::vec3(top.along, top.across, top.up)) / gustSpeedRatio);
}

/// Table of SwingingWinds below the canopy top by turbulence intensity: mean, deviation and skewness of the
/// speed over the mean wind, and swing. Computing them for each sample would dominate the cost.
class SwingingWindTable {
public:
    SwingingWindTable() {
        const CanopyProfile profile = CanopyProfile::ofStand(1.0f, 1.0f);
        const WindSpread top = profile.spread(1.0f);
        for (std::size_t i = 0; i < _winds.size(); ++i) {
            const float part = std::max(step * static_cast<float>(i), 0.01f) / top.along;
            const SwingingWind wind(1.0f, {part * top.along, part * top.across, part * top.up},
                                    profile.skewness(1.0f));
            _winds[i] = {wind.mean, wind.deviation, wind.skewness, wind.swing()};
        }
    }

    glm::vec4 at(float intensity) const {
        const float position = std::min(intensity / step, static_cast<float>(_winds.size()) - 1.01f);
        const auto low = static_cast<std::size_t>(position);
        return glm::mix(_winds[low], _winds[low + 1], position - static_cast<float>(low));
    }

private:
    static constexpr float step = 1.0f / 32.0f;
    std::array<glm::vec4, 320> _winds; ///< Up to intensity 10, at the ground under the densest crowns.
};

const SwingingWindTable swingingWinds;

/// Skews nearly Gaussian noise of mean 0 and variance 1: to a gamma distribution (Wilson and Hilferty 1931)
/// of the same mean and variance.
float skewed(float noise, float skewness) {
    const float s = std::max(skewness, 0.01f), root = 1.0f - s * s / 36.0f + s / 6.0f * noise;
    return (root * root * root - 1.0f) * 2.0f / s;
}

} // namespace

CanopyFlow::CanopyFlow(WindFieldPtr open, WindFieldPtr mean, std::shared_ptr<const CanopyMap> map,
                       std::uint32_t seed)
    : _open(std::move(open)), _mean(std::move(mean)), _map(std::move(map)),
      _meanWind(hourlyMean(*_mean, _map->reference)),
      _gustVelocity(_meanWind * (gustSpeedRatio * _map->usual.topSpeedRatio)),
      _noise(seed, static_cast<double>(gustSpeedRatio * std::max(_map->usual.profile.height, 1.0f)),
             HorizontalWind(_gustVelocity).along, intensityOfGusts(_map->usual.profile), octaves),
      _slowGusts(seed, _meanWind),
      _slowIntensity(_open == _mean ? 0.0f : slowIntensity(_map->usual.profile)) {}

CanopySample CanopyFlow::standUpwindOf(const glm::vec3& place, const HorizontalWind& wind) const {
    return _map->at(glm::vec2(place - _map->fetch * wind.along), _map->usual.topSpeedRatio * wind.speed);
}

NeighbourEffect CanopyFlow::neighbourEffectAt(const glm::vec2& place) const {
    const CanopySample stand = standUpwindOf(glm::vec3(place, 0.0f), HorizontalWind(_meanWind));
    return {_map->crownCoverAt(place), 1.0f - stand.closure * (1.0f - stand.shelter)};
}

/// @param given the wind at the reference.
glm::vec3 CanopyFlow::windAmongTrees(const CanopySample& stand, const WindPlace& place,
                                     const HorizontalWind& given, const NoisePoint& noise) const {
    const CanopyProfile& profile = stand.profile;
    const float z = place.height, skewness = profile.skewness(z), mean = profile.mean(z);
    const WindSpread spread = profile.spread(z);
    glm::vec4 wind; // mean, deviation and skewness of the speed, and swing
    if (z <= profile.height) {
        wind = swingingWinds.at(spread.along / mean);
        wind.x *= mean;
        wind.y *= mean;
    } else {
        const SwingingWind above(mean, spread, skewness);
        wind = {above.mean, above.deviation, above.skewness, above.swing()};
    }
    // Slow gusts are a part of the turbulence; they scale the rest, too.
    const float slow = std::min(_slowIntensity * mean / spread.along, 0.9f);
    const float scaling = 1.0f + _slowIntensity * _slowIntensity;
    const float quick = std::sqrt((1.0f - slow * slow) / scaling);
    const float speed = wind.x + quick * wind.y * skewed(noise.values[0], wind.z);
    const float angle = wind.w * noise.values[1];
    const float whole =
        std::min(uwInCanopy, profile.friction * profile.friction / (spread.along * spread.up));
    const float uw = std::min(whole / (quick * scaling), 1.0f);
    const float down = skewed(uw * noise.values[0] + std::sqrt(1.0f - uw * uw) * noise.values[2], skewness);
    float factor = given.speed * stand.topSpeedRatio;
    if (place.inCrown) { // shelter fades out to half a height above the canopy
        const float free = std::clamp(2.0f * (z / profile.height - 1.0f), 0.0f, 1.0f);
        factor *= stand.shelter + (1.0f - stand.shelter) * free;
    }
    const glm::vec3 left(-given.along.y, given.along.x, 0.0f);
    return factor * (speed * (std::cos(angle) * given.along + std::sin(angle) * left) -
                     glm::vec3(0.0f, 0.0f, spread.up * down));
}

void CanopyFlow::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    const GustNoise::Advected noise = _noise.advected(glm::dvec3(_gustVelocity) * clampedTime(time, 1e12));
    SlowGusts::Now slow = _slowGusts.at(time);
    constexpr std::size_t block = GustNoise::blockSize;
    WindPlace raised[block];
    glm::vec3 given[block];
    HorizontalWind level[block];
    CanopySample stands[block];
    NoisePoint turbulence[block];
    for (std::size_t first = 0; first < count; first += block) {
        const std::size_t size = std::min(count - first, block);
        for (std::size_t n = 0; n < size; ++n)
            raised[n] = raisedTo(places[first + n], _map->reference);
        _mean->sample(raised, size, time, given);
        for (std::size_t n = 0; _slowIntensity > 0.0f && n < size; ++n)
            given[n] *=
                std::max(1.0f + _slowIntensity * slow.at(glm::vec2(places[first + n].position)), 0.0f);
        bool open = false, closed = false;
        for (std::size_t n = 0; n < size; ++n) {
            level[n] = n > 0 && given[n] == given[n - 1] ? level[n - 1] : HorizontalWind(given[n]);
            stands[n] = standUpwindOf(places[first + n].position, level[n]);
            open |= stands[n].closure < 1.0f;
            closed |= stands[n].closure > 0.0f;
        }
        if (open)
            _open->sample(places + first, size, time, out + first);
        if (closed)
            noise.sample(places + first, size, turbulence);
        for (std::size_t n = 0; n < size; ++n) {
            const float closure = stands[n].closure;
            if (closure > 0.0f) {
                const glm::vec3 v = windAmongTrees(stands[n], places[first + n], level[n], turbulence[n]);
                out[first + n] = closure < 1.0f ? glm::mix(out[first + n], v, closure) : v;
            }
        }
    }
}

} // namespace osgTreeWind

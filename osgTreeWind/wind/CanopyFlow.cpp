// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/CanopyFlow.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/SwingingWind.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <utility>

namespace osgTreeWind {

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
constexpr float uwInCanopy = 1.0f / (spreadAtTop.along * spreadAtTop.up);

WindPlace raisedTo(const WindPlace& place, float height) {
    WindPlace raised = place;
    raised.position.z += height - place.height;
    raised.height = height;
    return raised;
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

/// Skews nearly Gaussian noise of mean 0 and variance 1: to a gamma distribution (Wilson and Hilferty 1931)
/// of the same mean and variance.
float skewed(float noise, float skewness) {
    const float s = std::max(skewness, 0.01f), root = 1.0f - s * s / 36.0f + s / 6.0f * noise;
    return (root * root * root - 1.0f) * 2.0f / s;
}

std::uint64_t nextNumber() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace

CanopyFlow::CanopyFlow(WindFieldPtr open, WindFieldPtr mean, std::shared_ptr<const CanopyMap> map,
                       std::uint32_t seed)
    : _open(std::move(open)), _mean(std::move(mean)), _map(std::move(map)),
      _meanWind(hourlyMean(*_mean, _map->reference)),
      _gustVelocity(_meanWind * (gustSpeedRatio * _map->usual.topSpeedRatio)),
      _noise(seed, static_cast<double>(gustSpeedRatio * std::max(_map->usual.profile.height, 1.0f)),
             HorizontalWind(_gustVelocity).along, intensityOfGusts(_map->usual.profile), octaves),
      _slowGusts(seed, _meanWind), _number(nextNumber()),
      _slowIntensity(_open == _mean ? 0.0f : slowIntensity(_map->usual.profile)) {}

/// Mean wind at the top of the usual stand, m/s.
float CanopyFlow::topSpeedOf(const HorizontalWind& wind) const {
    return _map->usual.topSpeedRatio * wind.speed;
}

CanopySample CanopyFlow::standUpwindOf(const glm::vec3& place, const HorizontalWind& wind) const {
    return _map->at(glm::vec2(place - _map->fetch * wind.along), topSpeedOf(wind));
}

NeighbourEffect CanopyFlow::neighbourEffectAt(const glm::vec2& place) const {
    const HorizontalWind wind(_meanWind);
    const CanopySample stand = standUpwindOf(glm::vec3(place, 0.0f), wind);
    const float shelter = CanopySpeedStep(topSpeedOf(wind)).mix(stand.shelter);
    return {_map->crownCoverAt(place), 1.0f - stand.closure * (1.0f - shelter)};
}

PlaceInStand CanopyFlow::placeInStand(const WindPlace& place, const HorizontalWind& wind) const {
    const CanopySample stand = standUpwindOf(place.position, wind);
    PlaceInStand result;
    result.closure = stand.closure;
    if (!(stand.closure > 0.0f))
        return result;
    const CanopyProfile& profile = stand.profile;
    const float z = place.height, skewness = profile.skewness(z), mean = profile.mean(z);
    const WindSpread spread = profile.spread(z);
    const SwingingWind wholeWind(mean, spread, skewness);
    // Slow gusts are a part of the turbulence; they scale the rest, too.
    const float slow = std::min(_slowIntensity * mean / spread.along, 0.9f);
    const float scaling = 1.0f + _slowIntensity * _slowIntensity;
    const float quick = std::sqrt((1.0f - slow * slow) / scaling);
    const float whole =
        std::min(uwInCanopy, profile.friction * profile.friction / (spread.along * spread.up));
    result.mean = stand.topSpeedRatio * wholeWind.mean;
    result.deviation = stand.topSpeedRatio * quick * wholeWind.deviation;
    result.skewness = wholeWind.skewness;
    result.swing = wholeWind.swing();
    result.down = stand.topSpeedRatio * spread.up;
    result.downSkewness = skewness;
    result.downBySpeed = std::min(whole / (quick * scaling), 1.0f);
    result.downByItself = std::sqrt(1.0f - result.downBySpeed * result.downBySpeed);
    if (place.inCrown) // shelter fades out to half a height above the canopy
        result.shelter = glm::mix(stand.shelter, glm::vec2(1.0f),
                                  std::clamp(2.0f * (z / profile.height - 1.0f), 0.0f, 1.0f));
    return result;
}

/// placeInStand(), from WindPlace::stand if it is still the same.
PlaceInStand CanopyFlow::keptPlaceInStand(const WindPlace& place, const HorizontalWind& wind) const {
    if (!place.stand)
        return placeInStand(place, wind);
    std::uint64_t key = _number;
    const auto add = [&key](auto value) {
        std::uint32_t bits;
        static_assert(sizeof bits == sizeof value);
        std::memcpy(&bits, &value, sizeof bits);
        key = (key ^ bits) * 0x9e3779b97f4a7c15u;
        key ^= key >> 32;
    };
    add(place.position.x);
    add(place.position.y);
    add(place.height);
    add(wind.along.x);
    add(wind.along.y);
    add(2u * static_cast<std::uint32_t>(CanopySpeedStep(topSpeedOf(wind)).low) + (place.inCrown ? 1u : 0u));
    if (place.stand->key != key) {
        *place.stand = placeInStand(place, wind);
        place.stand->key = key;
    }
    return *place.stand;
}

namespace {

/// @param given the wind at the reference, of this speed and direction.
glm::vec3 windAmongTrees(const PlaceInStand& stand, float given, const glm::vec3& along, float shelter,
                         const NoisePoint& noise) {
    const float speed = stand.mean + stand.deviation * skewed(noise.values[0], stand.skewness);
    const float angle = stand.swing * noise.values[1];
    const float down =
        stand.down * skewed(stand.downBySpeed * noise.values[0] + stand.downByItself * noise.values[2],
                            stand.downSkewness);
    const glm::vec3 left(-along.y, along.x, 0.0f);
    return given * shelter *
           (speed * (math::cos(angle) * along + math::sin(angle) * left) - glm::vec3(0.0f, 0.0f, down));
}

} // namespace

void CanopyFlow::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    const GustNoise::Advected noise = _noise.advected(glm::dvec3(_gustVelocity) * clampedTime(time, 1e12));
    SlowGusts::Now slow = _slowGusts.at(time);
    constexpr std::size_t block = GustNoise::blockSize;
    WindPlace raised[block];
    glm::vec3 given[block];
    HorizontalWind level[block];
    PlaceInStand stands[block];
    NoisePoint turbulence[block];
    for (std::size_t first = 0; first < count; first += block) {
        const std::size_t size = std::min(count - first, block);
        for (std::size_t n = 0; n < size; ++n)
            raised[n] = raisedTo(places[first + n], _map->reference);
        _mean->sample(raised, size, time, given);
        bool open = false, closed = false;
        HorizontalWind steady;
        for (std::size_t n = 0; n < size; ++n) {
            if (n == 0 || given[n] != given[n - 1])
                steady = HorizontalWind(given[n]);
            level[n] = steady;
            if (_slowIntensity > 0.0f)
                level[n].speed *=
                    std::max(1.0f + _slowIntensity * slow.at(glm::vec2(places[first + n].position)), 0.0f);
            stands[n] = keptPlaceInStand(places[first + n], level[n]);
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
                const float shelter = CanopySpeedStep(topSpeedOf(level[n])).mix(stands[n].shelter);
                const glm::vec3 v =
                    windAmongTrees(stands[n], level[n].speed, level[n].along, shelter, turbulence[n]);
                out[first + n] = closure < 1.0f ? glm::mix(out[first + n], v, closure) : v;
            }
        }
    }
}

} // namespace osgTreeWind

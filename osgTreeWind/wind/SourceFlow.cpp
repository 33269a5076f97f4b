// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/SourceFlow.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/wind/BlastWave.h>
#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/GustNoise.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

constexpr double standardDensity = 1.225; // kg/m^3, standard atmosphere at sea level
constexpr double maxReach = 1e6;          // metres
constexpr double maxSourceTime = 1e9;     // seconds
constexpr double minSpeed = 0.2;          // m/s, the upper limit of Beaufort 0
constexpr double eddyViscosity = 0.08;    // over maximum speed times half width of a wake: 1 / 12.5
constexpr double lambOseen = 1.25643;     // position of the maximum speed of a Lamb-Oseen vortex
constexpr double jetWidthRatio = 0.5; // radius beyond which a jet is negligible, over the distance travelled

// A round turbulent jet (Pope 2000, 5.1): U0/UJ = B d / (x - x0), half of it at S (x - x0) from the axis.
constexpr double decay = 5.8, spreading = 0.094, virtualOrigin = 4.0; // the last in diameters

/// Induced velocity v of a rotor in a crosswind, m/s: v sqrt(crosswind^2 + v^2) is v^2 of a calm (Glauert).
double inducedSpeed(const WindSource& rotor, double crosswind = 0.0) {
    const double calm2 =
        rotor.thrust / (2.0 * standardDensity * glm::pi<double>() * rotor.radius * rotor.radius);
    const double half = 0.5 * crosswind * crosswind;
    return calm2 > 0.0 ? calm2 / std::sqrt(half + glm::length(glm::dvec2(half, calm2))) : 0.0;
}

/// Horizontal drift of the column at a depth below its rotor, for a crosswind as fast as the induced
/// velocity: the integral of 1 / (1 + s / hypot(s, radius)).
double columnDrift(double depth, double radius) {
    if (!(depth > 0.0))
        return 0.0;
    const double q = depth / radius, h = glm::length(glm::dvec2(q, 1.0));
    // q - (h^3 - 1 - q^3) / 3, without cancellation
    return radius * (q - ((h * h + h * q + q * q) / (h + q) - 1.0) / 3.0);
}

/// Speed on the axis over that at the mouth. @param x distance from the mouth in diameters.
double axisSpeedRatio(double x) {
    return std::min(decay / std::max(x - virtualOrigin, decay), 1.0);
}

/// Smoothed top-hat profile near the mouth: 1 on the axis, with the momentum of a top hat of radius 1.
/// @param r distance from the axis over the radius of the mouth.
double topHat(double r) {
    constexpr double width = 1.0957; // the square over the area of 1 / (1 + q^8) is 0.8330
    const double q = std::min(r / width, 1e3), q2 = q * q, q4 = q2 * q2;
    return 1.0 / (1.0 + q4 * q4);
}

/// 1 below `height`, 0 above 1.2 `height`.
double fadeAbove(double z, double height) {
    return 1.0 - glm::smoothstep(height, 1.2 * height, z);
}

glm::dvec2 outwardDirection(const glm::dvec3& offset, double r) {
    return r > 1e-9 ? glm::dvec2(offset) / r : glm::dvec2(0.0);
}

} // namespace

SourceFlow::SourceFlow(const WindSource& source) : _source(clampedKeys(source)) {
    constexpr double minSize = 0.001; // metres
    _source.radius = std::max(_source.radius, minSize);
    _source.height = std::max(_source.height, minSize);
    const double toward = static_cast<double>(_source.toward), up = static_cast<double>(_source.elevation);
    _axis = {math::sin(toward) * math::cos(up), math::cos(toward) * math::cos(up), math::sin(up)};
    if (_source.kind == WindSource::Kind::Vehicle) {
        const double speed = glm::length(glm::dvec2(_source.velocity));
        _axis = speed > 0.0 ? glm::dvec3(glm::dvec2(_source.velocity) / speed, 0.0) : glm::dvec3(0.0);
        _eddyVelocity = -_source.velocity; // eddies stay where they formed
    } else if (_source.kind == WindSource::Kind::Explosion) {
        _source.velocity = glm::dvec3(0.0);
        _source.turbulence = 0.0;
    } else if (_source.kind == WindSource::Kind::Jet)
        _eddyVelocity = 0.5 * _source.speed * _axis;
    else if (_source.kind == WindSource::Kind::Rotor)
        _eddyVelocity.z = -inducedSpeed(_source);
    else
        _eddyVelocity.z = 0.2 * std::abs(_source.speed); // updraught in a vortex
    _reach = std::min(computeReach(), maxReach);
}

/// Reach of the wake in a headwind; at least the range of measured wakes (Eskridge and Thompson 1982).
double SourceFlow::computeWakeReach() const {
    constexpr double headwind = 20.0, measured = 100.0; // m/s, heights
    const double speed = glm::dot(_source.velocity, _axis), pace = speed + headwind;
    if (!(speed > 0.0))
        return _source.length;
    const double fastest = 0.25 * _source.dragArea * _source.height * math::exp(-0.5) / glm::pi<double>();
    const double wake =
        fastest > 0.0 ? math::pow(fastest * pace / minSpeed, 4.0 / 3.0) / (4.0 * eddyViscosity * fastest)
                      : 0.0;
    return _source.length + std::max(wake, measured * _source.height);
}

double SourceFlow::computeReach() const {
    switch (_source.kind) {
    case WindSource::Kind::Rotor: { // 100 m above the ground; lower rotors do not reach further
        const double wash = 1.32 * std::sqrt(_source.thrust / standardDensity) / 100.0;
        return 100.0 * math::pow(wash / minSpeed, 1.0 / 1.1) + 10.0 * _source.radius;
    }
    case WindSource::Kind::Jet:
        return 2.0 * _source.radius *
               (virtualOrigin + decay * std::max(std::abs(_source.speed) / minSpeed, 1.0));
    case WindSource::Kind::Vortex:
        return _source.radius * std::max((1.0 + 0.5 / lambOseen) * std::abs(_source.speed) / minSpeed, 1.0);
    case WindSource::Kind::Vehicle:
        return computeWakeReach();
    case WindSource::Kind::Explosion:
        return BlastWave(_source.charge).reach(minSpeed);
    case WindSource::Kind::Shelter:
        break;
    }
    return 1.2 * _source.radius;
}

bool SourceFlow::reaches(const WindPlace& place, double time) const {
    return glm::length(glm::dvec2(offsetOf(place, time))) < _reach;
}

double SourceFlow::reachTravelTime() const {
    const double speed = glm::length(glm::dvec2(_source.velocity));
    return speed > 0.0 ? _reach / speed : std::numeric_limits<double>::infinity();
}

bool SourceFlow::isDeflectedByWind() const {
    return _source.kind == WindSource::Kind::Rotor || _source.kind == WindSource::Kind::Vehicle;
}

WindPlace SourceFlow::ambientWindPlace(float ground, double time) const {
    glm::vec3 middle(_source.position + clampedTime(time, maxSourceTime) * _source.velocity);
    if (_source.kind == WindSource::Kind::Vehicle)
        middle.z = ground + 0.5f * static_cast<float>(_source.height);
    return {middle, ground};
}

std::pair<glm::dvec2, glm::dvec2> SourceFlow::reachBounds(double time, double halfSpan) const {
    const glm::dvec2 middle(_source.position + clampedTime(time, maxSourceTime) * _source.velocity),
        around(halfSpan * glm::abs(glm::dvec2(_source.velocity)) + _reach);
    if (_source.kind != WindSource::Kind::Jet)
        return {middle - around, middle + around};
    const glm::dvec2 moved = around - _reach, wide(jetWidthRatio * _reach + _source.radius),
                     end = middle + (_source.speed < 0.0 ? -_reach : _reach) * glm::dvec2(_axis);
    return {glm::min(middle, end) - moved - wide, glm::max(middle, end) + moved + wide};
}

glm::dvec3 SourceFlow::offsetOf(const WindPlace& place, double time) const {
    const double moved = clampedTime(time, maxSourceTime);
    const glm::dvec3 offset = glm::dvec3(place.position) - _source.position - moved * _source.velocity;
    const bool near = glm::length(offset) < maxReach; // false if not finite
    return near ? offset : glm::dvec3(maxReach);
}

glm::dvec3 SourceFlow::rotor(const glm::dvec3& offset, double height, const glm::dvec2& air) const {
    const double radius = _source.radius, depth = -offset.z;
    const double induced = inducedSpeed(_source, glm::length(air));
    const double hub = std::max(height + depth, 0.5 * radius); // above the ground
    if (!(induced > 0.0) || !(height > 0.0))
        return glm::dvec3(0.0);

    const double r = glm::length(glm::dvec2(offset) - air / induced * columnDrift(depth, radius));

    // The column: on the axis of a vortex tube it grows from 0 above to twice the induced velocity below.
    const double wake = induced * (1.0 + depth / glm::length(glm::dvec2(depth, radius)));
    const double narrowed = radius * std::sqrt(induced / std::max(wake, 0.05 * induced));
    const double spread = axisSpeedRatio(std::max(depth, 0.0) / (2.0 * narrowed));
    const double down = wake * spread * topHat(r * spread / narrowed) * std::min(height / radius, 1.0);

    // The outwash, r from where the column meets the ground: maximum 1.32 sqrt(K)/H (r/H)^-1.1, half of it at
    // height 0.098 H (r/H)^0.9.
    const glm::dvec3 fromFoot(glm::dvec2(offset) - air / induced * columnDrift(hub, radius), 0.0);
    const double along = glm::length(fromFoot);
    const double momentum = std::sqrt(_source.thrust / standardDensity);
    const double fullFrom = hub * math::pow(1.32 * momentum / (hub * 2.0 * induced), 1.0 / 1.1);
    const double q = std::max(along, fullFrom) / hub, width = math::pow(q, 0.9);
    const double fastest = along > fullFrom ? 1.32 * momentum / hub * width / (q * q)
                                            : 2.0 * induced * std::min(along / radius, 1.0);
    const double half = 0.098 * hub * width, eta = height / half;
    const double profile = 1.48 * math::pow(eta, 1.0 / 7.0) * (1.0 - math::erf(0.68 * eta));
    return {outwardDirection(fromFoot, along) * (fastest * profile), -down};
}

glm::dvec3 SourceFlow::jet(const glm::dvec3& offset) const {
    const double x = glm::dot(offset, _axis);
    if (x < 0.0)
        return glm::dvec3(0.0);
    const double r = glm::length(offset - x * _axis), diameter = 2.0 * _source.radius;
    const double fromOrigin = x - virtualOrigin * diameter, share = axisSpeedRatio(x / diameter);
    if (share >= 1.0)
        return _source.speed * topHat(r / _source.radius) * _axis;
    constexpr double a = (glm::root_two<double>() - 1.0) / (spreading * spreading);
    const double eta = r / fromOrigin, profile = 1.0 / ((1.0 + a * eta * eta) * (1.0 + a * eta * eta));
    return _source.speed * share * profile * _axis;
}

glm::dvec3 SourceFlow::vortex(const glm::dvec3& offset) const {
    const double r = glm::length(glm::dvec2(offset)), q = r / _source.radius;
    const glm::dvec2 out = outwardDirection(offset, r);
    const double speed =
        q > 1e-6 ? _source.speed * (1.0 + 0.5 / lambOseen) / q * (1.0 - math::exp(-lambOseen * q * q)) : 0.0;
    return {glm::dvec2(-out.y, out.x) * (speed * fadeAbove(offset.z, _source.height)), 0.0};
}

glm::dvec3 SourceFlow::vehicle(const glm::dvec3& offset, double height, const glm::dvec2& air) const {
    const double speed = glm::dot(_source.velocity, _axis), z = std::max(height, 0.0);
    if (!(speed > 0.0))
        return glm::dvec3(0.0);

    // The wake points along the air relative to the vehicle, which moves through it at `pace`.
    const double pace = glm::length(air);
    const glm::dvec3 against(pace > 1e-9 ? -air / pace : glm::dvec2(_axis), 0.0);
    // The wake is M z exp(-(y^2 + z^2) / (2 s^2)) / (pi s^4), with its maximum at z = s. M is the moment of
    // the drag, applied at half the height, over rho U. The wake is never faster than the vehicle.
    const double moment = 0.5 * _source.dragArea * pace * 0.5 * _source.height;
    const double fastest =
        moment * math::exp(-0.5) / (glm::pi<double>() * std::max(pace, 1e-9)); // s^3 where it equals `pace`
    const double behind = -glm::dot(offset, against);
    const double s2 =
        std::sqrt(math::pow(fastest, 4.0 / 3.0) + 4.0 * eddyViscosity * fastest * std::max(behind, 0.0));
    const glm::dvec2 aside = glm::dvec2(offset) + behind * glm::dvec2(against);
    const double follows = s2 > 0.0 ? moment * z * math::exp(-0.5 * (glm::dot(aside, aside) + z * z) / s2) /
                                          (glm::pi<double>() * s2 * s2)
                                    : 0.0;
    glm::dvec3 velocity = glm::smoothstep(0.0, _source.height, behind) * follows * against;

    const double section = 2.0 * _source.radius * _source.height,
                 inside = section / (4.0 * glm::pi<double>());
    for (const double end : {1.0, -1.0})        // front, and rear
        for (const double side : {1.0, -1.0}) { // above the ground, and mirrored below it
            glm::dvec3 from(glm::dvec2(offset), z - side * 0.5 * _source.height);
            if (end > 0.0)
                from -= _source.length * _axis;
            const double square = glm::dot(from, from) + inside;
            velocity += end * speed * inside * from / (square * std::sqrt(square));
        }
    return velocity;
}

glm::dvec3 SourceFlow::explosion(const glm::dvec3& offset, double time) const {
    const double distance = glm::length(offset), since = clampedTime(time, maxSourceTime) - _source.time;
    if (!(since > 0.0) || !(distance > 1e-9))
        return glm::dvec3(0.0);
    return BlastWave(_source.charge).wind(distance, since) / distance * offset;
}

glm::dvec3 SourceFlow::mean(const glm::dvec3& offset, double height, const glm::dvec2& air,
                            double time) const {
    switch (_source.kind) {
    case WindSource::Kind::Rotor:
        return rotor(offset, height, air);
    case WindSource::Kind::Jet:
        return jet(offset);
    case WindSource::Kind::Vortex:
        return vortex(offset);
    case WindSource::Kind::Vehicle:
        return vehicle(offset, height, air);
    case WindSource::Kind::Explosion:
        return explosion(offset, time);
    case WindSource::Kind::Shelter:
        break;
    }
    return glm::dvec3(0.0);
}

glm::dvec3 SourceFlow::noise(const glm::dvec3& offset, double time) const {
    static const GustNoise eddies(1, 1.0, glm::dvec3(0.0), 0.0, 5); // of size 1; scaled by the radius below
    const double moved = clampedTime(time, maxSourceTime), size = 1.0 / _source.radius;
    const WindPlace place(glm::vec3(offset * size));
    NoisePoint point;
    eddies.advected(moved * size * _eddyVelocity).sample(&place, 1, &point);
    return {point.values[0], point.values[1], point.values[2]};
}

glm::vec3 SourceFlow::velocity(const WindPlace& place, double time, const glm::vec3& ambientWind) const {
    constexpr double minTurbulentSpeed = 0.01; // m/s
    const glm::dvec3 offset = offsetOf(place, time);
    const double near = 1.0 - glm::smoothstep(0.8 * _reach, _reach, glm::length(glm::dvec2(offset)));
    if (!(near > 0.0))
        return glm::vec3(0.0f);
    const glm::dvec2 relativeWind =
        glm::dvec2(isDeflectedByWind() ? calmUnlessFinite(ambientWind) : glm::vec3(0.0f)) -
        glm::dvec2(_source.velocity);
    const glm::dvec3 velocity = near * mean(offset, static_cast<double>(place.height), relativeWind, time);
    const double speed = glm::length(velocity);
    if (!(_source.turbulence > 0.0) || !(speed > minTurbulentSpeed) || !std::isfinite(speed))
        return calmUnlessFinite(glm::vec3(velocity));
    return calmUnlessFinite(glm::vec3(velocity + _source.turbulence * speed * noise(offset, time)));
}

float SourceFlow::shareOfWind(const WindPlace& place, double time) const {
    if (_source.kind != WindSource::Kind::Shelter)
        return 1.0f;
    const glm::dvec3 offset = offsetOf(place, time);
    const double inside =
        fadeAbove(glm::length(glm::dvec2(offset)), _source.radius) * fadeAbove(offset.z, _source.height);
    return static_cast<float>(1.0 - inside * (1.0 - _source.share));
}

} // namespace osgTreeWind

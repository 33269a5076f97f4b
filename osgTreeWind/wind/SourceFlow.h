// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindPlace.h>
#include <osgTreeWind/wind/WindSource.h>

#include <glm/vec2.hpp>

#include <utility>

namespace osgTreeWind {

/// The flow of one WindSource. Values out of range are clamped.
class SourceFlow {
public:
    explicit SourceFlow(const WindSource& source);

    /// The velocity it adds to the wind, m/s; 0 beyond its reach. Finite for any place and time.
    /// @param ambientWind wind at ambientWindPlace() without gusts, m/s; used only if isDeflectedByWind().
    glm::vec3 velocity(const WindPlace& place, double time, const glm::vec3& ambientWind) const;
    /// The share of the wind that remains, [0, 1]: below 1 in a shelter.
    float shareOfWind(const WindPlace& place, double time) const;

    /// Whether the place is within its reach.
    bool reaches(const WindPlace& place, double time) const;
    /// Whether the wind deflects its flow: the column of a rotor, the wake of a vehicle.
    bool isDeflectedByWind() const;
    /// Where to sample the wind that deflects its flow, over ground at z = `ground`.
    WindPlace ambientWindPlace(float ground, double time) const;

    /// Bounds in x and y, metres, of its reach from `halfSpan` seconds before `time` to as long after.
    std::pair<glm::dvec2, glm::dvec2> reachBounds(double time, double halfSpan) const;
    /// Time in which it moves by its own reach, seconds; infinite if it does not move.
    double reachTravelTime() const;

private:
    /// The place relative to the source at this time; far away if that is not finite.
    glm::dvec3 offsetOf(const WindPlace& place, double time) const;
    glm::dvec3 rotor(const glm::dvec3& offset, double height, const glm::dvec2& air) const;
    glm::dvec3 jet(const glm::dvec3& offset) const;
    glm::dvec3 vortex(const glm::dvec3& offset) const;
    glm::dvec3 explosion(const glm::dvec3& offset, double time) const;
    glm::dvec3 vehicle(const glm::dvec3& offset, double height, const glm::dvec2& air) const;
    /// The velocity it adds, without turbulence. @param air horizontal wind relative to the source, m/s.
    glm::dvec3 mean(const glm::dvec3& offset, double height, const glm::dvec2& air, double time) const;
    /// Turbulence advected by the flow: three components of mean 0 and variance 1.
    glm::dvec3 noise(const glm::dvec3& offset, double time) const;
    double computeReach() const;
    double computeWakeReach() const;

    WindSource _source;
    glm::dvec3 _axis{0.0};         ///< Direction of a jet or of a vehicle's motion, unit length.
    glm::dvec3 _eddyVelocity{0.0}; ///< Velocity that advects the turbulence, m/s.
    double _reach;                 ///< Horizontal distance, metres, beyond which it adds less than 0.2 m/s.
};

} // namespace osgTreeWind

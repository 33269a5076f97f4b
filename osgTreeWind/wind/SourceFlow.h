// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindPlace.h>
#include <osgTreeWind/wind/WindSource.h>

#include <glm/vec2.hpp>

#include <utility>

namespace osgTreeWind {

/// How one source moves the air. Values out of its ranges are clamped.
class SourceFlow {
public:
    explicit SourceFlow(const WindSource& source);

    /// What it adds, m/s; nothing beyond its reach. Finite for any place and time. @param air that blows
    /// where airPlace() says, without gusts, m/s; where that is nowhere it does not count.
    glm::vec3 velocity(const WindPlace& place, double time, const glm::vec3& air) const;
    /// The share of the wind that it leaves, [0, 1].
    float shareOfWind(const WindPlace& place, double time) const;

    /// Whether it reaches a place.
    bool reaches(const WindPlace& place, double time) const;
    /// Whether the wind bends its column or carries its wake off.
    bool isBent() const;
    /// Where the wind does so, over ground at z = `ground`.
    WindPlace airPlace(float ground, double time) const;

    /// Lowest and highest x and y that it reaches within `half` seconds of a time, metres.
    std::pair<glm::dvec2, glm::dvec2> box(double time, double half) const;
    /// How long it takes to move as far as it reaches, seconds; infinite where it stands still.
    double validTime() const;

private:
    /// From the source as it stands then; far away where that is not finite.
    glm::dvec3 offsetOf(const WindPlace& place, double time) const;
    glm::dvec3 rotor(const glm::dvec3& offset, double height, const glm::dvec2& air) const;
    glm::dvec3 jet(const glm::dvec3& offset) const;
    glm::dvec3 vortex(const glm::dvec3& offset) const;
    glm::dvec3 explosion(const glm::dvec3& offset, double time) const;
    glm::dvec3 vehicle(const glm::dvec3& offset, double height, const glm::dvec2& air) const;
    /// Of what it adds on the average. @param air that goes past it, on the level, m/s.
    glm::dvec3 mean(const glm::dvec3& offset, double height, const glm::dvec2& air, double time) const;
    /// Three numbers of mean 0 and variance 1, which the flow carries along.
    glm::dvec3 noise(const glm::dvec3& offset, double time) const;
    double reachOf() const;
    double wakeReach() const;

    WindSource _source;
    glm::dvec3 _along{0.0};   ///< A jet, or a vehicle's way; of unit length.
    glm::dvec3 _carries{0.0}; ///< Its eddies, m/s.
    double _reach;            ///< On the level, metres: beyond, it adds less than 0.2 m/s.
};

} // namespace osgTreeWind

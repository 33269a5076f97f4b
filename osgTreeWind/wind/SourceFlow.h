// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>
#include <osgTreeWind/wind/WindWithSources.h>

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// What a source makes of the air at one time. Numbers out of its ranges are held within them.
class SourceFlow {
public:
    explicit SourceFlow(const WindSource& source);

    /// What it adds, m/s. Finite for any place and time. @param wind that blows beside it and carries it off,
    /// without gusts; null: calm.
    glm::vec3 velocity(const WindPlace& place, double time, const WindField* wind) const;
    /// The share of the wind that it leaves, [0, 1].
    float shareOfWind(const WindPlace& place, double time) const;

private:
    /// From the source as it stands then; far away where that is not finite.
    glm::dvec3 offsetOf(const WindPlace& place, double time) const;
    /// How fast the air goes past it, m/s, on the level.
    glm::dvec2 airPast(const WindPlace& place, double time, const WindField* wind) const;
    glm::dvec3 rotor(const glm::dvec3& offset, double height, const glm::dvec2& air) const;
    glm::dvec3 jet(const glm::dvec3& offset) const;
    glm::dvec3 vortex(const glm::dvec3& offset) const;
    glm::dvec3 explosion(const glm::dvec3& offset, double time) const;
    glm::dvec3 vehicle(const glm::dvec3& offset, double height, const glm::dvec2& air) const;
    /// Of what it adds on the average.
    glm::dvec3 mean(const glm::dvec3& offset, double height, const glm::dvec2& air, double time) const;
    /// Three numbers of mean 0 and variance 1, which the flow carries along.
    glm::dvec3 noise(const glm::dvec3& offset, double time) const;

    WindSource _source;
    glm::dvec3 _along{0.0};   ///< A jet, or a vehicle's way; of unit length.
    glm::dvec3 _carries{0.0}; ///< Its eddies, m/s.
};

} // namespace osgTreeWind

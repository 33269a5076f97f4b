// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindPlace.h>
#include <osgTreeWind/wind/WindSource.h>

namespace osgTreeWind {

/// What a source makes of the air at one time. Numbers out of its ranges are held within them.
class SourceFlow {
public:
    explicit SourceFlow(const WindSource& source);

    /// What it adds, m/s. Finite for any place and time.
    glm::vec3 velocity(const WindPlace& place, double time) const;
    /// The share of the wind that it leaves, [0, 1].
    float shareOfWind(const WindPlace& place, double time) const;

private:
    /// From the source as it stands then; far away where that is not finite.
    glm::dvec3 offsetOf(const WindPlace& place, double time) const;
    glm::dvec3 rotor(const glm::dvec3& offset, double height) const;
    glm::dvec3 jet(const glm::dvec3& offset) const;
    glm::dvec3 vortex(const glm::dvec3& offset) const;
    glm::dvec3 vehicle(const glm::dvec3& offset, double height) const;
    /// Of what it adds on the average.
    glm::dvec3 mean(const glm::dvec3& offset, double height) const;
    /// Three numbers of mean 0 and variance 1, which the flow carries along.
    glm::dvec3 noise(const glm::dvec3& offset, double time) const;

    WindSource _source;
    glm::dvec3 _along{0.0};   ///< A jet, or a vehicle's way; of unit length.
    glm::dvec3 _carries{0.0}; ///< Its eddies, m/s.
};

} // namespace osgTreeWind

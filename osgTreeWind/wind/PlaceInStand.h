// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace osgTreeWind {

/// What the wind among trees is at a place, apart from the gusts of the moment. CanopyFlow keeps it from one
/// sample of the place to the next (WindPlace::stand), since it hardly changes.
struct PlaceInStand {
    std::uint64_t key = 0; ///< Of all that the other members depend on; 0: nothing is known.
    float closure = 0.0f;  ///< 0 in open country, where the members below are without meaning.
    /// The speed over that at the reference height: mean, standard deviation and skewness.
    float mean = 0.0f, deviation = 0.0f, skewness = 0.0f;
    float swing = 0.0f; ///< Standard deviation of the direction, radians.
    /// The downward component: standard deviation over the speed at the reference height, skewness, and
    /// weights of the speed's noise and of its own.
    float down = 0.0f, downSkewness = 0.0f, downBySpeed = 0.0f, downByItself = 1.0f;
    /// Wind over that beside the crown, at both ends of a CanopySpeedStep.
    glm::vec2 shelter{1.0f};
};

} // namespace osgTreeWind

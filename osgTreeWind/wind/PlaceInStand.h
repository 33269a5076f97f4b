// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace osgTreeWind {

/// What the wind among trees is at a place, apart from the gusts of the moment. It hardly changes, so a
/// forest keeps it from one sample of the place to the next (WindPlace::stand). Speeds are over that of the
/// wind at the reference height (CanopySettings::reference).
struct PlaceInStand {
    std::uint64_t key = 0;     ///< Of all that the other members depend on; 0: nothing is known.
    float closure = 0.0f;      ///< 0 in open country, where the other members are without meaning, to 1.
    float mean = 0.0f;         ///< Mean of the speed.
    float deviation = 0.0f;    ///< Standard deviation of the speed.
    float skewness = 0.0f;     ///< Skewness of the speed.
    float swing = 0.0f;        ///< Standard deviation of the direction, radians.
    float down = 0.0f;         ///< Standard deviation of the downward component.
    float downSkewness = 0.0f; ///< Skewness of the downward component.
    float downBySpeed = 0.0f;  ///< Weight in the downward component of the noise that makes the speed.
    float downByItself = 1.0f; ///< Weight of its own noise.
    glm::vec2 shelter{1.0f};   ///< Wind over that beside the crown, at both ends of a step of the speed.
};

} // namespace osgTreeWind

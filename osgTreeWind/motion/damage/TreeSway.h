// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgTreeWind {

/// How a tree sways at one time, in the axes of the forest: x and y horizontal, z up.
struct TreeSway {
    glm::vec2 displacement{0.0f}; ///< Of the top of the tree from rest, metres.
    /// Of the top of the tree by its modes, m/s. The static lean, which follows the wind, has no velocity.
    glm::vec2 velocity{0.0f};
    float lean = 0.0f; ///< Angle between the lines from the foot to the top now and at rest, radians.
    glm::dvec2 windMoment{0.0};   ///< Of air and inertia at the foot, N m; points to where it turns the tree.
    glm::dvec2 weightMoment{0.0}; ///< Of the overhanging weight at the foot, likewise.
    /// The moment that uproots or breaks the tree, N m; 0: unknown for this species.
    double limit = 0.0;
    double frequency = 0.0;    ///< Natural frequency of the mode with the most energy in gusts, Hz.
    glm::vec3 windAtTop{0.0f}; ///< In the last step, undisturbed by the tree itself, m/s.

    /// Total moment at the foot, N m; the tree fails where it exceeds `limit`.
    double moment() const { return glm::length(windMoment + weightMoment); }
};

} // namespace osgTreeWind

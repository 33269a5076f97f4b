// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace osgTreeWind {

/// The right half of a leaf outline from foot to tip, in lengths of the leaf: x across, y along.
using LeafOutline = std::vector<glm::vec2>;

/// A leaf on a card whose corners are (0, 0) and (1, 1).
struct LeafBlade {
    glm::vec2 foot{0.0f};
    float lean = 0.0f; ///< Clockwise from upright, radians.
    float length = 0.1f;
    float brightness = 0.8f, hue = 0.5f;
    float tilt = 0.0f;   ///< Angle between the blade and the card, radians.
    float toward = 0.0f; ///< Direction in the card that tilts out of it, measured like `lean`.

    /// A point of the outline on the card; z is the distance in front of it.
    glm::vec3 point(const glm::vec2& outline) const;
    /// The whole outline projected to the card.
    std::vector<glm::vec2> polygon(const LeafOutline& outline) const;
};

/// A piece of a twig, tapering from foot to end.
struct TwigPiece {
    glm::vec2 foot, end;
    float footWidth, endWidth;

    std::vector<glm::vec2> polygon() const;
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace osgTreeWind {

/// The right half of a leaf's outline, from its foot to its tip: x across in lengths of the leaf, y along.
using LeafOutline = std::vector<glm::vec2>;

/// A leaf on a card whose corners are (0, 0) and (1, 1).
struct LeafBlade {
    glm::vec2 foot{0.0f};
    float lean = 0.0f; ///< From upright toward the right, radians.
    float length = 0.1f;
    float brightness = 0.8f, hue = 0.5f;
    float tilt = 0.0f;   ///< Of its face out of the card, radians,
    float toward = 0.0f; ///< about an axis across this direction in the card, as `lean`.

    /// A point of its outline, in front of the card by z.
    glm::vec3 point(const glm::vec2& outline) const;
    /// As it shows on the card.
    std::vector<glm::vec2> polygon(const LeafOutline& outline) const;
};

/// A piece of a twig, tapering from foot to end.
struct TwigPiece {
    glm::vec2 foot, end;
    float footWidth, endWidth;

    /// @param widths so many of its own.
    std::vector<glm::vec2> polygon(float widths = 1.0f) const;
};

} // namespace osgTreeWind

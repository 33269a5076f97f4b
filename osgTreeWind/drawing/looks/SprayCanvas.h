// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>

#include <glm/vec2.hpp>

#include <cstdint>
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
};

/// A piece of a twig, tapering from foot to end.
struct TwigPiece {
    glm::vec2 foot, end;
    float footWidth, endWidth;
};

/// Where sprays are painted: what comes later covers what came before.
class SprayCanvas {
public:
    SprayCanvas();

    /// Paints twigs so wide, up to one factor for all, that they cover a share of the card.
    void addTwigs(std::vector<TwigPiece> twigs, float coverage);
    void addLeaf(const LeafOutline& outline, const LeafBlade& blade);

    LeafTexels texels() const;

private:
    static constexpr int pixels = 256, samples = 3, size = pixels * samples;
    static constexpr std::uint8_t leaf = 1, twig = 2;

    template <typename Paint>
    void fill(const std::vector<glm::vec2>& polygon, Paint paint);
    void drawTwigs(const std::vector<TwigPiece>& twigs);

    std::vector<std::uint8_t> _brightness, _hue, _parts;
    std::vector<float> _crossings;
};

} // namespace osgTreeWind

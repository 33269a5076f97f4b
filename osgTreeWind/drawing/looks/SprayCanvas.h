// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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
    float tilt = 0.0f;   ///< Of its face out of the card, radians,
    float toward = 0.0f; ///< about an axis across this direction in the card, as `lean`.

    /// A point of its outline, in front of the card by z.
    glm::vec3 point(const glm::vec2& outline) const;
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

    /// As wide when bare; in leaf less so.
    void addTwigs(const std::vector<TwigPiece>& twigs);
    /// Paints twigs so wide, up to one factor for all, that they cover a share of the card. These it returns.
    std::vector<TwigPiece> fitTwigs(std::vector<TwigPiece> twigs, float coverage);
    /// As it shows on the card.
    void addLeaf(const LeafOutline& outline, const LeafBlade& blade);
    /// Share of a leaf that would cover none of those before it.
    float freeShare(const LeafOutline& outline, const LeafBlade& blade);
    /// Share of the card that leaves cover, twigs between them left out.
    float leafCoverage() const { return static_cast<float>(_leafSamples) / (size * size); }

    LeafTexels texels() const;

private:
    static constexpr int pixels = 256, samples = 3, size = pixels * samples;
    static constexpr std::uint8_t leaf = 1, bareTwig = 2, leafyTwig = 4;

    template <typename Paint>
    void fill(const std::vector<glm::vec2>& polygon, Paint paint);

    std::vector<std::uint8_t> _brightness, _hue, _parts;
    std::size_t _leafSamples = 0;
    std::vector<float> _crossings;
};

} // namespace osgTreeWind

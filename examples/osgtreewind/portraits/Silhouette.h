// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// A square picture in black and white: black for a tree, white for the sky.
class Silhouette {
public:
    /// Solid cells of a parallelogram, row by row: u from left to right, v from the bottom up.
    struct Mask {
        int size = 0; ///< Number of rows and of columns, a power of two.
        std::vector<std::uint8_t> solid;
    };

    explicit Silhouette(int size) : _size(size), _black(static_cast<std::size_t>(size * size)) {}

    /// Blackens the pixels whose centres lie on corner + u * across + v * along, u and v in [0, 1), where the
    /// mask is solid. Coordinates in pixels.
    void draw(const glm::vec2& corner, const glm::vec2& across, const glm::vec2& along, const Mask& mask);

    /// The visual outline: morphological closing by a square of `side` pixels, with holes filled.
    Silhouette outline(int side) const;

    /// Whitens the stem: all rows below the lowest one whose width is over 0.3 of the largest width.
    /// @return number of rows of the rest, the crown.
    int cutStem();

    int size() const { return _size; }
    /// Shrinks by a factor: a pixel is black if at least `share` of its `pixels` x `pixels` pixels are.
    Silhouette shrunk(int pixels, float share = 0.5f) const;

    bool black(int x, int y) const { return _black[static_cast<std::size_t>(y * _size + x)] != 0; }
    /// Number of black pixels.
    std::size_t count() const;
    /// Number of pixels that are black in both pictures, which have the same size.
    std::size_t common(const Silhouette& other) const;

private:
    /// Sets pixels to `value` within `reach` of a pixel of this value, along rows, then along columns.
    void spread(int reach, std::uint8_t value);

    int _size;
    std::vector<std::uint8_t> _black;
};

} // namespace osgTreeWind

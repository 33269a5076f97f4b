// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// A square picture in black and white: what stands before the sky.
class Silhouette {
public:
    /// What of a parallelogram is solid: rows and columns, as many as a power of two, u from left to right,
    /// v from the bottom up.
    struct Mask {
        int size = 0;
        std::vector<std::uint8_t> solid;

        /// Share of it that is solid.
        float coverage() const;
    };

    explicit Silhouette(int size) : _size(size), _black(static_cast<std::size_t>(size * size)) {}

    /// Pixels whose middles lie on corner + u * across + v * along, u and v in [0, 1), where the mask is
    /// solid. In pixels.
    void draw(const glm::vec2& corner, const glm::vec2& across, const glm::vec2& along, const Mask& mask);

    /// Closed by a square of `side` pixels, and without holes: what the eye takes for the outline.
    Silhouette outline(int side) const;

    int size() const { return _size; }
    /// A pixel for each square of so many: black where at least half of it is.
    Silhouette shrunk(int pixels) const;

    bool black(int x, int y) const { return _black[static_cast<std::size_t>(y * _size + x)] != 0; }
    std::size_t count() const;
    /// Black here and in the other, which is of the same size.
    std::size_t common(const Silhouette& other) const;

private:
    /// Along rows, then along columns: what is `value` within `reach` of a pixel makes it so.
    void spread(int reach, std::uint8_t value);

    int _size;
    std::vector<std::uint8_t> _black;
};

} // namespace osgTreeWind

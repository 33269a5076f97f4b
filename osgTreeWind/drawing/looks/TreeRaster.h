// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Rasterizes flat pieces in parallel projection and keeps the nearest one at each sample of a square.
class TreeRaster {
public:
    static constexpr std::uint32_t nothing = ~0u;
    static constexpr int cells = 32; ///< Rows and columns of a stencil.

    /// The parallelogram corner + u * across + v * along, u and v in [0, 1]. In samples; z toward the eye.
    struct Piece {
        glm::vec3 corner{0.0f}, across{0.0f}, along{0.0f};
    };
    /// Solid cells of a piece, row by row: u from left to right, v from the bottom up.
    using Stencil = std::array<std::uint8_t, cells * cells>;
    struct Sample {
        float depth;
        std::uint32_t item; ///< The visible item, or `nothing`.
        int cell;           ///< Cell of its stencil: u + cells * v.
    };

    explicit TreeRaster(int size) : _size(size), _samples(static_cast<std::size_t>(size * size)) { clear(); }

    void clear();
    void draw(const Piece& piece, const Stencil& stencil, std::uint32_t item);
    const Sample& sample(int x, int y) const { return _samples[static_cast<std::size_t>(y * _size + x)]; }
    int size() const { return _size; }

private:
    int _size;
    std::vector<Sample> _samples;
};

} // namespace osgTreeWind

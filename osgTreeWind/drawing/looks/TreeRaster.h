// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// A square picture of flat pieces, without perspective: what is nearest at each sample.
class TreeRaster {
public:
    static constexpr std::uint32_t nothing = ~0u;
    static constexpr int cells = 32; ///< Of a piece, in rows and columns.

    /// A parallelogram: corner + u * across + v * along, u and v in [0, 1]. x and y in samples, z toward the
    /// eye.
    struct Piece {
        glm::vec3 corner{0.0f}, across{0.0f}, along{0.0f};
    };
    /// Which cells of a piece are solid, u from left to right, v from the bottom up.
    using Stencil = std::array<std::uint8_t, cells * cells>;
    /// What is seen at a sample.
    struct Sample {
        float depth;
        std::uint32_t item; ///< Or nothing.
        int cell;           ///< Of the item: u + cells * v.
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

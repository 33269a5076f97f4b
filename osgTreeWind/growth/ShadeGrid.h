// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowthSite.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

/// Light of an overcast sky among leaves: a regular grid of leaf areas, which light crosses in 17 directions.
///
/// Each year: call reset(), addLeaves() for every tree, then computeLight(). After that, any thread may call
/// light() and lightGradient(). The same leaves give the same light, bit for bit, on every machine.
class ShadeGrid {
public:
    /// @param cellSize edge of a grid cell, metres, above 0.
    explicit ShadeGrid(float cellSize) : _cellSize(cellSize) {}

    /// Removes all leaves. @param lowest, highest bounds of the leaves to be added.
    void reset(const glm::vec3& lowest, const glm::vec3& highest);
    /// @param place within the bounds of reset(). @param area one-sided, m².
    void addLeaves(const glm::vec3& place, float area);
    /// Adds the shade of neighbours around `tree`, with leaves from half of `height` up to `height`.
    void addNeighbours(const GrowthSite& site, const glm::vec2& tree, float height);
    void computeLight();

    /// Share of full light, 0 to 1. Outside the grid: the value at the nearest place in it.
    float light(const glm::vec3& place) const;
    /// Relative increase of the light per metre; length at most 1.
    glm::vec3 lightGradient(const glm::vec3& place) const;
    float cellSize() const { return _cellSize; }

private:
    /// Lower corner of the eight cells around a place, and the place between them, 0 to 1.
    struct GridPosition {
        std::size_t index;
        glm::vec3 fraction;
    };
    GridPosition gridPosition(const glm::vec3& place) const;
    void sumLight(int layer);
    void propagateRays(int layer);
    std::size_t rowStride() const { return static_cast<std::size_t>(_size.x) + 4; }

    float _cellSize;
    glm::vec3 _lowest{0.0f}; ///< Centre of the first cell.
    glm::ivec3 _size{2};
    std::vector<float> _leaves, _light;       ///< By layer, row, column.
    std::array<std::vector<float>, 17> _rays; ///< Of one layer, by direction, with a border of two cells.
    std::vector<float> _nextRays;             ///< Rays of one direction in the layer below.
    std::array<std::vector<float>, 3> _transmittance; ///< Of one layer, by steepness; same border.
    std::vector<float> _neighbourLeaves;              ///< Leaf area per cell, by layer.
    GrowthSite _site;
    std::array<float, 17> _inflow{}; ///< Light that enters at the sides, by direction.
};

} // namespace osgTreeWind

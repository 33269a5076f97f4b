// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowthSite.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

/// Light among leaves: that of an overcast sky, from 17 directions, through boxes with leaves.
///
/// Each year: begin(), addLeaves() of every tree, castShade(). After that light() and towardsLight() may be
/// asked from any thread. One set of leaves gives one light, bit for bit, on every machine.
class ShadeGrid {
public:
    /// @param cell edge of a box, metres, above 0.
    explicit ShadeGrid(float cell) : _cell(cell) {}

    /// Forgets all leaves. @param lowest, highest what holds the new ones.
    void begin(const glm::vec3& lowest, const glm::vec3& highest);
    void addLeaves(const glm::vec3& place, float area); ///< m², within begin()'s box.
    /// Leaves of neighbours of a tree, which reach from half of `height` to `height`, and their shade.
    void addNeighbours(const GrowthSite& site, const glm::vec2& tree, float height);
    void castShade();

    /// Share of the full light, 0 to 1; outside of the grid that at its nearest place.
    float light(const glm::vec3& place) const;
    /// Relative increase of light a metre, at most of length 1.
    glm::vec3 towardsLight(const glm::vec3& place) const;
    float cell() const { return _cell; }

private:
    struct Corner {
        std::size_t first;
        glm::vec3 part;
    };
    Corner cornerAt(const glm::vec3& place) const;
    void addLight(int layer);
    void descend(int layer);
    std::size_t across() const { return static_cast<std::size_t>(_size.x) + 4; }

    float _cell;
    glm::vec3 _lowest{0.0f}; ///< Centre of the first box.
    glm::ivec3 _size{2};
    std::vector<float> _leaves, _light;         ///< By layer, row, column.
    std::array<std::vector<float>, 17> _rays;   ///< A layer each, with a border of two boxes.
    std::vector<float> _next;                   ///< Likewise.
    std::array<std::vector<float>, 3> _through; ///< Share that passes a layer, by steepness.
    std::vector<float> _neighbourLeaves;        ///< By layer, of a box.
    GrowthSite _site;
    std::array<float, 17> _inflow{}; ///< What comes in from the sides.
};

} // namespace osgTreeWind

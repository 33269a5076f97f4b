// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// Wind known at the points of a grid, regular east and north, for one time or several: linear between points
/// and between times, held at the edges and before the first and after the last time.
///
///     GridWind::Grid grid;
///     grid.points = {2, 1, 1};
///     grid.cell = {100.0, 1.0, 1.0};
///     grid.values = {4.0f, 0.0f, 0.0f, 8.0f, 0.0f, 0.0f}; // u, v, w of each point
///     if (const auto wind = GridWind::create(grid))
///         forest->setWind(wind.value());
class OSGTREEWIND_EXPORT GridWind final : public WindField {
public:
    /// The grid as plain values.
    struct Grid {
        glm::ivec3 points{1};      ///< Numbers of points east, north and up, each at least 1.
        glm::dvec3 origin{0.0};    ///< Scene position of the first point (south-west, lowest), metres.
        glm::dvec3 cell{1.0};      ///< Distances between neighbouring points, metres, each above 0.
        std::vector<double> times; ///< Seconds, strictly increasing; empty for a wind that does not change.
        /// Scene heights of the points, metres, where layers are not evenly spaced or follow the ground; they
        /// replace origin.z and cell.z. One for each layer, each point or each point and time, ordered as
        /// values are, increasing upward; empty for even layers.
        std::vector<float> heights;
        /// Heights count from the ground below each place, not from the origin.
        bool aboveGround = false;
        /// Roughness length of the ground, metres, where heights count from it: wind below the lowest layer,
        /// and of a single layer also above it, follows the logarithmic profile. 0: the layer holds.
        double roughness = 0.0;
        /// Velocities u, v, w (m/s toward east, north, up) point by point: east fastest, then north, then up,
        /// then time.
        std::vector<float> values;
    };

    /// A field over the grid, or what is wrong with it: diagnostics with the member's name as key.
    static Result<std::shared_ptr<const GridWind>> create(Grid grid);

    /// The thesis' forestWind array (§4.2): at thesis position (x, y, z) the velocity stands at index
    /// (floor(x) + floor(z) * width) * 3, positions outside held at the edge, nothing interpolated.
    /// @param width, length cells of 1 m along thesis x (east) and thesis z (south).
    /// @param values width * length * 3 components in thesis axes, m/s.
    /// @param origin scene position of the array's corner.
    static Result<WindFieldPtr> fromForestWind(int width, int length, std::vector<float> values,
                                               const glm::dvec3& origin = glm::dvec3(0.0));

    /// What is wrong with a grid; empty where create() takes it.
    static Diagnostics check(const Grid& grid);

    const Grid& grid() const { return _grid; } ///< As given.

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    KindOfWind kind() const override { return this; }

private:
    explicit GridWind(Grid grid);

    Grid _grid;
};

} // namespace osgTreeWind

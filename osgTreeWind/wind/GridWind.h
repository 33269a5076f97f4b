// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec3.hpp>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// Wind at the points of a grid that is regular in x and y, for one or several times. Interpolates linearly
/// in space and time; clamps to the edges of the grid and to the first and last time.
///
///     GridWind::Grid grid;
///     grid.points = {2, 1, 1};
///     grid.cell = {100.0, 1.0, 1.0};
///     grid.values = {4.0f, 0.0f, 0.0f, 8.0f, 0.0f, 0.0f}; // u, v, w of each point
///     if (const auto wind = GridWind::create(grid))
///         report(forest->setWind(wind.value()));
class OSGTREEWIND_EXPORT GridWind final : public WindField {
public:
    /// The grid and its velocities.
    struct Grid {
        glm::ivec3 points{1};      ///< Number of points east, north and up, each at least 1.
        glm::dvec3 origin{0.0};    ///< Scene position of the first point (south-west, lowest), metres.
        glm::dvec3 cell{1.0};      ///< Spacing of the points, metres, each above 0.
        std::vector<double> times; ///< Seconds, strictly increasing; empty for a steady wind.
        /// Scene heights, metres, for layers that are not evenly spaced or follow the terrain; they replace
        /// origin.z and cell.z. One per layer, per point, or per point and time, in the order of `values`,
        /// increasing upward; empty for evenly spaced layers.
        std::vector<float> heights;
        /// Heights are above the ground below each place instead of above scene z = 0.
        bool aboveGround = false;
        /// Roughness length of the ground, metres; needs `aboveGround`. Below the lowest layer, and above it
        /// too if there is only one, the wind follows the logarithmic profile. 0: the layer's wind is used.
        double roughness = 0.0;
        /// Velocities u, v, w (m/s toward east, north, up) of each point: x fastest, then y, z and time.
        std::vector<float> values;
        /// Standard deviation of the turbulence along the wind at each point, m/s, in the order of `values`;
        /// empty if unknown.
        std::vector<float> deviations;
    };

    /// Checks the grid and returns the wind, or diagnostics with the member's name as key.
    static Result<std::shared_ptr<const GridWind>> create(Grid grid);

    /// The wind of a forestWind array as in the thesis (§4.2): the velocity at thesis position (x, y, z) is
    /// at index (floor(x) + floor(z) * width) * 3, without interpolation; positions outside clamp to the
    /// edge.
    /// @param width, length number of cells of 1 m along thesis x (east) and thesis z (south).
    /// @param values width * length * 3 components in thesis axes, m/s.
    /// @param origin scene position of the array's corner.
    static Result<WindFieldPtr> fromForestWind(int width, int length, std::vector<float> values,
                                               const glm::dvec3& origin = glm::dvec3(0.0));

    /// The problems of a grid; empty if create() accepts it.
    [[nodiscard]] static Diagnostics check(const Grid& grid);

    const Grid& grid() const { return _grid; } ///< The grid as given.

    /// With a roughness: of the only layer, or else at 10 m.
    std::optional<LogProfile> profile() const override;
    WindFieldPtr turbulence() const override { return _turbulence; }
    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

private:
    explicit GridWind(Grid grid);

    Grid _grid;
    WindFieldPtr _turbulence; ///< A grid with the deviations as the first component.
};

} // namespace osgTreeWind

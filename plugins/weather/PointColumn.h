// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/GridWind.h>

#include <algorithm>
#include <cstddef>

namespace osgTreeWind {

/// The points of a grid above one place at one time.
struct PointColumn {
    GridWind::Grid& grid;
    std::size_t first, layerStep, layers;

    float& height(std::size_t layer) const { return grid.heights[first + layer * layerStep]; }
    float* velocity(std::size_t layer) const { return grid.values.data() + 3 * (first + layer * layerStep); }

    /// The lowest layer whose height passes a test; the number of layers if no height does.
    template <typename Test>
    std::size_t lowestWhere(Test test) const {
        std::size_t layer = 0;
        while (layer < layers && !test(height(layer)))
            ++layer;
        return layer;
    }

    /// Replaces winds up to a height by the lowest wind above it. @return their number.
    std::size_t replaceWindUpTo(float ground) const {
        const std::size_t lowest = lowestWhere([&](float height) { return height > ground; });
        if (lowest == layers)
            return 0;
        for (std::size_t layer = 0; layer < lowest; ++layer)
            std::copy_n(velocity(lowest), 3, velocity(layer));
        return lowest;
    }
};

/// Calls `visit` with each column of a grid with heights of points.
template <typename Visit>
void forEachColumn(GridWind::Grid& grid, Visit visit) {
    const auto layers = static_cast<std::size_t>(grid.points.z),
               perLayer = static_cast<std::size_t>(grid.points.x) * static_cast<std::size_t>(grid.points.y);
    for (std::size_t step = 0; step < grid.heights.size(); step += perLayer * layers)
        for (std::size_t place = 0; place < perLayer; ++place)
            visit(PointColumn{grid, step + place, perLayer, layers});
}

} // namespace osgTreeWind

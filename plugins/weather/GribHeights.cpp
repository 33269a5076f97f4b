// SPDX-License-Identifier: MIT
#include <plugins/weather/GribHeights.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr float minStep = 0.01f; // metres; resolved by floats up to 100 km

/// The points above one place at one time.
struct PointColumn {
    GridWind::Grid& grid;
    std::size_t first, layerStep, layers;

    float& height(std::size_t layer) const { return grid.heights[first + layer * layerStep]; }
    float* values(std::size_t layer) const { return grid.values.data() + 3 * (first + layer * layerStep); }

    void replaceWindBelowGround() const {
        std::size_t lowest = 0;
        while (lowest < layers && !(height(lowest) > (grid.aboveGround ? 0.0f : -1e9f)))
            ++lowest;
        for (std::size_t layer = 0; lowest < layers && layer < lowest; ++layer)
            std::copy(values(lowest), values(lowest) + 3, values(layer));
    }

    void increaseUpward() const {
        std::size_t known = 0;
        while (known < layers && !std::isfinite(height(known)))
            ++known;
        if (known == layers)
            height(known = 0) = 0.0f;
        for (std::size_t layer = known; layer > 0; --layer)
            height(layer - 1) = height(layer) - minStep;
        for (std::size_t layer = known + 1; layer < layers; ++layer)
            if (const float least = height(layer - 1) + minStep; !(height(layer) >= least))
                height(layer) = least;
    }
};

} // namespace

void makeHeightsIncrease(GridWind::Grid& grid) {
    const auto layers = static_cast<std::size_t>(grid.points.z);
    const std::size_t perLayer =
        static_cast<std::size_t>(grid.points.x) * static_cast<std::size_t>(grid.points.y);
    for (std::size_t step = 0; step * perLayer * layers < grid.heights.size(); ++step)
        for (std::size_t place = 0; place < perLayer; ++place) {
            const PointColumn column{grid, step * perLayer * layers + place, perLayer, layers};
            column.replaceWindBelowGround();
            column.increaseUpward();
        }
}

} // namespace osgTreeWind

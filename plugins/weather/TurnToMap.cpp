// SPDX-License-Identifier: MIT
#include <plugins/weather/TurnToMap.h>

#include <plugins/weather/TrueNorth.h>

#include <osgTreeWind/base/Number.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// "-15.75 to 15.75 degrees clockwise"
std::string rangeOf(const std::vector<glm::dvec2>& norths) {
    double least = 360.0, most = -360.0;
    for (const glm::dvec2& north : norths) {
        const double degrees = glm::degrees(std::atan2(north.x, north.y));
        least = std::min(least, degrees);
        most = std::max(most, degrees);
    }
    const auto rounded = [](double degrees) { return numberText(std::round(100.0 * degrees) / 100.0); };
    return rounded(least) + " to " + rounded(most) + " degrees clockwise";
}

} // namespace

std::optional<std::string> turnFromTrueNorth(GridWind::Grid& grid, const Crs& map, bool asStored) {
    std::vector<glm::dvec2> points;
    for (int y = 0; y < grid.points.y; ++y)
        for (int x = 0; x < grid.points.x; ++x)
            points.emplace_back(grid.origin.x + grid.cell.x * x, grid.origin.y + grid.cell.y * y);
    const std::vector<glm::dvec2> norths = trueNorth(map, points);
    if (norths.empty())
        return std::nullopt;
    for (std::size_t i = 0; !asStored && i < grid.values.size(); i += 3) {
        const glm::dvec2 north = norths[i / 3 % norths.size()];
        const double u = grid.values[i], v = grid.values[i + 1];
        grid.values[i] = static_cast<float>(u * north.y + v * north.x);
        grid.values[i + 1] = static_cast<float>(v * north.y - u * north.x);
    }
    return "the file counts from true north; " +
           std::string(asStored ? "in a forest its velocities" : "velocities here") +
           " are turned to the grid's y axis, by " + rangeOf(norths);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/VtkImage.h>

#include <glm/common.hpp>

#include <osgTreeWind/wind/GustyWind.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace osgTreeWind {

glm::ivec3 VtkImage::vectorCounts() const {
    return ofCells ? glm::max(points - 1, glm::ivec3(1)) : points;
}

std::string VtkImage::normalizeSpacing() {
    for (int axis = 0; axis < 3; ++axis)
        if (points[axis] == 1)
            spacing[axis] = 1.0;
        else if (!(spacing[axis] >= 1e-6))
            return "expected metres above 0 between points";
    return {};
}

double VtkImage::vectorCount() const {
    const glm::dvec3 n(vectorCounts());
    return n.x * n.y * n.z;
}

bool isTurbulentEnergy(std::string_view name) {
    return name == "k" || name == "tke" || name == "TKE";
}

WindContent windFromVtk(VtkImage&& image, const std::string& format) {
    GridWind::Grid grid;
    grid.points = image.vectorCounts();
    grid.cell = image.spacing;
    grid.origin = image.origin;
    for (int axis = 0; image.ofCells && axis < 3; ++axis)
        if (image.points[axis] > 1)
            grid.origin[axis] += 0.5 * image.spacing[axis];
    for (std::size_t i = 0; i < image.levels.size(); ++i)
        if (!image.ofCells)
            grid.heights.push_back(image.levels[i]);
        else if (i > 0)
            grid.heights.push_back(0.5f * (image.levels[i - 1] + image.levels[i]));
    grid.values = std::move(image.values);
    // the energy of gusts whose deviation along the wind is 1 m/s
    const float energyOfUnit = 0.5f * glm::dot(gustDeviations, gustDeviations);
    for (const float energy : image.energy)
        grid.deviations.push_back(energy > 0.0f ? std::sqrt(energy / energyOfUnit) : 0.0f);
    if (image.time)
        grid.times = {*image.time};
    WindContent content;
    content.summary.format = format;
    content.summary.mayIncludeTrees = true;
    content.summary.direction = "components toward x, y and z, taken as east, north and up";
    content.summary.notes = {std::string(image.ofCells ? "cell" : "point") + " vectors '" + image.name + "'"};
    content.data = std::move(grid);
    return content;
}

} // namespace osgTreeWind

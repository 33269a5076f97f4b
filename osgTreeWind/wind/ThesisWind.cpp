// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/ThesisWind.h>

#include <osgTreeWind/model/ThesisAxes.h>

#include <cmath>

namespace osgTreeWind {

namespace {

/// The cell of a coordinate, clamped to the first and the last; NaN gives the first.
std::size_t cellAt(double coordinate, int cells) {
    if (!(coordinate > 0.0))
        return 0;
    if (coordinate >= cells)
        return static_cast<std::size_t>(cells - 1);
    return static_cast<std::size_t>(std::floor(coordinate));
}

} // namespace

glm::vec3 ThesisWind::velocity(const WindPlace& place, double) const {
    const glm::vec3 at = toThesis(glm::vec3(glm::dvec3(place.position) - _array.origin));
    const std::size_t windIndex =
        (cellAt(at.x, _array.width) + cellAt(at.z, _array.length) * static_cast<std::size_t>(_array.width)) *
        3;
    return fromThesis(
        glm::vec3(_array.values[windIndex], _array.values[windIndex + 1], _array.values[windIndex + 2]));
}

} // namespace osgTreeWind

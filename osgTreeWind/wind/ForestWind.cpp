// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/ForestWind.h>

#include <osgTreeWind/model/ThesisAxes.h>

#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

/// The cell a coordinate falls into, held at the first and the last; NaN gives the first.
std::size_t cellAt(double coordinate, int cells) {
    if (!(coordinate > 0.0))
        return 0;
    if (coordinate >= cells)
        return static_cast<std::size_t>(cells - 1);
    return static_cast<std::size_t>(std::floor(coordinate));
}

} // namespace

ForestWind::ForestWind(int width, int length, std::vector<float> values, const glm::dvec3& origin)
    : _width(width), _length(length), _values(std::move(values)), _origin(origin) {}

glm::vec3 ForestWind::velocity(const WindPlace& place, double) const {
    const glm::vec3 at = toThesis(glm::vec3(glm::dvec3(place.position) - _origin));
    const std::size_t windIndex =
        (cellAt(at.x, _width) + cellAt(at.z, _length) * static_cast<std::size_t>(_width)) * 3;
    return fromThesis(glm::vec3(_values[windIndex], _values[windIndex + 1], _values[windIndex + 2]));
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanMeasures.h>

#include <osgTreeWind/base/Number.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

std::string endAlong(const glm::dvec3& axis, double length, ScanCylinder& cylinder) {
    const double size = glm::length(axis);
    if (!(size >= 0.9 && size <= 1.1))
        return "expected a direction of length 1, found one of " + numberText(size);
    cylinder.end = cylinder.start + axis * (length / size);
    return {};
}

} // namespace osgTreeWind

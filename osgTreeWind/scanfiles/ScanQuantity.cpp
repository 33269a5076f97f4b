// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanQuantity.h>

#include <osgTreeWind/base/Number.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

std::string setEndFromAxis(const glm::dvec3& axis, double length, ScanCylinder& cylinder) {
    const double norm = glm::length(axis);
    if (!(norm >= 0.9 && norm <= 1.1))
        return "expected a unit vector, found one of length " + numberText(norm);
    cylinder.end = cylinder.start + axis * (length / norm);
    return {};
}

} // namespace osgTreeWind
